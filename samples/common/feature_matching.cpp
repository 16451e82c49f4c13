// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "common/feature_matching.hpp"

#include <opencv2/features2d.hpp>
#include <opencv2/gmlpnp/compat.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "common/images.hpp"
#include "common/outliers.hpp"

namespace samples {

namespace {

struct Features
{
    std::vector<cv::KeyPoint> keypoints;
    cv::Mat descriptors;
};

Features detect(const cv::Mat& image, int count)
{
    Features features;
    cv::ORB::create(count)->detectAndCompute(image, cv::noArray(), features.keypoints, features.descriptors);
    return features;
}

std::vector<cv::DMatch> matchMutually(const Features& first, const Features& second)
{
    std::vector<cv::DMatch> matches;
    if (!first.descriptors.empty() && !second.descriptors.empty())
        cv::BFMatcher(cv::NORM_HAMMING, true).match(first.descriptors, second.descriptors, matches);
    return matches;
}

//! Fills the points and pixels of those matches whose first pixel has a depth.
void lift(const Features& first, const Features& second, const cv::Mat& depth, CorrespondenceSet& set)
{
    for (const cv::DMatch& match : matchMutually(first, second)) {
        const cv::Point2f pixel = first.keypoints[static_cast<size_t>(match.queryIdx)].pt;
        const double z = depthAt(depth, pixel);
        if (z <= 0.0)
            continue;
        std::vector<cv::Point2d> normalised;
        cv::undistortPoints(std::vector<cv::Point2d>{pixel}, normalised, set.cameraMatrix, set.distCoeffs);
        set.objectPoints.emplace_back(z * normalised[0].x, z * normalised[0].y, z);
        set.imagePoints.push_back(second.keypoints[static_cast<size_t>(match.trainIdx)].pt);
    }
}

}  // namespace

CorrespondenceSet matchFrames(const TumSequence& sequence, const FramePair& pair, const MatchingOptions& options)
{
    const RgbdFrame &first = sequence.frames[pair.first], &second = sequence.frames[pair.second];
    const cv::Mat firstImage = readImage(first.colourFile, cv::IMREAD_GRAYSCALE);
    const cv::Mat secondImage = readImage(second.colourFile, cv::IMREAD_GRAYSCALE);
    CorrespondenceSet set;
    set.cameraMatrix = options.cameraMatrix;
    set.distCoeffs = options.distCoeffs;
    set.imageSize = secondImage.size();
    set.unit = "m";
    set.hasTruth = true;
    set.truth = pair.secondFromFirst;
    lift(detect(firstImage, options.features), detect(secondImage, options.features), readDepthImage(first.depthFile),
         set);
    rejectOutliers(set, options.ransacPixels, options.seed);
    requireMatches(set, first.colourFile, second.colourFile);
    return set;
}

}  // namespace samples
