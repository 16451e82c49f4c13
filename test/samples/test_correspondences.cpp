// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "common/correspondences.hpp"

namespace {

using namespace samples;

const char* const kHead = "# fx fy cx cy 500 510 320 240\n";
const char* const kRows = "0.1 0.2 3 300 200\n1 2 3.5 310 210\n-1 0 4 100 50\n1e-3 5 6 7 8.25\n";

//! A file of this test's own.
std::string fileWith(const std::string& text)
{
    const std::string name = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    std::string path = ::testing::TempDir() + "gmlpnp_correspondences_" + name + ".txt";
    std::ofstream(path, std::ios::binary) << text;
    return path;
}

//! The reader's complaint about a text, without the path in front; empty if there is none.
std::string complaint(const std::string& text)
{
    const std::string path = fileWith(text);
    try {
        readCorrespondences(path);
        return std::string();
    } catch (const std::runtime_error& error) {
        const std::string message = error.what();
        EXPECT_EQ(message.substr(0, path.size() + 1), path + ":");
        return message.substr(path.size() + 1);
    }
}

TEST(Correspondences, readsHeaderAndRows)
{
    const CorrespondenceSet set = readCorrespondences(
        fileWith(std::string(kHead) +
                 "# a comment\n# dist 0.1 0.2 0.3 0.4\n# image_size 640 480\n# unit m\n# source  a place, CC BY\n"
                 "# true_rvec 0 0 0.5\n# true_tvec 1 2 3\n" +
                 kRows));
    EXPECT_EQ(set.cameraMatrix, cv::Matx33d(500, 0, 320, 0, 510, 240, 0, 0, 1));
    EXPECT_EQ(set.distCoeffs, (std::vector<double>{0.1, 0.2, 0.3, 0.4}));
    EXPECT_EQ(set.imageSize, cv::Size(640, 480));
    EXPECT_EQ(set.unit, "m");
    EXPECT_EQ(set.source, std::vector<std::string>{"a place, CC BY"});
    ASSERT_TRUE(set.hasTruth);
    EXPECT_NEAR(rotationVector(set.truth.R)[2], 0.5, 1e-15);
    EXPECT_EQ(set.truth.t, cv::Vec3d(1, 2, 3));
    ASSERT_EQ(set.objectPoints.size(), 4u);
    ASSERT_EQ(set.imagePoints.size(), 4u);
    EXPECT_EQ(set.objectPoints[3], cv::Point3d(1e-3, 5, 6));
    EXPECT_EQ(set.imagePoints[3], cv::Point2d(7, 8.25));
}

TEST(Correspondences, readsWindowsLinesBlankLinesAndMissingLastNewline)
{
    const CorrespondenceSet set = readCorrespondences(fileWith(
        "#fx fy cx cy 500 510 320 240\r\n\r\n  \t\r\n# dist\r\n1 2 3 4 5\r\n\t1 2 3 4 5 \r\n1 2 3 4 5\n\n1 2 3 4 5"));
    EXPECT_EQ(set.objectPoints.size(), 4u);
    EXPECT_TRUE(set.distCoeffs.empty());
    EXPECT_FALSE(set.hasTruth);
}

TEST(Correspondences, readsTheCameraInTheWorldAtMapCoordinates)
{
    const CorrespondenceSet set = readCorrespondences(
        fileWith(std::string(kHead) +
                 "# true_camera_centre 292742.252 2731078.97 186.663\n"
                 "# true_R_world_from_camera 0 -1 0 1 0 0 0 0 1\n292771.2402 2731063.8133 96.4427 1 2\n" +
                 kRows));
    ASSERT_TRUE(set.hasTruth);
    EXPECT_EQ(set.truth.R, cv::Matx33d(0, 1, 0, -1, 0, 0, 0, 0, 1));
    EXPECT_LT(cv::norm(set.truth.centre() - cv::Vec3d(292742.252, 2731078.97, 186.663)), 1e-8);
    EXPECT_EQ(set.objectPoints[0], cv::Point3d(292771.2402, 2731063.8133, 96.4427));
}

TEST(Correspondences, namesTheLineOfEveryMistake)
{
    const std::string head = kHead, rows = kRows, good = head + rows;
    const auto expect = [](const std::string& text, const std::string& start) {
        const std::string message = complaint(text);
        EXPECT_EQ(message.substr(0, start.size()), start) << message << " in\n" << text;
    };
    expect(good, "");
    EXPECT_EQ(complaint(good), "");
    expect(good + "1 2 3 4\n", "6: expected 5 numbers, found 4");
    expect(good + "1 2 3 4 5 6\n", "6: expected 5 numbers, found 6");
    expect(good + "1 2 3 4 5px\n", "6: '5px' is not a finite number");
    for (const char* word : {"nan", "NaN", "-nan", "inf", "-Infinity", "1e999", "0x10", "1,5", "--1", "1e", "#"})
        expect(good + "1 2 " + word + " 4 5\n", std::string("6: '") + word + "' is not a finite number");
    expect(std::string("\x7f") + "ELF\x01\x02\n", "1: expected 5 numbers, found 1");
    expect(head + "a\x01 2 3 4 5\n", "2: 'a?' is not a finite number");
    expect(head + std::string(200, '7') + "x 2 3 4 5\n", "2: '" + std::string(24, '7') + "...'");
    expect("", "0: the file ends after 0 points");
    expect(head + "1 2 3 4 5\n", "2: the file ends after 1 points; at least 4 are needed");
    expect(rows, "4: the file ends without a '# fx fy cx cy' line");
    expect("# fx fy cx cy 500 510 320\n" + rows, "1: expected 4 numbers, found 3");
    expect("# fx 500\n" + rows, "1: expected 'fx fy cx cy'");
    expect("# fx fy cx cy 0 510 320 240\n" + rows, "1: a focal length of zero");
    expect(head + good, "2: a second 'fx' line");
    expect(good + "# dist 1 2 3\n", "6: expected 0, 4, 5, 8, 12 or 14 distortion coefficients, found 3");
    expect(good + "# dist 1 2 3 nan\n", "6: 'nan'");
    expect(good + "# image_size 640\n", "6: expected 2 numbers, found 1");
    expect(good + "# image_size 0 480\n", "6: an image of 0 x 480 pixels");
    expect(good + "# image_size 1e300 480\n", "6: an image of");
    expect(good + "# unit\n", "6: expected one word");
    expect(good + "# true_rvec 1 2\n", "6: expected 3 numbers, found 2");
    expect(good + "# true_rvec 1 2 3\n", "6: the truth is");
    expect(good + "# true_rvec 0 0 0\n# true_tvec 0 0 0\n# true_camera_centre 0 0 0\n", "8: the truth is");
    expect(good + "# true_camera_centre 0 0 0\n# true_R_world_from_camera 1 0 0 0 1 0 0 0 -1\n", "7: true_R_world");
    expect(good + "# true_camera_centre 0 0 0\n# true_R_world_from_camera 2 0 0 0 1 0 0 0 1\n", "7: true_R_world");
}

TEST(Correspondences, missingFilesAndFoldersAreErrors)
{
    EXPECT_THROW(readCorrespondences(::testing::TempDir() + "no/such/file.txt"), std::runtime_error);
    EXPECT_THROW(readCorrespondences(::testing::TempDir()), std::runtime_error);
    EXPECT_THROW(writeCorrespondences(::testing::TempDir() + "no/such/file.txt", CorrespondenceSet()),
                 std::runtime_error);
}

TEST(Correspondences, writesWhatItReads)
{
    CorrespondenceSet set;
    set.cameraMatrix = cv::Matx33d(517.3, 0, 318.6, 0, 516.5, 255.3, 0, 0, 1);
    set.distCoeffs = {0.2624, -0.9531, -0.0054, 0.0026, 1.1633};
    set.imageSize = cv::Size(640, 480);
    set.unit = "m";
    set.source = {"one", "two, and more"};
    set.hasTruth = true;
    set.truth = poseFromRotationVector({0.1, -0.2, 0.3}, {1, -2, 3});
    for (int i = 0; i < 10; ++i) {
        set.objectPoints.emplace_back(0.5 * i, -i, 3.25);
        set.imagePoints.emplace_back(10 * i, 100.125);
    }
    const std::string path = fileWith("");
    writeCorrespondences(path, set);
    const CorrespondenceSet again = readCorrespondences(path);
    EXPECT_EQ(again.cameraMatrix, set.cameraMatrix);
    EXPECT_EQ(again.distCoeffs, set.distCoeffs);
    EXPECT_EQ(again.imageSize, set.imageSize);
    EXPECT_EQ(again.unit, set.unit);
    EXPECT_EQ(again.source, set.source);
    ASSERT_TRUE(again.hasTruth);
    EXPECT_LT(rotationErrorDegrees(again.truth, set.truth), 1e-6);
    EXPECT_LT(positionError(again.truth, set.truth), 1e-8);
    EXPECT_EQ(again.objectPoints, set.objectPoints);
    EXPECT_EQ(again.imagePoints, set.imagePoints);
}

TEST(Correspondences, survivesDamagedFiles)
{
    std::ifstream stream(SAMPLES_DATA "/freiburg1_rpy_1305031231.126.txt");
    const std::string good((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
    ASSERT_EQ(complaint(good), "");
    cv::RNG random(20120);
    int refused = 0;
    for (int i = 0; i < 500; ++i) {
        std::string damaged = good.substr(0, static_cast<size_t>(random.uniform(0, static_cast<int>(good.size()))));
        for (int k = 0; k < 3 && !damaged.empty(); ++k)
            damaged[static_cast<size_t>(random.uniform(0, static_cast<int>(damaged.size())))] =
                static_cast<char>(random.uniform(0, 256));
        refused += complaint(damaged).empty() ? 0 : 1;
    }
    EXPECT_GT(refused, 100);
}

TEST(Correspondences, nameIsTheFilesWithoutFolderAndExtension)
{
    CorrespondenceSet set;
    set.path = "a/b.c/name.1.txt";
    EXPECT_EQ(set.name(), "name.1");
}

}  // namespace
