// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "common/lidar_tracking.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <iterator>

#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

namespace samples {

namespace {

bool isSeen(const cv::Mat& mask, const cv::Point2d& pixel)
{
    const cv::Point nearest(cvRound(pixel.x), cvRound(pixel.y));
    return cv::Rect(cv::Point(), mask.size()).contains(nearest) && mask.at<uchar>(nearest) != 0;
}

//! Follows pixels through the pictures; 0 in `found` where one is lost on the way.
template <typename Iterator>
std::vector<cv::Point2f> follow(std::vector<cv::Point2f> pixels, Iterator picture, Iterator end,
                                const TrackingOptions& options, std::vector<uchar>& found)
{
    const cv::Size window(options.window, options.window);
    for (; std::next(picture) != end; ++picture) {
        std::vector<cv::Point2f> next;
        std::vector<uchar> foundNext;
        cv::calcOpticalFlowPyrLK(*picture, *std::next(picture), pixels, next, foundNext, cv::noArray(), window,
                                 options.levels);
        for (size_t i = 0; i < pixels.size(); ++i)
            found[i] = static_cast<uchar>(found[i] & foundNext[i]);
        pixels = next;
    }
    return pixels;
}

}  // namespace

cv::Mat shrunkMask(const cv::Mat& mask, int margin)
{
    cv::Mat shrunk;
    cv::erode(mask, shrunk, cv::Mat::ones(2 * margin + 1, 2 * margin + 1, CV_8U), cv::Point(-1, -1), 1,
              cv::BORDER_CONSTANT, cv::Scalar(0));
    return shrunk;
}

cv::Mat seenPixels(const cv::gmlpnp::CameraModel& lens, cv::Size picture, double fieldDegrees, int margin)
{
    const double least = std::cos(0.5 * fieldDegrees * CV_PI / 180.0);
    cv::Mat mask = cv::Mat::zeros(picture, CV_8U);
    for (int v = 0; v < picture.height; ++v)
        for (int u = 0; u < picture.width; ++u) {
            cv::Vec3d ray;
            if (lens.unprojectPoint(cv::Point2d(u, v), ray) && ray[2] >= least)
                mask.at<uchar>(v, u) = 255;
        }
    return shrunkMask(mask, margin);
}

std::vector<cv::Point3d> trackablePoints(const std::vector<cv::Point3d>& points, const cv::Mat& picture,
                                         const cv::gmlpnp::CameraModel& lens, const cv::Mat& mask,
                                         const TrackingOptions& options)
{
    cv::Mat contrast;
    cv::cornerMinEigenVal(picture, contrast, 9);
    const cv::Size cells(picture.cols / options.cell + 1, picture.rows / options.cell + 1);
    cv::Mat_<float> nearest(cells, FLT_MAX), best(cells, static_cast<float>(options.leastContrast));
    cv::Mat_<int> chosen(cells, -1);
    for (size_t i = 0; i < points.size(); ++i) {
        cv::Point2d pixel;
        if (!lens.projectPoint(points[i], pixel) || !isSeen(mask, pixel))
            continue;
        const cv::Point cell(static_cast<int>(pixel.x) / options.cell, static_cast<int>(pixel.y) / options.cell);
        const float here = contrast.at<float>(cv::Point(pixel));
        nearest(cell) = std::min(nearest(cell), static_cast<float>(cv::norm(points[i])));
        if (here > best(cell)) {
            best(cell) = here;
            chosen(cell) = static_cast<int>(i);
        }
    }
    cv::erode(nearest, nearest, cv::Mat::ones(3, 3, CV_8U));  // the nearest of the cells around
    std::vector<cv::Point3d> result;
    for (int y = 0; y < cells.height; ++y)
        for (int x = 0; x < cells.width; ++x)
            if (chosen(y, x) >= 0) {
                const cv::Point3d& point = points[static_cast<size_t>(chosen(y, x))];
                if (cv::norm(point) < options.hidden * nearest(y, x))
                    result.push_back(point);
            }
    return result;
}

Tracks trackPoints(const std::vector<cv::Point3d>& points, const std::vector<cv::Mat>& pictures,
                   const cv::gmlpnp::CameraModel& lens, const cv::Mat& mask, const TrackingOptions& options)
{
    Tracks tracks;
    if (points.empty())
        return tracks;
    cv::Mat projected;
    lens.project(points, projected);
    std::vector<cv::Point2f> start;
    projected.reshape(2).convertTo(start, CV_32F);
    std::vector<uchar> found(points.size(), 1);
    const auto end = follow(start, pictures.begin(), pictures.end(), options, found);
    const auto back = follow(end, pictures.rbegin(), pictures.rend(), options, found);
    for (size_t i = 0; i < points.size(); ++i) {
        if (!found[i] || cv::norm(start[i] - back[i]) > options.thereAndBack || !isSeen(mask, end[i]))
            continue;
        tracks.points.push_back(points[i]);
        tracks.pixels.push_back(end[i]);
    }
    return tracks;
}

}  // namespace samples
