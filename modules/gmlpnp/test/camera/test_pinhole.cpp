// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "camera_util.hpp"

namespace opencv_test {
namespace {

using namespace camera;

using Coefficients = std::vector<double>;

const Matx33d kK = matrixK(517.3, 516.5, 318.6, 255.3);
const Vec3d kZero(0, 0, 0);
const Coefficients kWide = {-0.26, 0.10, 0, 0};
const Coefficients kTum = {0.2624, -0.9531, -0.0054, 0.0026, 1.1633};
const Coefficients kAll = {-0.12, 0.08,  0.001,  -0.002, 0.01,  0.02, 0.01,
                           0.005, 0.004, -0.001, -0.003, 0.002, 0.05, -0.08};

class Gmlpnp_CameraPinholeCounts : public testing::TestWithParam<int>
{};

TEST_P(Gmlpnp_CameraPinholeCounts, equalsProjectPoints)
{
    const Coefficients D(kAll.begin(), kAll.begin() + GetParam());
    const std::vector<Point3d> points = pointsInFront(0.9);
    std::vector<Point2d> expected;
    projectPoints(points, kZero, kZero, kK, D, expected);
    Mat pixels, valid;
    CameraModel::pinhole(kK, D)->project(points, pixels, valid);
    ASSERT_EQ(countNonZero(valid), static_cast<int>(points.size()));
    EXPECT_LT(cv::norm(pixels, Mat(expected).reshape(1), NORM_INF), 1e-10);
}

TEST_P(Gmlpnp_CameraPinholeCounts, equalsUndistortPointsIteratedToConvergence)
{
    const Coefficients D(kAll.begin(), kAll.begin() + GetParam());
    std::vector<Point2d> pixels, plane;
    for (int v = 0; v < 480; v += 40)
        for (int u = 0; u < 640; u += 40)
            pixels.emplace_back(u, v);
    undistortPoints(pixels, plane, kK, D, noArray(), noArray(), TermCriteria(TermCriteria::COUNT, 200, 0));
    Mat rays, valid;
    CameraModel::pinhole(kK, D)->unproject(pixels, rays, valid);
    for (int i = 0; i < rays.rows; ++i) {
        ASSERT_EQ(valid.at<uchar>(i), 255);
        const double* m = rays.ptr<double>(i);
        EXPECT_LT(cv::norm(Point2d(m[0] / m[2], m[1] / m[2]) - plane[i]), 1e-11);
    }
}

INSTANTIATE_TEST_SUITE_P(/**/, Gmlpnp_CameraPinholeCounts, testing::Values(0, 4, 5, 8, 12, 14));

TEST(Gmlpnp_CameraPinhole, skewIsIgnoredAsInOpenCV)
{
    const std::vector<Point3d> points = pointsInFront(0.7);
    std::vector<Point2d> expected;
    const Matx33d skewed = matrixK(517.3, 516.5, 318.6, 255.3, 25);
    projectPoints(points, kZero, kZero, skewed, kWide, expected);
    Mat pixels;
    CameraModel::pinhole(skewed, kWide)->project(points, pixels);
    EXPECT_LT(cv::norm(pixels, Mat(expected).reshape(1), NORM_INF), 1e-10);
}

// The whole picture of real lenses: every pixel has a ray, and the ray leads back to the pixel.
TEST(Gmlpnp_CameraPinhole, wideLensesOverTheWholePicture)
{
    const Ptr<CameraModel> cameras[] = {CameraModel::pinhole(matrixK(250, 250, 320, 240), kWide),
                                        CameraModel::pinhole(kK, kTum)};
    for (const Ptr<CameraModel>& camera : cameras)
        for (int v = 0; v < 480; v += 3)
            for (int u = 0; u < 640; u += 3) {
                Vec3d ray;
                Point2d again;
                ASSERT_TRUE(camera->unprojectPoint(Point2d(u, v), ray)) << u << " " << v;
                ASSERT_TRUE(camera->projectPoint(ray, again));
                ASSERT_LT(cv::norm(again - Point2d(u, v)), 1e-10) << u << " " << v;
            }
}

// Where OpenCV is not right: five iterations do not undistort a wide lens.
TEST(Gmlpnp_CameraPinhole, undistortPointsStopsTooEarly)
{
    const Matx33d K = matrixK(250, 250, 320, 240);
    const std::vector<Point2d> corner = {{0, 0}};
    std::vector<Point2d> plane, back;
    undistortPoints(corner, plane, K, kWide);
    projectPoints(std::vector<Point3d>{{plane[0].x, plane[0].y, 1}}, kZero, kZero, K, kWide, back);
    EXPECT_GT(cv::norm(back[0] - corner[0]), 0.2);  // px
}

// Where OpenCV is not right: what lies beyond the fold is projected into the picture, what lies behind is mirrored.
TEST(Gmlpnp_CameraPinhole, projectPointsFoldsAndMirrors)
{
    const Coefficients barrel = {-0.3, 0, 0, 0};
    const std::vector<Point3d> points = {{1.7, 0, 1}, {0.3, 0.1, -1}};
    std::vector<Point2d> folded;
    projectPoints(points, kZero, kZero, kK, barrel, folded);
    EXPECT_TRUE(Rect2d(0, 0, 640, 480).contains(folded[0]));
    EXPECT_TRUE(Rect2d(0, 0, 640, 480).contains(folded[1]));
    Mat pixels, valid;
    CameraModel::pinhole(kK, barrel)->project(points, pixels, valid);
    EXPECT_EQ(countNonZero(valid), 0);
    EXPECT_EQ(cv::norm(pixels), 0);
}

TEST(Gmlpnp_CameraPinhole, pixelsBeyondTheFoldHaveNoRay)
{
    const Ptr<CameraModel> camera = CameraModel::pinhole(matrixK(300, 300, 320, 240), Coefficients{-0.3, 0, 0, 0});
    const double edge = 300 * 2.0 / 3 * std::sqrt(1 / 0.9);  // r (1 - 0.3 r^2) at its turning point
    Vec3d ray;
    EXPECT_TRUE(camera->unprojectPoint({320 + edge * (1 - 1e-9), 240}, ray));
    EXPECT_NEAR(std::atan2(ray[0], ray[2]), std::atan(std::sqrt(1 / 0.9)), 1e-4);
    EXPECT_FALSE(camera->unprojectPoint({320 + edge * (1 + 1e-9), 240}, ray));
    EXPECT_FALSE(camera->unprojectPoint({320, 240 - 1.5 * edge}, ray));
}

TEST(Gmlpnp_CameraPinhole, behindAndBesideAreMasked)
{
    const Ptr<CameraModel> camera = CameraModel::pinhole(kK);
    Point2d pixel;
    EXPECT_FALSE(camera->projectPoint({1, 0, 0}, pixel));
    EXPECT_FALSE(camera->projectPoint({1, 0, -0.0}, pixel));
    EXPECT_FALSE(camera->projectPoint({0, 0, -1}, pixel));
    EXPECT_TRUE(camera->projectPoint({0, 0, 1e-300}, pixel));
    EXPECT_EQ(pixel, Point2d(318.6, 255.3));
}

TEST(Gmlpnp_CameraPinhole, undistortedJacobianInClosedForm)
{
    Vec3d ray;
    Matx32d J;
    ASSERT_TRUE(CameraModel::pinhole(kK)->unprojectPoint({318.6, 255.3}, ray, &J));
    EXPECT_EQ(ray, Vec3d(0, 0, 1));
    EXPECT_LT(cv::norm(J - Matx32d(1 / 517.3, 0, 0, 1 / 516.5, 0, 0)), 1e-18);
}

TEST(Gmlpnp_CameraPinhole, sensorTiltedByARightAngle)
{
    Coefficients D(14, 0.0);
    D[12] = 2;  // rad
    expectError(Error::StsBadArg, "D", [&] { CameraModel::pinhole(kK, D); });
}

}  // namespace
}  // namespace opencv_test
