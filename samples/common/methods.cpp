// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "common/methods.hpp"

#include <ctime>

#include <opencv2/gmlpnp.hpp>

#include "common/statistics.hpp"

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

//! What OpenCV's methods are given: pixels with their camera matrix, or rays on the plane z = 1.
struct Picture
{
    std::vector<cv::Point2d> pixels;
    cv::Matx33d cameraMatrix = cv::Matx33d::eye();
    std::vector<double> distCoeffs;
};

bool picture(const CorrespondenceSet& set, Picture& seen)
{
    if (!set.lens) {
        seen = {set.imagePoints, set.cameraMatrix, set.distCoeffs};
        return true;
    }
    for (const cv::Point2d& pixel : set.imagePoints) {
        cv::Vec3d ray;
        if (!set.lens->unprojectPoint(pixel, ray) || !(ray[2] > 0.0))
            return false;
        seen.pixels.emplace_back(ray[0] / ray[2], ray[1] / ray[2]);
    }
    return true;
}

cv::gmlpnp::Params paramsOf(const Method& method)
{
    cv::gmlpnp::Params params;
    params.method = method.flag;
    if (method.variant == Variant::kPlain)
        return params;
    // Only the shape of known noise matters, not its size: the tails, which would depend on it, are off.
    const cv::Mat one = cv::Mat::eye(3, 3, CV_64F), none = cv::Mat::zeros(3, 3, CV_64F);
    const bool object = method.variant == Variant::kIsotropicObject;
    params.objectNoise = object ? one : none;
    params.bearingNoise = object ? none : one;
    params.robust = false;
    return params;
}

bool solveByOpenCV(const CorrespondenceSet& set, const std::vector<cv::Point3d>& points, const Method& method,
                   Estimate& estimate)
{
    Picture seen;
    if (!picture(set, seen) || !cv::gmlpnp::solvePnP(points, seen.pixels, seen.cameraMatrix, seen.distCoeffs,
                                                     estimate.rvec, estimate.tvec, false, method.flag))
        return false;
    if (method.variant == Variant::kRefineLM)
        cv::gmlpnp::solvePnPRefineLM(points, seen.pixels, seen.cameraMatrix, seen.distCoeffs, estimate.rvec,
                                     estimate.tvec);
    return true;
}

bool solveOnce(const CorrespondenceSet& set, const std::vector<cv::Point3d>& points, const Method& method,
               Estimate& estimate)
{
    if (method.flag < cv::gmlpnp::SOLVEPNP_GMLPNP)
        return solveByOpenCV(set, points, method, estimate);
    if (!set.lens && method.variant == Variant::kPlain)
        return cv::gmlpnp::solvePnP(points, set.imagePoints, set.cameraMatrix, set.distCoeffs, estimate.rvec,
                                    estimate.tvec, false, method.flag);
    cv::gmlpnp::Result result;
    const bool solved = cv::gmlpnp::solve(points, set.imagePoints, set.camera(), result, paramsOf(method));
    estimate.rvec = result.rvec;
    estimate.tvec = result.tvec;
    return solved;
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

const std::vector<Method>& comparedMethods()
{
    const int own = cv::gmlpnp::SOLVEPNP_GMLPNP_MARGINAL;
    static const std::vector<Method> methods = {
        {"EPNP", cv::gmlpnp::SOLVEPNP_EPNP},           {"ITERATIVE", cv::gmlpnp::SOLVEPNP_ITERATIVE},
        {"SQPNP", cv::gmlpnp::SOLVEPNP_SQPNP},         {"SQPNP+LM", cv::gmlpnp::SOLVEPNP_SQPNP, Variant::kRefineLM},
        {"ISOTROPIC", own, Variant::kIsotropicObject}, {"BEARING", own, Variant::kIsotropicBearing},
        {"GMLPNP", cv::gmlpnp::SOLVEPNP_GMLPNP},       {"GMLPNP_MARGINAL", own},
    };
    return methods;
}

bool isOwn(const Method& method)
{
    return method.flag >= cv::gmlpnp::SOLVEPNP_GMLPNP && method.variant == Variant::kPlain;
}

Estimate estimatePose(const CorrespondenceSet& set, const Method& method, int repeat)
{
    // All methods get the same points, so that a table compares estimators and not their rounding.
    cv::Point3d centroid;
    const std::vector<cv::Point3d> points = centred(set.objectPoints, centroid);
    Estimate estimate;
    std::vector<double> times;
    try {
        for (int i = 0; i < repeat; ++i) {
            const double start = threadMicroseconds();
            estimate.solved = solveOnce(set, points, method, estimate);
            times.push_back(threadMicroseconds() - start);
        }
    } catch (const cv::Exception&) {
        // ITERATIVE throws for fewer than six points; the table then says that it did not solve.
        estimate.solved = false;
    }
    estimate.solved = estimate.solved && cv::checkRange(estimate.rvec) && cv::checkRange(estimate.tvec);
    if (estimate.solved) {
        estimate.microseconds = median(times);
        estimate.tvec -= estimate.pose().R * cv::Vec3d(centroid);
    }
    return estimate;
}

}  // namespace samples
