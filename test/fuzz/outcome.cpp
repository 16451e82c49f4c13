// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "outcome.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "fuzzed_arguments.hpp"

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

// Nothing where the noise was given.
void requireErrors(const cv::Mat& m, const char* promise)
{
    require(m.empty() || (m.rows == 3 && m.cols == 3 && m.type() == CV_64F), promise);
    require(m.empty() || cv::checkRange(m, true, nullptr, 0, DBL_MAX), promise);
}

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

namespace {

// Of a Result or a const one.
template <class R>
auto matricesOf(R& r)
{
    return std::array{&r.poseCovariance, &r.poseCovarianceRt,  &r.cameraCenterCovariance, &r.objectNoise,
                      &r.bearingNoise,   &r.objectNoiseStdErr, &r.bearingNoiseStdErr,     &r.weights};
}

cv::Mat numbersOf(const Result& r)
{
    std::vector<double> all = {r.cost, r.noiseEvidence, r.poseEvidence, r.tailShare, r.tailDof};
    for (const int number : {r.status, r.rounds, r.objectNoiseRank, r.noiseModel, r.usedPoints})
        all.push_back(number);
    for (const cv::Vec3d& v : {r.rvec, r.tvec, r.cameraCenter})
        all.insert(all.end(), v.val, v.val + 3);
    return cv::Mat(all, true);
}

}  // namespace

Result untouchedResult()
{
    Result result;
    for (int* number :
         {&result.status, &result.rounds, &result.objectNoiseRank, &result.noiseModel, &result.usedPoints})
        *number = -7;
    for (double* number :
         {&result.cost, &result.noiseEvidence, &result.poseEvidence, &result.tailShare, &result.tailDof})
        *number = -7;
    result.rvec = result.tvec = result.cameraCenter = cv::Vec3d::all(-7);
    for (cv::Mat* m : matricesOf(result))
        *m = cv::Mat(1, 1, CV_64F, cv::Scalar(-7));
    return result;
}

bool same(const Result& a, const Result& b)
{
    const auto ofA = matricesOf(a), ofB = matricesOf(b);
    return sameBits(numbersOf(a), numbersOf(b)) &&
           std::equal(ofA.begin(), ofA.end(), ofB.begin(),
                      [](const cv::Mat* m, const cv::Mat* n) { return sameBits(*m, *n); });
}

bool untouched(const Result& result)
{
    Result marked = untouchedResult();
    marked.status = result.status;
    return same(result, marked);
}

void requireSound(const Result& result)
{
    require(result.status == cv::gmlpnp::STATUS_CONVERGED || result.status == cv::gmlpnp::STATUS_MAX_ROUNDS,
            "the status of a success");
    require(finite(result.rvec) && finite(result.tvec) && finite(result.cameraCenter), "a finite pose");
    require(cv::norm(result.rvec) <= CV_PI + 1e-9, "a rotation vector within pi");
    require(std::isfinite(result.cost), "a finite cost");
    require(result.rounds >= 0, "rounds");
    require(!(result.tailDof <= 0) && !(result.noiseEvidence < 0) && !std::isnan(result.poseEvidence),
            "degrees of freedom and evidence");
    require(result.weights.cols == 1 && finite(result.weights), "weights");
    require(result.usedPoints >= 3 && result.usedPoints <= result.weights.rows, "points that were used");
    requireCovariance(result.objectNoise, 3, "object noise", OF_KNOWN_NOISE);
    requireCovariance(result.bearingNoise, 3, "bearing noise", OF_KNOWN_NOISE);
    requireErrors(result.objectNoiseStdErr, "errors of the object noise");
    requireErrors(result.bearingNoiseStdErr, "errors of the bearing noise");
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
