// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "kitti360.hpp"

#include <fstream>
#include <sstream>
#include <stdexcept>

#include <opencv2/imgcodecs.hpp>

#include "test_data.hpp"

namespace kitti360 {

namespace {

const std::string kFolder = "kitti360/", kDrive = "2013_05_28_drive_0003_sync/";

std::string file(const std::string& name)
{
    return opencv_test::dataFile(kFolder + name);
}

std::string frameName(int frame)
{
    return cv::format("%010d", frame);
}

//! The numbers after a key, at the start of a line; an empty key is the first line.
std::vector<double> numbersOf(const std::string& name, const std::string& key)
{
    std::ifstream stream(file(name));
    for (std::string line; std::getline(stream, line);) {
        std::istringstream words(line);
        std::string word;
        if (!key.empty() && (!(words >> word) || word != key))
            continue;
        std::vector<double> numbers;
        for (double number = 0.0; words >> number;)
            numbers.push_back(number);
        return numbers;
    }
    throw std::runtime_error(name + ": no " + key);
}

//! From 12 numbers, 3x4, row-major.
Pose poseOf(const std::vector<double>& v)
{
    return {cv::Matx33d(v[0], v[1], v[2], v[4], v[5], v[6], v[8], v[9], v[10]), cv::Vec3d(v[3], v[7], v[11])};
}

Pose operator*(const Pose& a, const Pose& b)
{
    return {a.R * b.R, a * b.t};
}

Pose inverse(const Pose& pose)
{
    return {pose.R.t(), pose.centre()};
}

//! The rectified camera from the LiDAR.
Pose cameraFromLidar()
{
    const std::vector<double> R = numbersOf("calibration/perspective.txt", "R_rect_00:");
    const Pose rectification{cv::Matx33d(R.data()), cv::Vec3d()};
    return rectification * inverse(poseOf(numbersOf("calibration/calib_cam_to_velo.txt", "")));
}

}  // namespace

bool isPresent()
{
    return !file("pseudo_velo_motion.txt").empty();
}

cv::Matx33d cameraMatrix()
{
    return poseOf(numbersOf("calibration/perspective.txt", "P_rect_00:")).R;
}

std::string fisheyeFile(const std::string& camera)
{
    return file("calibration/image_" + camera + ".yaml");
}

cv::Mat photograph(int frame)
{
    return cv::imread(file("data_2d_raw/" + kDrive + "image_00/data_rect/" + frameName(frame) + ".png"),
                      cv::IMREAD_GRAYSCALE);
}

std::vector<cv::Point3d> lidarPoints(int frame)
{
    const Pose transform = cameraFromLidar();
    std::ifstream stream(file("data_3d_raw/" + kDrive + "velodyne_points/data/" + frameName(frame) + ".bin"),
                         std::ios::binary);
    std::vector<cv::Point3d> points;
    for (cv::Vec4f point; stream.read(reinterpret_cast<char*>(point.val), sizeof point.val);)  // x y z reflectance
        points.emplace_back(transform * cv::Vec3d(point[0], point[1], point[2]));
    return points;
}

Pose motion(int frame)
{
    const Pose E = cameraFromLidar();
    return E * inverse(poseOf(numbersOf("pseudo_velo_motion.txt", std::to_string(frame)))) * inverse(E);
}

}  // namespace kitti360
