// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "common/kitti360.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <locale>
#include <sstream>
#include <stdexcept>

namespace samples {

namespace {

//! How far R^T R of a rotation in a file may be from the identity.
constexpr double kRotationTolerance = 1e-3;

std::ifstream opened(const std::string& path, std::ios::openmode mode = std::ios::in)
{
    std::ifstream stream(path, mode);
    if (!stream.is_open() || std::filesystem::is_directory(path))
        throw std::runtime_error(path + ": cannot be opened");
    return stream;
}

//! All numbers of a line from here on; false where anything else stands in it.
bool numbersOf(std::istream& words, std::vector<double>& numbers)
{
    for (double number = 0.0; words >> number;)
        numbers.push_back(number);
    return words.eof();
}

//! The numbers after a key, at the start of a line; an empty key is the first line.
std::vector<double> numbersAfter(const std::string& path, const std::string& key, size_t count)
{
    std::ifstream stream = opened(path);
    for (std::string line; std::getline(stream, line);) {
        std::istringstream words(line);
        words.imbue(std::locale::classic());
        std::string word;
        if (!key.empty() && (!(words >> word) || word != key))
            continue;
        std::vector<double> numbers;
        if (!numbersOf(words, numbers) || numbers.size() != count)
            throw std::runtime_error(cv::format("%s: %s expected %zu numbers", path.c_str(), key.c_str(), count));
        return numbers;
    }
    throw std::runtime_error(path + ": no " + (key.empty() ? "first line" : key));
}

//! From 12 numbers, 3x4, row-major. @return false where it is no rigid motion.
bool poseOf(const double* v, Pose& pose)
{
    pose = {cv::Matx33d(v[0], v[1], v[2], v[4], v[5], v[6], v[8], v[9], v[10]), cv::Vec3d(v[3], v[7], v[11])};
    return cv::norm(pose.R.t() * pose.R - cv::Matx33d::eye()) < kRotationTolerance && cv::determinant(pose.R) > 0.0;
}

Pose poseAfter(const std::string& path, const std::string& key)
{
    Pose pose;
    if (!poseOf(numbersAfter(path, key, 12).data(), pose))
        throw std::runtime_error(path + ": " + key + " is no rotation and translation");
    return pose;
}

cv::Size pictureSize(const std::string& path, double width, double height)
{
    constexpr double kLongestSide = 1e6;  // px
    if (!(width >= 1.0 && height >= 1.0 && width <= kLongestSide && height <= kLongestSide))
        throw std::runtime_error(cv::format("%s: a picture of %g x %g pixels", path.c_str(), width, height));
    return {cvRound(width), cvRound(height)};
}

void readPinhole(const std::string& folder, KittiCamera& camera, Pose& rectification)
{
    const std::string path = folder + "/perspective.txt";
    const std::vector<double> P = numbersAfter(path, "P_rect_" + camera.name + ":", 12);
    const std::vector<double> R = numbersAfter(path, "R_rect_" + camera.name + ":", 9);
    const std::vector<double> size = numbersAfter(path, "S_rect_" + camera.name + ":", 2);
    camera.isPinhole = true;
    camera.cameraMatrix = cv::Matx33d(P[0], P[1], P[2], P[4], P[5], P[6], P[8], P[9], P[10]);
    camera.lens = cv::gmlpnp::CameraModel::pinhole(camera.cameraMatrix, cv::noArray());
    camera.size = pictureSize(path, size[0], size[1]);
    rectification.R = cv::Matx33d(R.data());
}

void readFisheye(const std::string& folder, KittiCamera& camera)
{
    const std::string path = folder + "/image_" + camera.name + ".yaml";
    opened(path);
    camera.lens = cv::gmlpnp::CameraModel::load(path);
    camera.size =
        pictureSize(path, numbersAfter(path, "image_width:", 1)[0], numbersAfter(path, "image_height:", 1)[0]);
}

//! The frame whose number a file's name is. @return false where it is none.
bool frameOf(const std::string& stem, int& frame)
{
    const char* const end = stem.data() + stem.size();
    const auto [last, error] = std::from_chars(stem.data(), end, frame);
    return error == std::errc() && last == end && frame >= 0;
}

//! @return false where a number is none of a frame.
bool frameOf(double number, int& frame)
{
    if (!(number >= 0.0 && number <= std::numeric_limits<int>::max()) || number != std::floor(number))
        return false;
    frame = static_cast<int>(number);
    return true;
}

std::string frameName(int frame)
{
    return cv::format("%010d", frame);
}

}  // namespace

KittiCamera readKittiCamera(const std::string& root, const std::string& name)
{
    const std::string folder = root + "/calibration";
    KittiCamera camera;
    camera.name = name;
    Pose rectification;
    if (name == "00" || name == "01")
        readPinhole(folder, camera, rectification);
    else if (name == "02" || name == "03")
        readFisheye(folder, camera);
    else
        throw std::runtime_error("there is no camera '" + name + "': 00, 01, 02 or 03");
    const std::string poses = folder + "/calib_cam_to_pose.txt";
    camera.fromVehicle = rectification * inverse(poseAfter(poses, "image_" + name + ":"));
    const Pose vehicleFromCamera0 = poseAfter(poses, "image_00:");
    camera.fromLidar =
        camera.fromVehicle * vehicleFromCamera0 * inverse(poseAfter(folder + "/calib_cam_to_velo.txt", ""));
    return camera;
}

KittiCamera turnedCamera(const KittiCamera& place, const KittiCamera& lens, const cv::Matx33d& turn)
{
    KittiCamera camera = lens;
    const Pose turned{turn, cv::Vec3d()};
    camera.fromLidar = turned * place.fromLidar;
    camera.fromVehicle = turned * place.fromVehicle;
    return camera;
}

std::vector<std::string> kittiDrives(const std::string& root)
{
    const std::filesystem::path folder = root + "/data_2d_raw";
    if (!std::filesystem::is_directory(folder))
        throw std::runtime_error(folder.string() + ": no such folder; the data set's own layout is expected");
    std::vector<std::string> drives;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.is_directory())
            drives.push_back(entry.path().filename().string());
    if (drives.empty())
        throw std::runtime_error(folder.string() + ": no drives");
    std::sort(drives.begin(), drives.end());
    return drives;
}

