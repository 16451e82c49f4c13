// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_SAMPLES_LIDAR_TRACKING_HPP
#define GMLPNP_SAMPLES_LIDAR_TRACKING_HPP

#include <vector>

#include <opencv2/gmlpnp/camera.hpp>

namespace samples {

/** How LiDAR points are chosen and tracked from one picture to the next. */
struct TrackingOptions
{
    int cell = 8;                 //!< px: at most one point in each square of this side
    double hidden = 1.3;          //!< times the distance of the nearest point around: not seen by the camera
    double leastContrast = 1e-3;  //!< smaller eigenvalue of the gradients, as cv::cornerMinEigenVal defines it
    double thereAndBack = 0.3;    //!< px: farther from where it began, tracked forward and backward, a track is lost
    int window = 21, levels = 5;  //!< of the pyramidal Lucas-Kanade tracker, px and steps of the pyramid
};

/** Where a lens sees: 8 bits, 255 for pixels whose ray is within half of `fieldDegrees` of the axis and that are more
than `margin` px from any other and from the border. */
cv::Mat seenPixels(const cv::gmlpnp::CameraModel& lens, cv::Size picture, double fieldDegrees, int margin);

//! A mask without what is nearer than `margin` px to the rest and to the border.
cv::Mat shrunkMask(const cv::Mat& mask, int margin);

/** Points, in the camera frame, that can be tracked: inside the mask, on textured surfaces, not hidden behind nearer
ones, one a cell. */
std::vector<cv::Point3d> trackablePoints(const std::vector<cv::Point3d>& points, const cv::Mat& picture,
                                         const cv::gmlpnp::CameraModel& lens, const cv::Mat& mask,
                                         const TrackingOptions& options);

struct Tracks
{
    std::vector<cv::Point3d> points;  //!< camera frame of the first picture
    std::vector<cv::Point2d> pixels;  //!< in the last picture
};

/** Projects the points into the first grey picture and finds them in the last, from picture to picture; those are kept
that come back to where they began and end inside the mask. */
Tracks trackPoints(const std::vector<cv::Point3d>& points, const std::vector<cv::Mat>& pictures,
                   const cv::gmlpnp::CameraModel& lens, const cv::Mat& mask, const TrackingOptions& options);

}  // namespace samples

#endif  // GMLPNP_SAMPLES_LIDAR_TRACKING_HPP
