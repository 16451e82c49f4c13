// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "outcome.hpp"

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace fuzz {

using cv::gmlpnp::Result;

namespace {

bool finite(const cv::Mat& m)
{
    return cv::checkRange(m, true, nullptr, -DBL_MAX, DBL_MAX);
}

bool finite(const cv::Vec3d& v)
{
    return finite(cv::Mat(v));
}

// A known noise goes back as it came, which may be positive semidefinite to its own rounding only.
constexpr double OF_KNOWN_NOISE = 1e-6;

void requireCovariance(const cv::Mat& m, int size, const char* promise, double rounding = 0)
{
    require(m.rows == size && m.cols == size && m.type() == CV_64F && finite(m), promise);
    for (int i = 0; i < size; ++i) {
        require(m.at<double>(i, i) >= -rounding * cv::norm(m, cv::NORM_INF), promise);
        for (int j = 0; j < i; ++j)
            require(std::abs(m.at<double>(i, j) - m.at<double>(j, i)) <=
                        1e-6 * std::sqrt(std::abs(m.at<double>(i, i))) * std::sqrt(std::abs(m.at<double>(j, j))),
                    promise);
    }
}

}  // namespace

void require(bool holds, const char* promise)
{
    if (holds)
        return;
    std::fprintf(stderr, "not kept: %s\n", promise);
    std::abort();
}

Result untouchedResult()
{
    Result result;
    result.status = -7;
    result.rounds = -7;
    result.cost = -7;
    result.rvec = result.tvec = result.cameraCenter = cv::Vec3d::all(-7);
    for (cv::Mat* m : {&result.poseCovariance, &result.poseCovarianceRt, &result.cameraCenterCovariance,
                       &result.objectNoise, &result.bearingNoise, &result.weights})
        *m = cv::Mat(1, 1, CV_64F, cv::Scalar(-7));
    result.objectNoiseRank = result.noiseModel = result.usedPoints = -7;
    result.noiseEvidence = result.tailShare = result.tailDof = -7;
    return result;
}

bool untouched(const Result& result)
{
    for (const cv::Mat* m : {&result.poseCovariance, &result.poseCovarianceRt, &result.cameraCenterCovariance,
                             &result.objectNoise, &result.bearingNoise, &result.weights})
        if (m->total() != 1 || m->type() != CV_64F || m->at<double>(0) != -7)
            return false;
    const cv::Vec3d mark = cv::Vec3d::all(-7);
    return result.rounds == -7 && result.cost == -7 && result.rvec == mark && result.tvec == mark &&
           result.cameraCenter == mark && result.objectNoiseRank == -7 && result.noiseModel == -7 &&
           result.usedPoints == -7 && result.noiseEvidence == -7 && result.tailShare == -7 && result.tailDof == -7;
}

void requireSound(const Result& result)
{
    require(result.status == cv::gmlpnp::STATUS_CONVERGED || result.status == cv::gmlpnp::STATUS_MAX_ROUNDS,
            "the status of a success");
    require(finite(result.rvec) && finite(result.tvec) && finite(result.cameraCenter), "a finite pose");
    require(cv::norm(result.rvec) <= CV_PI + 1e-9, "a rotation vector within pi");
    require(std::isfinite(result.cost), "a finite cost");
    require(result.rounds >= 0, "rounds");
    require(!(result.tailDof <= 0) && !(result.noiseEvidence < 0), "degrees of freedom and evidence");
    require(result.weights.cols == 1 && finite(result.weights), "weights");
    require(result.usedPoints >= 3 && result.usedPoints <= result.weights.rows, "points that were used");
    requireCovariance(result.objectNoise, 3, "object noise", OF_KNOWN_NOISE);
    requireCovariance(result.bearingNoise, 3, "bearing noise", OF_KNOWN_NOISE);
    if (result.poseCovariance.empty())
        return;
    requireCovariance(result.poseCovariance, 6, "covariance of the pose");
    requireCovariance(result.poseCovarianceRt, 6, "covariance of rvec and tvec");
    requireCovariance(result.cameraCenterCovariance, 3, "covariance of the camera's centre");
}

void requireInliers(const std::vector<int>& inliers, int points)
{
    require(inliers.size() >= 4, "four inliers");
    require(inliers.front() >= 0 && inliers.back() < points, "inliers that are rows");
    for (size_t i = 1; i < inliers.size(); ++i)
        require(inliers[i - 1] < inliers[i], "ascending inliers");
}

}  // namespace fuzz