std::string kittiPicture(const std::string& root, const std::string& drive, const KittiCamera& camera, int frame)
{
    const std::string kind = camera.isPinhole ? "/data_rect/" : "/data_rgb/";
    return root + "/data_2d_raw/" + drive + "/image_" + camera.name + kind + frameName(frame) + ".png";
}

std::string kittiScan(const std::string& root, const std::string& drive, int frame)
{
    return root + "/data_3d_raw/" + drive + "/velodyne_points/data/" + frameName(frame) + ".bin";
}

std::vector<int> kittiFrames(const std::string& root, const std::string& drive)
{
    const std::filesystem::path folder = std::filesystem::path(kittiScan(root, drive, 0)).parent_path();
    std::vector<int> frames;
    if (std::filesystem::is_directory(folder))
        for (const auto& entry : std::filesystem::directory_iterator(folder)) {
            int frame = 0;
            if (entry.path().extension() == ".bin" && frameOf(entry.path().stem().string(), frame))
                frames.push_back(frame);
        }
    if (frames.empty())
        throw std::runtime_error(folder.string() + ": no LiDAR scans");
    std::sort(frames.begin(), frames.end());
    return frames;
}

std::vector<cv::Point3d> readScan(const std::string& path, const KittiCamera& camera)
{
    std::ifstream stream = opened(path, std::ios::binary);
    std::vector<cv::Point3d> points;
    cv::Vec4f point;  // x y z reflectance
    while (stream.read(reinterpret_cast<char*>(point.val), sizeof point.val))
        if (std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]))
            points.emplace_back(camera.fromLidar * cv::Vec3d(point[0], point[1], point[2]));
    if (stream.gcount() != 0 || points.empty())
        throw std::runtime_error(path + ": " + (points.empty() ? "no points" : "ends within a point"));
    return points;
}

std::map<int, Pose> readKittiPoses(const std::string& path)
{
    std::ifstream stream = opened(path);
    std::map<int, Pose> poses;
    int number = 0;
    for (std::string line; std::getline(stream, line);) {
        ++number;
        std::istringstream words(line);
        words.imbue(std::locale::classic());
        if (!(words >> std::ws) || words.peek() == '#' || words.eof())
            continue;
        std::vector<double> v;
        int frame = 0;
        Pose pose;
        if (!numbersOf(words, v) || v.size() != 13 || !frameOf(v[0], frame) || !poseOf(v.data() + 1, pose))
            throw std::runtime_error(path + ":" + std::to_string(number) + ": expected a frame and a 3x4 pose");
        poses[frame] = pose;
    }
    if (poses.empty())
        throw std::runtime_error(path + ": no poses");
    return poses;
}

bool trueMotion(const KittiTruth& truth, const KittiCamera& camera, int first, int second, Pose& secondFromFirst)
{
    const auto a = truth.worldFromVehicle.find(first), b = truth.worldFromVehicle.find(second);
    if (a != truth.worldFromVehicle.end() && b != truth.worldFromVehicle.end()) {
        const Pose step = inverse(b->second) * a->second;
        secondFromFirst = camera.fromVehicle * step * inverse(camera.fromVehicle);
        return true;
    }
    Pose step;
    for (int frame = first; frame < second; ++frame) {
        const auto next = truth.lidarFromNext.find(frame);
        if (next == truth.lidarFromNext.end())
            return false;
        step = inverse(next->second) * step;
    }
    secondFromFirst = camera.fromLidar * step * inverse(camera.fromLidar);
    return true;
}

}  // namespace samples
