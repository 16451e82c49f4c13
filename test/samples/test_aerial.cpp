// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <opencv2/imgproc.hpp>

#include "common/correspondences.hpp"
#include "common/exterior_orientation.hpp"
#include "common/pixel_matches.hpp"
#include "common/statistics.hpp"

namespace {

using namespace samples;

std::string written(const std::string& name, const std::string& text)
{
    std::string path = ::testing::TempDir() + "gmlpnp_aerial_" + name;
    std::ofstream(path) << text;
    return path;
}

TEST(ExteriorOrientation, readsBothKindsOfTables)
{
    const auto commas = readOrientations(written("commas.csv",
                                                 "filename,x,y,z,omega,phi,kappa\n"
                                                 "IMG_1.tif,100.5,200,300,1,2,3\nIMG_2.5,1,2,3,0,0,90\n"));
    ASSERT_EQ(commas.size(), 2u);
    EXPECT_LT(cv::norm(commas.at("IMG_1").centre() - cv::Vec3d(100.5, 200.0, 300.0)), 1e-9);
    EXPECT_TRUE(commas.count("IMG_2.5"));
    const auto quoted = readOrientations(written("quoted.csv",
                                                 "'camera' 'filename' 'kappa' 'phi' 'omega' 'z' 'y' 'x'\n"
                                                 "'a b c' 'IMG_1' 3 2 1 300 200 100.5\n\n"));
    EXPECT_LT(cv::norm(quoted.at("IMG_1").R - commas.at("IMG_1").R), 1e-12);
    EXPECT_LT(cv::norm(quoted.at("IMG_1").t - commas.at("IMG_1").t), 1e-9);
}

TEST(ExteriorOrientation, refusesOtherTables)
{
    EXPECT_THROW(readOrientations("nowhere.csv"), std::runtime_error);
    EXPECT_THROW(readOrientations(written("empty.csv", "filename,x,y,z,omega,phi,kappa\n")), std::runtime_error);
    EXPECT_THROW(readOrientations(written("title.csv", "filename,x,y,z,omega,phi\na,1,2,3,4,5\n")), std::runtime_error);
    EXPECT_THROW(readOrientations(written("short.csv", "filename,x,y,z,omega,phi,kappa\na,1,2,3,4,5\n")),
                 std::runtime_error);
    EXPECT_THROW(readOrientations(written("nan.csv", "filename,x,y,z,omega,phi,kappa\na,1,2,3,4,5,nan\n")),
                 std::runtime_error);
}

TEST(ExteriorOrientation, attitudeIsThatOfAnAircraft)
{
    // Looking straight down with the image's top to the north: all angles zero.
    EXPECT_LT(cv::norm(rollPitchYaw(poseFromOmegaPhiKappa({}, {}))), 1e-12);
    // Kappa turns the picture counter-clockwise, the heading is clockwise.
    EXPECT_LT(cv::norm(rollPitchYaw(poseFromOmegaPhiKappa({}, {0.0, 0.0, 30.0})) - cv::Vec3d(0.0, 0.0, -30.0)), 1e-12);
    // Nose up by 20 degrees while flying north: the axis leads forward.
    const Pose up = poseFromOmegaPhiKappa({}, {20.0, 0.0, 0.0});
    EXPECT_LT(cv::norm(rollPitchYaw(up) - cv::Vec3d(0.0, 20.0, 0.0)), 1e-12);
    EXPECT_GT((up.R.t() * cv::Vec3d(0.0, 0.0, 1.0))[1], 0.3);
    // Right wing down: the axis leads to the left, to the west.
    const Pose roll = poseFromOmegaPhiKappa({}, {0.0, 10.0, 0.0});
    EXPECT_NEAR(std::abs(rollPitchYaw(roll)[0]), 10.0, 1e-12);
    EXPECT_EQ(rollPitchYaw(roll)[0] > 0.0, (roll.R.t() * cv::Vec3d(0.0, 0.0, 1.0))[0] < 0.0);
    EXPECT_NEAR(angleDifference(-179.0, 179.0), 2.0, 1e-12);
    EXPECT_EQ(angleDifference(90.0, -90.0), 180.0);
}

//! The poses that come with the correspondences were written by another program.
TEST(ExteriorOrientation, agreesWithThePosesOfTheCorrespondences)
{
    const char* const variable = std::getenv("GMLPNP_DATA");
    const std::string root = std::string(variable ? variable : GMLPNP_DATA_DEFAULT);
    if (!std::filesystem::exists(root + "/aerial_ngi/ngi_xyz_opk.csv"))
        GTEST_SKIP() << "no aerial photographs in " << root << "; the folder is GMLPNP_DATA";
    const std::pair<std::string, std::string> sets[] = {{"aerial_ngi", "ngi_xyz_opk.csv"},
                                                        {"aerial_odm", "odm_xyz_opk.csv"}};
    for (const auto& [folder, table] : sets) {
        const std::filesystem::path path = std::filesystem::path(root) / folder;
        const auto poses = readOrientations((path / table).string());
        ASSERT_EQ(poses.size(), 4u);
        for (const auto& entry : std::filesystem::directory_iterator(path / "correspondences")) {
            const CorrespondenceSet set = readCorrespondences(entry.path().string());
            const std::string name = set.name().substr(set.name().find("__") + 2);
            // The tables round angles to a thousandth of a degree, the files northings to a centimetre.
            EXPECT_LT(rotationErrorDegrees(poses.at(name), set.truth), 2e-3) << set.path;
            EXPECT_LT(positionError(poses.at(name), set.truth), 6e-3) << set.path;
        }
    }
}

TEST(PixelMatches, readsRowsAndNothingElse)
{
    const PixelMatches matches =
        readMatches(written("matches.txt", "# u v u' v'\n\n1 2 3.5 4 0.9\n-1 -2 -3 -4 # no confidence\n"));
    ASSERT_EQ(matches.query.size(), 2u);
    EXPECT_EQ(matches.reference[0], cv::Point2d(1.0, 2.0));
    EXPECT_EQ(matches.query[0], cv::Point2d(3.5, 4.0));
    EXPECT_TRUE(readMatches(written("none.txt", "# nothing\n")).query.empty());
    EXPECT_THROW(readMatches(written("bad.txt", "1 2 3\n")), std::runtime_error);
    EXPECT_THROW(readMatches("nowhere.txt"), std::runtime_error);
}

cv::Mat pattern()
{
    cv::RNG random(17);
    cv::Mat noise(400, 500, CV_8U);
    random.fill(noise, cv::RNG::UNIFORM, 0, 256);
    cv::GaussianBlur(noise, noise, cv::Size(), 2.5);
    cv::normalize(noise, noise, 0, 255, cv::NORM_MINMAX);
    return noise;
}

//! A picture turned upside down: any shift of the features shows twice.
TEST(PixelMatches, siftLiesWhereThePictureIs)
{
    cv::Mat turned;
    cv::rotate(pattern(), turned, cv::ROTATE_180);
    const PixelMatches matches =
        matchSift(siftFeatures(pattern(), cv::Mat(), 2000), siftFeatures(turned, cv::Mat(), 2000), 0.8);
    ASSERT_GT(matches.query.size(), 300u);
    std::vector<double> x, y;
    for (size_t i = 0; i < matches.query.size(); ++i) {
        x.push_back(499.0 - matches.query[i].x - matches.reference[i].x);
        y.push_back(399.0 - matches.query[i].y - matches.reference[i].y);
    }
    EXPECT_LT(std::abs(median(x)), 0.1);
    EXPECT_LT(std::abs(median(y)), 0.1);
}

TEST(PixelMatches, siftStaysInsideTheMask)
{
    cv::Mat mask = cv::Mat::zeros(400, 500, CV_8U);
    mask(cv::Rect(100, 100, 200, 200)).setTo(255);
    const SiftFeatures features = siftFeatures(pattern(), mask, 2000);
    ASSERT_GT(features.points.size(), 20u);
    for (const cv::KeyPoint& point : features.points)
        EXPECT_TRUE(cv::Rect2f(105, 105, 190, 190).contains(point.pt));
    const SiftFeatures none = siftFeatures(cv::Mat(400, 500, CV_8U, cv::Scalar(90)), cv::Mat(), 2000);
    EXPECT_TRUE(matchSift(none, features, 0.8).query.empty());
}

}  // namespace
