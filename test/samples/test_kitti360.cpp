// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>

#include <opencv2/imgproc.hpp>

#include "common/kitti360.hpp"
#include "common/lidar_tracking.hpp"
#include "common/resampling.hpp"

namespace {

using namespace samples;
using cv::gmlpnp::CameraModel;

std::string rowOf(const Pose& pose)
{
    std::string row;
    for (int i = 0; i < 3; ++i)
        row += cv::format(" %.12g %.12g %.12g %.12g", pose.R(i, 0), pose.R(i, 1), pose.R(i, 2), pose.t[i]);
    return row;
}

const Pose kVehicleFrom0 = poseFromRotationVector({1.2, -1.1, 1.3}, {1.5, 0.1, -0.6});
const Pose kVehicleFrom2 = poseFromRotationVector({-1.5, 0.1, 0.2}, {0.7, -0.2, -1.0});
const Pose kLidarFrom0 = poseFromRotationVector({1.1, -1.2, 1.2}, {0.8, 0.3, -0.2});
const cv::Matx33d kRectification = poseFromRotationVector({0.01, -0.02, 0.005}, {}).R;

//! A calibration folder of a made-up vehicle, in a folder of this test's own.
std::string writeCalibration()
{
    std::string root =
        ::testing::TempDir() + "gmlpnp_kitti_" + ::testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::create_directories(root + "/calibration");
    const cv::Matx33d& R = kRectification;
    std::ofstream(root + "/calibration/perspective.txt")
        << "calib_time: today\nS_rect_00: 1408 376\nP_rect_00: 550 0 680 0 0 550 240 0 0 0 1 0\nR_rect_00:"
        << cv::format(" %.12g %.12g %.12g %.12g %.12g %.12g %.12g %.12g %.12g\n", R(0, 0), R(0, 1), R(0, 2), R(1, 0),
                      R(1, 1), R(1, 2), R(2, 0), R(2, 1), R(2, 2));
    std::ofstream(root + "/calibration/calib_cam_to_pose.txt")
        << "image_00:" << rowOf(kVehicleFrom0) << " \nimage_02:" << rowOf(kVehicleFrom2) << " \n";
    std::ofstream(root + "/calibration/calib_cam_to_velo.txt") << rowOf(kLidarFrom0) << "\n";
    std::ofstream(root + "/calibration/image_02.yaml")
        << "%YAML:1.0\n---\nmodel_type: MEI\nimage_width: 1400\nimage_height: 1300\nmirror_parameters:\n   xi: 2.2\n"
        << "distortion_parameters:\n   k1: 0.01\n   k2: 0.1\n   p1: 0\n   p2: 0\nprojection_parameters:\n"
        << "   gamma1: 1336\n   gamma2: 1336\n   u0: 717\n   v0: 706\n";
    return root;
}

void expectEqual(const Pose& a, const Pose& b, double tolerance)
{
    EXPECT_LT(cv::norm(a.R - b.R), tolerance);
    EXPECT_LT(cv::norm(a.t - b.t), tolerance);
}

TEST(Kitti360, camerasStandWhereTheCalibrationSays)
{
    const std::string root = writeCalibration();
    const KittiCamera pinhole = readKittiCamera(root, "00"), fisheye = readKittiCamera(root, "02");
    EXPECT_TRUE(pinhole.isPinhole);
    EXPECT_EQ(pinhole.size, cv::Size(1408, 376));
    expectEqual(pinhole.fromLidar, Pose{kRectification, {}} * inverse(kLidarFrom0), 1e-9);
    EXPECT_FALSE(fisheye.isPinhole);
    EXPECT_EQ(fisheye.size, cv::Size(1400, 1300));
    expectEqual(fisheye.fromLidar, inverse(kVehicleFrom2) * kVehicleFrom0 * inverse(kLidarFrom0), 1e-9);
    // Both ways from the vehicle to the LiDAR are one.
    expectEqual(inverse(pinhole.fromVehicle) * pinhole.fromLidar, inverse(fisheye.fromVehicle) * fisheye.fromLidar,
                1e-9);
}

TEST(Kitti360, posesAndLidarMotionTellTheSame)
{
    const std::string root = writeCalibration(), poses = root + "/poses.txt", steps = root + "/motion.txt";
    const KittiCamera camera = readKittiCamera(root, "02");
    const Pose vehicleFromLidar = inverse(camera.fromVehicle) * camera.fromLidar;
    std::ofstream poseFile(poses), stepFile(steps);
    stepFile << "# a comment\n";
    Pose world = poseFromRotationVector({0.1, 0.2, 2.0}, {1200.0, 3400.0, 110.0});
    for (int frame = 7; frame < 11; ++frame) {
        const Pose step = poseFromRotationVector({0.01 * frame, -0.02, 0.03}, {1.0, 0.1 * frame, 0.0});
        poseFile << frame << rowOf(world) << "\n";
        stepFile << frame << rowOf(step) << "\n";
        world = world * vehicleFromLidar * step * inverse(vehicleFromLidar);
    }
    poseFile.close();
    stepFile.close();
    const KittiTruth byPoses{readKittiPoses(poses), {}}, bySteps{{}, readKittiPoses(steps)};
    Pose a, b;
    ASSERT_TRUE(trueMotion(byPoses, camera, 7, 10, a));
    ASSERT_TRUE(trueMotion(bySteps, camera, 7, 10, b));
    expectEqual(a, b, 1e-7);
    EXPECT_GT(cv::norm(a.t), 2.0);
    EXPECT_FALSE(trueMotion(byPoses, camera, 9, 11, a)) << "the last pose is that of frame 10";
    EXPECT_TRUE(trueMotion(bySteps, camera, 9, 11, a));
    EXPECT_FALSE(trueMotion(bySteps, camera, 9, 12, a));
}

TEST(Kitti360, aTurnedCameraSeesTheSamePlace)
{
    const std::string root = writeCalibration();
    const KittiCamera pinhole = readKittiCamera(root, "00"), fisheye = readKittiCamera(root, "02");
    const cv::Matx33d turn = poseFromRotationVector({0.0, 0.7, 0.0}, {}).R;
    const KittiCamera camera = turnedCamera(pinhole, fisheye, turn);
    const cv::Vec3d point(12.0, 3.0, -1.0);
    EXPECT_LT(cv::norm(camera.fromLidar * point - turn * (pinhole.fromLidar * point)), 1e-9);
    EXPECT_EQ(camera.size, fisheye.size);
}

TEST(Kitti360, refusesWhatItCannotRead)
{
    const std::string root = writeCalibration();
    EXPECT_THROW(readKittiCamera(root, "04"), std::runtime_error);
    EXPECT_THROW(readKittiCamera(root, "03"), std::runtime_error) << "no file";
    EXPECT_THROW(readKittiCamera(root, "01"), std::runtime_error) << "no key";
    std::ofstream(root + "/poses.txt") << "5 1 0 0 0 0 1 0 0 0 0 1\n";
    EXPECT_THROW(readKittiPoses(root + "/poses.txt"), std::runtime_error);
    std::ofstream(root + "/poses.txt") << "5 1 0 0 0 0 2 0 0 0 0 1 0\n";
    EXPECT_THROW(readKittiPoses(root + "/poses.txt"), std::runtime_error) << "no rotation";
    for (const char* const frame : {"-1", "0.5", "2147483648", "1e300"}) {
        std::ofstream(root + "/poses.txt") << frame << " 1 0 0 0 0 1 0 0 0 0 1 0\n";
        EXPECT_THROW(readKittiPoses(root + "/poses.txt"), std::runtime_error) << frame;
    }
    std::ofstream(root + "/scan.bin") << "12345678901234567";
    EXPECT_THROW(readScan(root + "/scan.bin", readKittiCamera(root, "00")), std::runtime_error);
    EXPECT_THROW(kittiFrames(root, "drive"), std::runtime_error);
    EXPECT_THROW(kittiDrives(root), std::runtime_error);
}

TEST(Kitti360, refusesPicturesOfNoSize)
{
    for (const char* const size : {"0 376", "1408 -376", "1e300 376", "1408 0.2"}) {
        const std::string root = writeCalibration();
        std::ofstream(root + "/calibration/perspective.txt")
            << "S_rect_00: " << size << "\nP_rect_00: 550 0 680 0 0 550 240 0 0 0 1 0\nR_rect_00: 1 0 0 0 1 0 0 0 1\n";
        EXPECT_THROW(readKittiCamera(root, "00"), std::runtime_error) << size;
    }
}

TEST(Kitti360, leavesOutPointsThatAreNotFinite)
{
    const std::string root = writeCalibration();
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    const float rows[][4] = {{1, 2, 3, nan}, {nan, 2, 3, 0}, {1, -inf, 3, 0}, {4, 5, 6, 0}};
    std::ofstream(root + "/scan.bin", std::ios::binary).write(reinterpret_cast<const char*>(rows), sizeof rows);
    EXPECT_EQ(readScan(root + "/scan.bin", readKittiCamera(root, "00")).size(), 2u);
}

TEST(Kitti360, framesAreFilesWhoseNameIsANumber)
{
    const std::string root = writeCalibration(), folder = root + "/data_3d_raw/drive/velodyne_points/data/";
    std::filesystem::create_directories(folder);
    for (const char* const name : {"0000000012.bin", "0000000003.bin", "99999999999.bin", "1x.bin", "0000000004.txt"})
        std::ofstream(folder + name).put(' ');
    EXPECT_EQ(kittiFrames(root, "drive"), (std::vector<int>{3, 12}));
}

//! The rectified stereo pair: its baseline stands in the projection matrix too, a second way to the same number.
TEST(Kitti360, theRealCalibrationAgreesWithItsBaseline)
{
    const char* const variable = std::getenv("GMLPNP_DATA");
    const std::string root = std::string(variable ? variable : GMLPNP_DATA_DEFAULT) + "/kitti360";
    if (!std::filesystem::exists(root + "/calibration/perspective.txt"))
        GTEST_SKIP() << "no KITTI-360 in " << root << "; the folder is GMLPNP_DATA/kitti360";
    const Pose step = readKittiCamera(root, "01").fromLidar * inverse(readKittiCamera(root, "00").fromLidar);
    EXPECT_LT(cv::norm(step.R - cv::Matx33d::eye()), 1e-3);
    EXPECT_LT(cv::norm(step.t - cv::Vec3d(-328.318735 / 552.554261, 0.0, 0.0)), 1e-3);
}

//! A wall with a pattern, seen by a camera that moves aside: its picture is shifted by whole pixels.
cv::Mat patternShiftedBy(int pixels)
{
    cv::RNG random(5);
    cv::Mat pattern(300, 560, CV_8U);  // wider than the picture: what comes in from the side has a pattern too
    random.fill(pattern, cv::RNG::UNIFORM, 0, 256);
    cv::GaussianBlur(pattern, pattern, cv::Size(), 2.0);
    cv::normalize(pattern, pattern, 0, 255, cv::NORM_MINMAX);
    return pattern(cv::Rect(30 - pixels, 0, 500, 300)).clone();
}

TEST(LidarTracking, findsWhatMovedAndOnlyWhatIsSeen)
{
    const auto lens = CameraModel::pinhole(cv::Matx33d(250, 0, 250, 0, 250, 150, 0, 0, 1), cv::noArray());
    const cv::Mat mask = seenPixels(*lens, {500, 300}, 180.0, 20);
    EXPECT_EQ(cv::countNonZero(mask), 460 * 260);
    std::vector<cv::Point3d> wall;
    for (int y = -14; y <= 14; ++y)
        for (int x = -24; x <= 24; ++x)
            wall.emplace_back(0.2 * x, 0.2 * y, 5.0);
    const size_t seen = wall.size();
    for (int i = 0; i < 40; ++i)
        wall.emplace_back(0.4 * i - 8.0, 0.0, 10.0);  // hidden behind it
    const auto points = trackablePoints(wall, patternShiftedBy(0), *lens, mask, {});
    EXPECT_GT(points.size(), seen / 2);
    for (const cv::Point3d& point : points)
        EXPECT_EQ(point.z, 5.0);
    for (const bool chain : {false, true}) {
        std::vector<cv::Mat> pictures = {patternShiftedBy(0), patternShiftedBy(6)};
        if (chain)
            pictures.push_back(patternShiftedBy(12));
        const Tracks tracks = trackPoints(points, pictures, *lens, mask, {});
        EXPECT_GT(tracks.points.size(), 9 * points.size() / 10);
        for (size_t i = 0; i < tracks.points.size(); ++i) {
            cv::Point2d start;
            ASSERT_TRUE(lens->projectPoint(tracks.points[i], start));
            EXPECT_LT(cv::norm(tracks.pixels[i] - start - cv::Point2d(chain ? 12.0 : 6.0, 0.0)), 0.1);
        }
    }
    EXPECT_TRUE(trackPoints({}, {patternShiftedBy(0), patternShiftedBy(6)}, *lens, mask, {}).points.empty());
}

TEST(LidarTracking, theFieldOfALensIsAboutItsAxis)
{
    const auto lens = CameraModel::fisheye(cv::Matx33d(100, 0, 200, 0, 100, 200, 0, 0, 1), cv::noArray());
    const double radius = std::sqrt(cv::countNonZero(seenPixels(*lens, {401, 401}, 120.0, 0)) / CV_PI);
    EXPECT_NEAR(radius, 100.0 * CV_PI / 3.0, 0.5);  // an equidistant lens
}

TEST(Resampling, aPictureThroughItsOwnLensIsItself)
{
    const auto lens = CameraModel::pinhole(cv::Matx33d(250, 0, 250, 0, 250, 150, 0, 0, 1), cv::noArray());
    const cv::Mat photograph = patternShiftedBy(0);
    const Resampling same(*lens, photograph.size(), *lens, photograph.size(), cv::Matx33d::eye());
    const cv::Rect inside(4, 4, 492, 292);
    EXPECT_LT(cv::norm(same(photograph)(inside), photograph(inside), cv::NORM_INF), 8.0);
    EXPECT_EQ(cv::countNonZero(same.mask()(inside)), inside.area());
    // Turned by a right angle it sees nothing of the photograph.
    const cv::Matx33d turn = poseFromRotationVector({0.0, CV_PI / 2.0, 0.0}, {}).R;
    EXPECT_EQ(cv::countNonZero(Resampling(*lens, photograph.size(), *lens, photograph.size(), turn).mask()), 0);
}

}  // namespace
