// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "common/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <opencv2/core.hpp>

namespace samples {

namespace {

constexpr int kResamples = 10000;
constexpr double kNormalQuantile = 1.959963985;  // 97.5 %

//! 97.5 % of Student's t, by its expansion about the normal quantile: to 1 % from three degrees of freedom on.
double studentQuantile(double degreesOfFreedom)
{
    const double z = kNormalQuantile, v = degreesOfFreedom, z2 = z * z;
    return z * (1.0 + (z2 + 1.0) / (4.0 * v) + (5.0 * z2 * z2 + 16.0 * z2 + 3.0) / (96.0 * v * v) +
                (3.0 * z2 * z2 * z2 + 19.0 * z2 * z2 + 17.0 * z2 - 15.0) / (384.0 * v * v * v));
}

//! The mean of blocks of neighbours, drawn with replacement, the series closed to a ring.
double resampledMean(const std::vector<double>& values, size_t block, cv::RNG& random)
{
    const size_t n = values.size();
    double sum = 0.0;
    for (size_t taken = 0; taken < n; taken += block) {
        const size_t start = static_cast<size_t>(random.uniform(0, static_cast<int>(n)));
        for (size_t k = 0; k < std::min(block, n - taken); ++k)
            sum += values[(start + k) % n];
    }
    return sum / static_cast<double>(n);
}

}  // namespace

double mean(const std::vector<double>& values)
{
    double sum = 0.0;
    for (const double value : values)
        sum += value;
    return values.empty() ? std::numeric_limits<double>::quiet_NaN() : sum / static_cast<double>(values.size());
}

double median(std::vector<double> values)
{
    if (values.empty())
        return std::numeric_limits<double>::quiet_NaN();
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

Interval bootstrapMean(const std::vector<double>& values, uint64_t seed)
{
    const double n = static_cast<double>(values.size());
    if (values.size() < 3)
        return {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
    const size_t block = static_cast<size_t>(std::lround(std::cbrt(n)));
    cv::RNG random(seed);
    std::vector<double> means;
    for (int i = 0; i < kResamples; ++i)
        means.push_back(resampledMean(values, block, random));
    std::sort(means.begin(), means.end());
    const double centre = mean(values), spread = studentQuantile(n - 1.0) / kNormalQuantile * std::sqrt(n / (n - 1.0));
    const auto quantile = [&](double share) {
        return centre + spread * (means[static_cast<size_t>(std::lround(share * (kResamples - 1)))] - centre);
    };
    return {quantile(0.025), quantile(0.975)};
}

}  // namespace samples
