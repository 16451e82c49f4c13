// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_SAMPLES_KITTI360_HPP
#define GMLPNP_SAMPLES_KITTI360_HPP

#include <map>
#include <string>
#include <vector>

#include <opencv2/gmlpnp/camera.hpp>

#include "common/pose.hpp"

namespace samples {

/** A camera of KITTI-360 (Liao et al. 2022): 00 and 01 are rectified pinholes, 02 and 03 fisheyes that look aside. */
struct KittiCamera
{
    std::string name;  //!< "00" to "03"
    bool isPinhole = false;
    cv::Matx33d cameraMatrix = cv::Matx33d::eye();  //!< of a pinhole, px
    cv::Ptr<cv::gmlpnp::CameraModel> lens;
    cv::Size size;     //!< of its pictures
    Pose fromLidar;    //!< the Velodyne's frame to the camera's
    Pose fromVehicle;  //!< the frame of data_poses to the camera's
};

/** Reads `root`/calibration: perspective.txt or image_0x.yaml, calib_cam_to_velo.txt and calib_cam_to_pose.txt.
@throws std::runtime_error, or cv::Exception for a lens, naming what is missing or malformed. */
KittiCamera readKittiCamera(const std::string& root, const std::string& name);

/** The same place looked at through another lens, its frame turned: for pictures made by Resampling. */
KittiCamera turnedCamera(const KittiCamera& place, const KittiCamera& lens, const cv::Matx33d& turn);

/** The drives that have pictures, by name. @throws std::runtime_error where there are none. */
std::vector<std::string> kittiDrives(const std::string& root);

//! The file of a picture.
std::string kittiPicture(const std::string& root, const std::string& drive, const KittiCamera& camera, int frame);

//! The file of a LiDAR scan.
std::string kittiScan(const std::string& root, const std::string& drive, int frame);

/** The frames of a drive that have a LiDAR scan, ascending. @throws std::runtime_error where there are none. */
std::vector<int> kittiFrames(const std::string& root, const std::string& drive);

/** A LiDAR scan in the camera's frame, m, without what is not finite. @throws std::runtime_error where it cannot be
 * read. */
std::vector<cv::Point3d> readScan(const std::string& path, const KittiCamera& camera);

/** True motion, by one of two files. */
struct KittiTruth
{
    std::map<int, Pose> worldFromVehicle;  //!< data_poses/<drive>/poses.txt
    std::map<int, Pose> lidarFromNext;     //!< a motion file: frame k+1 of the Velodyne in frame k
};

/** Rows of a frame's number and a 3x4 pose, row-major; `#` begins a comment.
@throws std::runtime_error naming the file and line that cannot be used. */
std::map<int, Pose> readKittiPoses(const std::string& path);

/** @return false where the truth does not reach from one frame to the other. */
bool trueMotion(const KittiTruth& truth, const KittiCamera& camera, int first, int second, Pose& secondFromFirst);

}  // namespace samples

#endif  // GMLPNP_SAMPLES_KITTI360_HPP
