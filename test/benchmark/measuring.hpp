// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_BENCHMARK_MEASURING_HPP
#define GMLPNP_BENCHMARK_MEASURING_HPP

#include <opencv2/core.hpp>

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <vector>

// What the benchmarks share.

inline cv::Matx33d randomRotation(cv::RNG& rng)
{
    // A Gaussian quaternion has no preferred direction.
    cv::Vec4d q(rng.gaussian(1), rng.gaussian(1), rng.gaussian(1), rng.gaussian(1));
    q /= cv::norm(q);
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    return cv::Matx33d(1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y),  //
                       2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x),  //
                       2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y));
}

inline double threadSeconds()
{
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

inline double median(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

#endif  // GMLPNP_BENCHMARK_MEASURING_HPP
