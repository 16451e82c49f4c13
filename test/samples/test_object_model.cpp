// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "common/object_model.hpp"

namespace {

using namespace samples;

const char* const kMesh = "ply\nformat ascii 1.0\nelement vertex 2\nend_header\n0 25.8 7.5\n18.9 0 0\n3 0 1 0\n";

std::string matrix(int rows, int cols, const std::string& type, const std::string& data)
{
    return "!!opencv-matrix\n   rows: " + std::to_string(rows) + "\n   cols: " + std::to_string(cols) +
           "\n   dt: " + type + "\n   data: [ " + data + " ]\n";
}

std::string numbers(int count)
{
    std::string all = "0";
    for (int i = 1; i < count; ++i)
        all += ", " + std::to_string(i);
    return all;
}

std::string modelOf(const std::string& points, const std::string& descriptors)
{
    return "%YAML:1.0\n---\npoints_3d: " + points + "descriptors: " + descriptors;
}

//! A folder of this test's own.
std::string write(const std::string& model, const std::string& mesh)
{
    std::string folder =
        ::testing::TempDir() + "gmlpnp_object_" + ::testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::create_directories(folder);
    std::ofstream(folder + "/cookies_ORB.yml") << model;
    std::ofstream(folder + "/box.ply") << mesh;
    return folder;
}

const std::string kPoints = matrix(2, 1, "\"3f\"", "1., 2., 3., 4., 5., 6.5"),
                  kDescriptors = matrix(2, 32, "u", numbers(64));

TEST(ObjectModel, isPointsWithDescriptorsAndTheCornersOfTheMesh)
{
    const ObjectModel model = readObjectModel(write(modelOf(kPoints, kDescriptors), kMesh));
    EXPECT_EQ(model.points, (std::vector<cv::Point3d>{{1, 2, 3}, {4, 5, 6.5}}));
    EXPECT_EQ(model.descriptors.at<uchar>(1, 31), 63);
    EXPECT_EQ(model.corners, (std::vector<cv::Point3d>{{0, 25.8, 7.5}, {18.9, 0, 0}}));
}

void expectRefused(const std::string& folder, const std::string& file)
{
    try {
        readObjectModel(folder);
        FAIL() << "not refused";
    } catch (const std::runtime_error& e) {
        EXPECT_NE(std::string(e.what()).find(folder + "/" + file), std::string::npos) << e.what();
    } catch (const std::exception& e) {
        FAIL() << e.what();
    }
}

TEST(ObjectModel, refusesMeshesThatAreNone)
{
    const std::string model = modelOf(kPoints, kDescriptors);
    for (const char* const vertices : {"0", "3", "1000000000000000000", "-1", "two"})
        expectRefused(write(model, "ply\nelement vertex " + std::string(vertices) + "\nend_header\n0 0 0\n1 1 1\n"),
                      "box.ply");
    expectRefused(write(model, ""), "box.ply");
}

TEST(ObjectModel, refusesModelsThatAreNone)
{
    const std::string models[] = {"",
                                  "%YAML:1.0\n---\nnothing: 1\n",
                                  "%YAML:1.0\n---\npoints_3d: [ 1, 2\n",
                                  modelOf("text\n", kDescriptors),
                                  modelOf(kPoints, matrix(1, 32, "u", numbers(32))),
                                  modelOf(kPoints, matrix(2, 32, "f", numbers(64))),
                                  modelOf(kPoints, matrix(2, 31, "u", numbers(62))),
                                  modelOf(matrix(2, 1, "\"2f\"", numbers(4)), kDescriptors),
                                  modelOf(matrix(2, 6, "f", numbers(12)), kDescriptors),
                                  modelOf(matrix(2, 3, "f", "1., 2., 3., 4., 5., .Nan"), kDescriptors),
                                  modelOf(matrix(1 << 30, 1 << 30, "\"3f\"", "1."), kDescriptors)};
    for (const std::string& model : models) {
        SCOPED_TRACE(model.substr(0, 200));
        expectRefused(write(model, kMesh), "cookies_ORB.yml");
    }
}

}  // namespace
