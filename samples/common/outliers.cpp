// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "common/outliers.hpp"

#include <opencv2/gmlpnp.hpp>

namespace samples {

namespace {

constexpr int kRansacIterations = 1000;
constexpr double kRansacConfidence = 0.999;
constexpr int kTrimmingRounds = 5;
constexpr size_t kFewestAgreeing = 10;

std::vector<int> consensus(const CorrespondenceSet& set, double thresholdPixels, int seed)
{
    cv::setRNGSeed(seed);
    cv::Point3d centroid;
    const std::vector<cv::Point3d> points = centred(set.objectPoints, centroid);
    cv::Vec3d rvec, tvec;
    std::vector<int> inliers;
    cv::solvePnPRansac(points, set.imagePoints, set.cameraMatrix, set.distCoeffs, rvec, tvec, false, kRansacIterations,
                       static_cast<float>(thresholdPixels), kRansacConfidence, inliers, cv::SOLVEPNP_EPNP);
    return inliers;
}

void keep(const std::vector<int>& indices, CorrespondenceSet& set)
{
    std::vector<cv::Point3d> points;
    std::vector<cv::Point2d> pixels;
    for (const int i : indices) {
        points.push_back(set.objectPoints[static_cast<size_t>(i)]);
        pixels.push_back(set.imagePoints[static_cast<size_t>(i)]);
    }
    set.objectPoints = points;
    set.imagePoints = pixels;
}

std::vector<int> explained(const CorrespondenceSet& set, const cv::gmlpnp::Result& result, double thresholdPixels)
{
    const Pose pose = poseFromRotationVector(result.rvec, result.tvec);
    std::vector<int> indices;
    for (size_t i = 0; i < set.objectPoints.size(); ++i) {
        cv::Point2d pixel;
        if (set.lens->projectPoint(pose * cv::Vec3d(set.objectPoints[i]), pixel) &&
            cv::norm(pixel - set.imagePoints[i]) < thresholdPixels)
            indices.push_back(static_cast<int>(i));
    }
    return indices;
}

std::vector<int> trimmed(const CorrespondenceSet& set, double thresholdPixels)
{
    CorrespondenceSet used = set;
    std::vector<int> inliers;
    for (int round = 0; round < kTrimmingRounds; ++round) {
        cv::gmlpnp::Result result;
        if (!cv::gmlpnp::solve(used.objectPoints, used.imagePoints, used.lens, result))
            return {};
        inliers = explained(set, result, thresholdPixels);
        used = set;
        keep(inliers, used);
    }
    return inliers;
}

}  // namespace

void rejectOutliers(CorrespondenceSet& set, double thresholdPixels, int seed)
{
    if (thresholdPixels <= 0.0 || set.objectPoints.size() < kMinCorrespondences)
        return;
    std::vector<int> agreeing = set.lens ? trimmed(set, thresholdPixels) : consensus(set, thresholdPixels, seed);
    if (agreeing.size() < kFewestAgreeing)
        agreeing.clear();
    keep(agreeing, set);
}

}  // namespace samples
