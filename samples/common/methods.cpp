// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "common/methods.hpp"

#include <algorithm>
#include <ctime>

#include <opencv2/gmlpnp.hpp>

namespace samples {

namespace {

//! CPU time of the calling thread: what else the machine does meanwhile does not count.
double threadMicroseconds()
{
#ifdef CLOCK_THREAD_CPUTIME_ID
    timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
#else
    return 1e6 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
#endif
}

double median(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

//! The points relative to their centroid. With map coordinates of 1e6 m OpenCV's ITERATIVE is off by kilometres; all
//! methods get the same points, so that the table compares estimators and not their rounding.
std::vector<cv::Point3d> centred(std::vector<cv::Point3d> points, cv::Point3d& centroid)
{
    centroid = cv::Point3d();
    for (const cv::Point3d& p : points)
        centroid += p / static_cast<double>(points.size());
    for (cv::Point3d& p : points)
        p -= centroid;
    return points;
}

}  // namespace

const std::vector<Method>& allMethods()
{
    static const std::vector<Method> methods = {
        {"EPNP", cv::gmlpnp::SOLVEPNP_EPNP},
        {"ITERATIVE", cv::gmlpnp::SOLVEPNP_ITERATIVE},
        {"SQPNP", cv::gmlpnp::SOLVEPNP_SQPNP},
        {"GMLPNP", cv::gmlpnp::SOLVEPNP_GMLPNP},
        {"GMLPNP_MARGINAL", cv::gmlpnp::SOLVEPNP_GMLPNP_MARGINAL},
    };
    return methods;
}

Estimate estimatePose(const CorrespondenceSet& set, const Method& method, int repeat)
{
    cv::Point3d centroid;
    const std::vector<cv::Point3d> points = centred(set.objectPoints, centroid);
    Estimate estimate;
    std::vector<double> times;
    try {
        for (int i = 0; i < repeat; ++i) {
            const double start = threadMicroseconds();
            estimate.solved = cv::gmlpnp::solvePnP(points, set.imagePoints, set.cameraMatrix, set.distCoeffs,
                                                   estimate.rvec, estimate.tvec, false, method.flag);
            times.push_back(threadMicroseconds() - start);
        }
    } catch (const cv::Exception&) {
        // ITERATIVE throws for fewer than six points; the table then says that it did not solve.
        estimate.solved = false;
    }
    if (estimate.solved) {
        estimate.microseconds = median(times);
        estimate.tvec -= estimate.pose().R * cv::Vec3d(centroid);
    }
    return estimate;
}

}  // namespace samples
