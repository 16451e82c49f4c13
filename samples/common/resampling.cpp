// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "common/resampling.hpp"

#include <opencv2/imgproc.hpp>

namespace samples {

namespace {

constexpr int kOversampling = 2;  // against aliasing
constexpr float kNowhere = -1e4f;

}  // namespace

Resampling::Resampling(const cv::gmlpnp::CameraModel& source, cv::Size sourceSize,
                       const cv::gmlpnp::CameraModel& target, cv::Size targetSize, const cv::Matx33d& targetFromSource)
    : map_(targetSize * kOversampling, CV_32FC2)
{
    for (int v = 0; v < map_.rows; ++v)
        for (int u = 0; u < map_.cols; ++u) {
            const cv::Point2d pixel((u + 0.5) / kOversampling - 0.5, (v + 0.5) / kOversampling - 0.5);
            cv::Vec3d ray;
            cv::Point2d place;
            const bool seen =
                target.unprojectPoint(pixel, ray) && source.projectPoint(targetFromSource.t() * ray, place);
            map_.at<cv::Vec2f>(v, u) = seen ? cv::Vec2f(static_cast<float>(place.x), static_cast<float>(place.y))
                                            : cv::Vec2f(kNowhere, kNowhere);
        }
    mask_ = (*this)(cv::Mat(sourceSize, CV_8U, cv::Scalar(255))) == 255;
}

cv::Mat Resampling::operator()(const cv::Mat& photograph) const
{
    cv::Mat large, picture;
    cv::remap(photograph, large, map_, cv::noArray(), cv::INTER_CUBIC);
    cv::resize(large, picture, cv::Size(), 1.0 / kOversampling, 1.0 / kOversampling, cv::INTER_AREA);
    return picture;
}

}  // namespace samples
