// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "common/pixel_matches.hpp"

#include <cmath>
#include <fstream>
#include <locale>
#include <sstream>
#include <stdexcept>

#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

namespace samples {

namespace {

//! No features this near to where a picture shows nothing: its edge is no feature, px.
constexpr int kMaskMargin = 8;

//! cv::SIFT doubles the picture about the corner of its first pixel and halves coordinates about its centre, so all its
//! points lie this far to the right and down, px. Between pictures that are turned against each other it adds up.
const cv::Point2f kSiftShift(0.25f, 0.25f);

}  // namespace

PixelMatches readMatches(const std::string& path)
{
    std::ifstream stream(path);
    if (!stream.is_open())
        throw std::runtime_error(path + ": cannot be opened");
    PixelMatches matches;
    int number = 0;
    for (std::string line; std::getline(stream, line);) {
        ++number;
        std::istringstream row(line.substr(0, line.find('#')));
        row.imbue(std::locale::classic());
        if ((row >> std::ws).eof())
            continue;
        cv::Point2d a, b;
        if (!(row >> a.x >> a.y >> b.x >> b.y))
            throw std::runtime_error(path + ":" + std::to_string(number) + ": expected u v u' v'");
        matches.reference.push_back(a);
        matches.query.push_back(b);
    }
    return matches;
}

SiftFeatures siftFeatures(const cv::Mat& picture, const cv::Mat& mask, int count)
{
    cv::Mat inner;
    if (!mask.empty())
        cv::erode(mask, inner, cv::Mat::ones(2 * kMaskMargin + 1, 2 * kMaskMargin + 1, CV_8U));
    SiftFeatures features;
    cv::SIFT::create(count)->detectAndCompute(picture, inner, features.points, features.descriptors);
    for (cv::KeyPoint& point : features.points)
        point.pt -= kSiftShift;
    return features;
}

PixelMatches matchSift(const SiftFeatures& reference, const SiftFeatures& query, double ratio)
{
    PixelMatches matches;
    if (reference.descriptors.rows < 2 || query.descriptors.rows < 2)
        return matches;
    std::vector<std::vector<cv::DMatch>> candidates;
    cv::BFMatcher(cv::NORM_L2).knnMatch(query.descriptors, reference.descriptors, candidates, 2);
    for (const auto& two : candidates)
        if (static_cast<double>(two[0].distance) < ratio * static_cast<double>(two[1].distance)) {
            matches.query.push_back(query.points[static_cast<size_t>(two[0].queryIdx)].pt);
            matches.reference.push_back(reference.points[static_cast<size_t>(two[0].trainIdx)].pt);
        }
    return matches;
}

}  // namespace samples
