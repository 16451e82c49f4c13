// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_TEST_LENSES_KITTI360_HPP
#define GMLPNP_TEST_LENSES_KITTI360_HPP

#include <string>
#include <vector>

#include "common/pose.hpp"

// A few frames of KITTI-360 (Liao et al. 2022): rectified photographs of camera 00, raw LiDAR points, calibration.

namespace kitti360 {

using samples::Pose;

constexpr int kFirstFrame = 3000, kLastFrame = 3012;

//! Whether the data are there.
bool isPresent();

//! Of the rectified camera 00, px.
cv::Matx33d cameraMatrix();

//! The calibration file of a fisheye camera, "02" or "03".
std::string fisheyeFile(const std::string& camera);

//! Grey.
cv::Mat photograph(int frame);

//! LiDAR points of a frame in the frame of the rectified camera 00, m.
std::vector<cv::Point3d> lidarPoints(int frame);

//! The rectified camera 00 of the next frame from that of this one, by LiDAR ICP: 1 to 3 cm.
Pose motion(int frame);

}  // namespace kitti360

#endif  // GMLPNP_TEST_LENSES_KITTI360_HPP
