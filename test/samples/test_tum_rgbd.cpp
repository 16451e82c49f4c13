// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "common/feature_matching.hpp"
#include "common/tum_rgbd.hpp"

namespace {

using namespace samples;

//! The camera turns about the world's z axis at 0.5 rad/s and moves along x at 2 m/s.
TimedPose poseAt(double time)
{
    const double half = 0.25 * time;
    return {time, {2.0 * time, 1.0, 0.0}, {0.0, 0.0, std::sin(half), std::cos(half)}};
}

//! A sequence of lists without images, in a folder of this test's own.
std::string writeSequence(const std::string& colour, const std::string& depth)
{
    std::string folder =
        ::testing::TempDir() + "gmlpnp_tum_" + ::testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::create_directories(folder);
    std::ofstream truth(folder + "/groundtruth.txt");
    truth.precision(12);
    for (int i = 0; i <= 100; ++i) {
        const TimedPose p = poseAt(0.01 * i);
        truth << p.time << " " << p.centre[0] << " " << p.centre[1] << " 0 0 0 " << p.quaternion[2] << " "
              << p.quaternion[3] << "\n";
    }
    std::ofstream(folder + "/rgb.txt") << colour;
    std::ofstream(folder + "/depth.txt") << depth;
    return folder;
}

TEST(TumRgbd, interpolatesOnTheGreatArcAndOnlyInsideTheRecording)
{
    std::vector<TimedPose> truth = {poseAt(0.0), poseAt(0.1), poseAt(0.2), poseAt(0.5)};
    truth[1].quaternion = -truth[1].quaternion;  // the same rotation
    Pose pose;
    ASSERT_TRUE(interpolate(truth, 0.03, pose));
    EXPECT_LT(cv::norm(pose.centre() - cv::Vec3d(0.06, 1.0, 0.0)), 1e-12);
    EXPECT_LT(cv::norm(rotationVector(pose.R) - cv::Vec3d(0.0, 0.0, -0.015)), 1e-12);
    EXPECT_FALSE(interpolate(truth, -0.01, pose));
    EXPECT_FALSE(interpolate(truth, 0.51, pose));
    EXPECT_FALSE(interpolate(truth, 0.3, pose)) << "a gap of 0.3 s";
}

TEST(TumRgbd, pairsCarryTheMotionBetweenTheirImages)
{
    const std::string folder = writeSequence(
        "# colour\n0.4 rgb/c.png\n0.2 rgb/a.png\n0.305 rgb/b.png\n0.7 rgb/d.png\n0.8 rgb/e.png\n0.9 rgb/no_depth.png\n",
        "0.21 depth/a.png\n0.31 depth/b.png\n0.39 depth/c.png\n0.7 depth/d.png\n0.815 depth/e.png\n");
    const TumSequence sequence = readTumSequence(folder + "/");
    ASSERT_EQ(sequence.frames.size(), 5u);
    EXPECT_EQ(sequence.frames[0].colourFile, folder + "/rgb/a.png");
    EXPECT_EQ(sequence.frames[2].depthFile, folder + "/depth/c.png");
    const std::vector<FramePair> pairs = pairsOf(sequence, 0.1);
    ASSERT_EQ(pairs.size(), 3u);  // a-b, b-c, d-e
    EXPECT_EQ(pairs[2].first, 3u);
    EXPECT_EQ(pairs[2].second, 4u);
    // The camera turned by +0.05 rad, so points turn by -0.05, and it moved 0.2 m along the world's x.
    const Pose& motion = pairs[2].secondFromFirst;
    EXPECT_LT(cv::norm(rotationVector(motion.R) - cv::Vec3d(0.0, 0.0, -0.05)), 1e-9);
    const cv::Vec3d centre(0.2 * std::cos(0.35), -0.2 * std::sin(0.35), 0.0);
    EXPECT_LT(cv::norm(motion.centre() - centre), 1e-9);
}

TEST(TumRgbd, depthIsMetresAndZeroWhereNothingIsMeasured)
{
    cv::Mat depth = cv::Mat::zeros(4, 6, CV_16U);
    depth.at<ushort>(2, 5) = 12500;
    EXPECT_EQ(depthAt(depth, {5.3f, 1.8f}), 2.5);
    EXPECT_EQ(depthAt(depth, {0.0f, 0.0f}), 0.0);
    EXPECT_EQ(depthAt(depth, {6.2f, 2.0f}), 0.0);
    EXPECT_EQ(depthAt(depth, {-3.0f, 2.0f}), 0.0);
}

TEST(TumRgbd, refusesRotationsThatAreNone)
{
    for (const char* const quaternion : {"0 0 0 0", "1e200 0 0 0", "1 0 0"}) {
        const std::string folder = writeSequence("0 a\n", "0 b\n");
        std::ofstream(folder + "/groundtruth.txt") << "0 0 0 0 " << quaternion << "\n";
        EXPECT_THROW(readTumSequence(folder), std::runtime_error) << quaternion;
    }
}

TEST(TumRgbd, refusesFilesThatAreNoDepthImage)
{
    const std::string path = ::testing::TempDir() + "gmlpnp_tum_no_depth.pgm";
    for (const char* const content : {"", "P2 2 1 255\n1 2\n", "P5 2000000000 2000000000 65535\n", "P2 2 1 65535\n"}) {
        std::ofstream(path) << content;
        EXPECT_THROW(readDepthImage(path), std::runtime_error) << content;
    }
    std::ofstream(path) << "P2 2 1 65535\n1 5000\n";
    EXPECT_EQ(depthAt(readDepthImage(path), {1.0f, 0.0f}), 1.0);
}

// The picture is a whole PGM, which OpenCV reads by its first bytes. Only a comment gives it the mark of DICOM.
TEST(TumRgbd, refusesImagesWithTheMarkOfDicom)
{
    const std::string path = ::testing::TempDir() + "gmlpnp_tum_marked.pgm", start = "P2\n#";
    for (const char* const mark : {"DICN", "DICM"}) {
        std::ofstream(path) << start << std::string(128 - start.size(), ' ') << mark << "\n2 1 65535\n1 5000\n";
        if (std::string(mark) == "DICM")
            EXPECT_THROW(readDepthImage(path), std::runtime_error);
        else
            EXPECT_EQ(depthAt(readDepthImage(path), {1.0f, 0.0f}), 1.0);
    }
}

TEST(TumRgbd, namesTellTheCamera)
{
    TumCalibration calibration;
    for (const char* name : {"rgbd_dataset_freiburg1_desk2", "tum_fr1_rpy"}) {
        ASSERT_TRUE(tumCalibration(name, calibration));
        EXPECT_EQ(calibration.cameraMatrix(0, 0), 517.3);
        EXPECT_EQ(calibration.distCoeffs.size(), 5u);
    }
    ASSERT_TRUE(tumCalibration("rgbd_dataset_freiburg2_desk", calibration));
    EXPECT_EQ(calibration.cameraMatrix(1, 2), 249.7);
    ASSERT_TRUE(tumCalibration("rgbd_dataset_freiburg3_long_office_household", calibration));
    EXPECT_TRUE(calibration.distCoeffs.empty());
    EXPECT_FALSE(tumCalibration("kitchen", calibration));
    EXPECT_FALSE(tumCalibration("rgbd_dataset_freiburg4_desk", calibration));
}

TEST(TumRgbd, theCommittedCorrespondencesComeOutAgain)
{
    const char* const variable = std::getenv("GMLPNP_DATA");
    const std::string folder = std::string(variable ? variable : GMLPNP_DATA_DEFAULT) + "/tum_fr1_rpy";
    if (!std::ifstream(folder + "/groundtruth.txt").is_open())
        GTEST_SKIP() << "no TUM sequence in " << folder << "; the folder is GMLPNP_DATA/tum_fr1_rpy";
    const CorrespondenceSet committed = readCorrespondences(SAMPLES_DATA "/freiburg1_rpy_1305031231.126.txt");
    MatchingOptions options;
    options.cameraMatrix = committed.cameraMatrix;
    options.distCoeffs = committed.distCoeffs;
    const TumSequence sequence = readTumSequence(folder);
    for (const FramePair& pair : pairsOf(sequence, 0.1)) {
        if (std::abs(sequence.frames[pair.first].time - 1305031231.125728) > 1e-4)
            continue;
        EXPECT_LT(rotationErrorDegrees(pair.secondFromFirst, committed.truth), 1e-6);
        EXPECT_LT(positionError(pair.secondFromFirst, committed.truth), 1e-8);
        const CorrespondenceSet again = matchFrames(sequence, pair, options);
        // Another version of OpenCV may detect other features; what both found must be the same numbers.
        size_t common = 0;
        for (size_t i = 0; i < again.imagePoints.size(); ++i)
            for (size_t k = 0; k < committed.imagePoints.size(); ++k)
                common += cv::norm(again.imagePoints[i] - committed.imagePoints[k]) < 1e-3 &&
                                  cv::norm(again.objectPoints[i] - committed.objectPoints[k]) < 1e-5
                              ? 1
                              : 0;
        EXPECT_GE(static_cast<double>(common), 0.9 * static_cast<double>(committed.imagePoints.size()));
        return;
    }
    FAIL() << "the pair at 1305031231.125728 is not in the sequence";
}

}  // namespace
