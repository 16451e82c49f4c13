// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "camera_util.hpp"

namespace opencv_test {
namespace {

using namespace camera;

const Matx33d kK = matrixK(190.9785, 190.9733, 254.9317, 256.8974);
const Vec4d kD(0.0034824, 0.000715, -0.0020532, 0.00020294);
const Vec3d kZero(0, 0, 0);

// The formula in long double, apart from the code under test.
Point2d oracle(const Vec3d& X, const Matx33d& K, const Vec4d& D)
{
    const long double r = std::hypot(static_cast<long double>(X[0]), static_cast<long double>(X[1]));
    const long double t = std::atan2(r, static_cast<long double>(X[2]));
    const long double d =
        t + D[0] * std::pow(t, 3.L) + D[1] * std::pow(t, 5.L) + D[2] * std::pow(t, 7.L) + D[3] * std::pow(t, 9.L);
    const long double x = d * X[0] / r, y = d * X[1] / r;
    return {static_cast<double>(K(0, 0) * x + K(0, 1) * y + K(0, 2)), static_cast<double>(K(1, 1) * y + K(1, 2))};
}

TEST(Gmlpnp_CameraFisheye, equalsTheFormulaInAllDirections)
{
    const Ptr<CameraModel> camera = CameraModel::fisheye(kK, kD);
    for (const Vec3d& m : polarGrid(110 * kDegree)) {
        Point2d pixel;
        ASSERT_TRUE(camera->projectPoint(m, pixel));
        const Point2d expected = m[0] == 0 ? Point2d(kK(0, 2), kK(1, 2)) : oracle(m, kK, kD);
        ASSERT_LT(cv::norm(pixel - expected), 1e-11) << m;
    }
}

TEST(Gmlpnp_CameraFisheye, equalsProjectPointsInFront)
{
    const std::vector<Point3d> points = pointsInFront(8);  // to 85 degrees
    std::vector<Point2d> expected;
    fisheye::projectPoints(points, expected, kZero, kZero, kK, kD);
    Mat pixels, valid;
    CameraModel::fisheye(kK, kD)->project(points, pixels, valid);
    ASSERT_EQ(countNonZero(valid), static_cast<int>(points.size()));
    EXPECT_LT(cv::norm(pixels, Mat(expected).reshape(1), NORM_INF), 1e-10);
}

TEST(Gmlpnp_CameraFisheye, skewIsAlphaOfOpenCV)
{
    const double alpha = 0.02;
    Matx33d skewed = kK;
    skewed(0, 1) = alpha * kK(0, 0);
    const std::vector<Point3d> points = pointsInFront(2);
    std::vector<Point2d> expected;
    fisheye::projectPoints(points, expected, kZero, kZero, kK, kD, alpha);
    Mat pixels;
    CameraModel::fisheye(skewed, kD)->project(points, pixels);
    EXPECT_LT(cv::norm(pixels, Mat(expected).reshape(1), NORM_INF), 1e-10);
}

TEST(Gmlpnp_CameraFisheye, equalsUndistortPointsInFront)
{
    const Ptr<CameraModel> camera = CameraModel::fisheye(kK, kD);
    for (const Vec3d& m : polarGrid(80 * kDegree)) {
        std::vector<Point2d> pixel(1), plane;
        ASSERT_TRUE(camera->projectPoint(m, pixel[0]));
        fisheye::undistortPoints(pixel, plane, kK, kD);
        Vec3d ray;
        ASSERT_TRUE(camera->unprojectPoint(pixel[0], ray));
        // OpenCV stops at a step of 1e-8 rad and works on tangents.
        EXPECT_LT(cv::norm(Point2d(ray[0] / ray[2], ray[1] / ray[2]) - plane[0]), 1e-7 * (1 + cv::norm(plane[0]))) << m;
    }
}

// Where OpenCV is not right: what lies behind the image plane is mirrored to the front.
TEST(Gmlpnp_CameraFisheye, projectPointsLosesTheSignOfZ)
{
    for (const double angle : {95, 110}) {
        const Vec3d m = direction(angle * kDegree, 0.3);
        std::vector<Point2d> theirs;
        fisheye::projectPoints(std::vector<Point3d>{{m[0], m[1], m[2]}}, theirs, kZero, kZero, kK, kD);
        Point2d ours;
        ASSERT_TRUE(CameraModel::fisheye(kK, kD)->projectPoint(m, ours));
        EXPECT_LT(cv::norm(ours - oracle(m, kK, kD)), 1e-10);
        EXPECT_GT(cv::norm(theirs[0] - oracle(m, kK, kD)), 400) << angle;  // px: on the other side of the picture
    }
}

// Where OpenCV is not right: no plane holds a ray at 100 degrees, yet it returns a point.
TEST(Gmlpnp_CameraFisheye, undistortPointsEndsAtARightAngle)
{
    const Ptr<CameraModel> camera = CameraModel::fisheye(kK, kD);
    std::vector<Point2d> pixel(1), plane;
    const Vec3d m = direction(100 * kDegree, 0.3);
    ASSERT_TRUE(camera->projectPoint(m, pixel[0]));
    fisheye::undistortPoints(pixel, plane, kK, kD);
    const Vec3d theirs = normalize(Vec3d(plane[0].x, plane[0].y, 1));
    EXPECT_GT(cv::norm(theirs - m), 9 * kDegree);
    Vec3d ours;
    ASSERT_TRUE(camera->unprojectPoint(pixel[0], ours));
    EXPECT_LT(cv::norm(ours - m), 1e-14);
}

TEST(Gmlpnp_CameraFisheye, domainEndsAtTheTurningPoint)
{
    // theta_d = theta - 0.1 theta^3 turns at theta = sqrt(1 / 0.3), 104.6 degrees.
    const Ptr<CameraModel> camera = CameraModel::fisheye(kK, Vec4d(-0.1, 0, 0, 0));
    const double turn = std::sqrt(1 / 0.3), radius = turn * 2 / 3;
    Point2d pixel;
    Vec3d ray;
    EXPECT_TRUE(camera->projectPoint(direction(turn - 1e-9, 1), pixel));
    EXPECT_FALSE(camera->projectPoint(direction(turn + 1e-9, 1), pixel));
    EXPECT_TRUE(camera->unprojectPoint({kK(0, 2) + kK(0, 0) * (radius - 1e-9), kK(1, 2)}, ray));
    EXPECT_FALSE(camera->unprojectPoint({kK(0, 2) + kK(0, 0) * (radius + 1e-9), kK(1, 2)}, ray));
    for (const double angle : spaced(0, turn - 1e-3, 2000)) {
        const Vec3d m = direction(angle, 2.2);
        ASSERT_TRUE(camera->projectPoint(m, pixel));
        ASSERT_TRUE(camera->unprojectPoint(pixel, ray));
        ASSERT_LT(cv::norm(ray - m), 1e-12) << angle;
    }
}

TEST(Gmlpnp_CameraFisheye, domainEndsBehind)
{
    const Ptr<CameraModel> camera = CameraModel::fisheye(kK);
    Point2d pixel;
    Vec3d ray;
    EXPECT_TRUE(camera->projectPoint(direction(CV_PI - 1e-6, 1), pixel));
    EXPECT_FALSE(camera->projectPoint({0, 0, -1}, pixel));
    EXPECT_TRUE(camera->unprojectPoint({kK(0, 2) + kK(0, 0) * (CV_PI - 1e-6), kK(1, 2)}, ray));
    EXPECT_FALSE(camera->unprojectPoint({kK(0, 2) + kK(0, 0) * (CV_PI + 1e-6), kK(1, 2)}, ray));
}

}  // namespace
}  // namespace opencv_test
