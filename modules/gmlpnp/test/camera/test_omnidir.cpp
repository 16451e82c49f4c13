// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "camera_util.hpp"

// cv::omnidir is in opencv_contrib: compared with where the build links it and says so with GMLPNP_HAVE_CCALIB.
#if defined(GMLPNP_HAVE_CCALIB) && __has_include(<opencv2/ccalib/omnidir.hpp>)
#include <opencv2/ccalib/omnidir.hpp>
#define GMLPNP_COMPARE_WITH_OMNIDIR
#endif

namespace opencv_test {
namespace {

using namespace camera;

const Matx33d kK = matrixK(407.63, 409.18, 630.66, 431.52, 0.8);
const Vec4d kD(-0.01034, 0.01188, 0.02262, -0.00402);
const double kXi = 1.04956;

// The formula in long double, apart from the code under test.
Point2d oracle(const Vec3d& X, const Matx33d& K, const Vec4d& D, double xi)
{
    const long double x = X[0], y = X[1], z = X[2], n = std::sqrt(x * x + y * y + z * z);
    const long double a = x / (z + xi * n), b = y / (z + xi * n), q = a * a + b * b;
    const long double radial = 1 + D[0] * q + D[1] * q * q;
    const long double u = a * radial + 2 * D[2] * a * b + D[3] * (q + 2 * a * a);
    const long double v = b * radial + D[2] * (q + 2 * b * b) + 2 * D[3] * a * b;
    return {static_cast<double>(K(0, 0) * u + K(0, 1) * v + K(0, 2)), static_cast<double>(K(1, 1) * v + K(1, 2))};
}

TEST(Gmlpnp_CameraOmnidir, equalsTheFormulaInAllDirections)
{
    const Ptr<CameraModel> camera = CameraModel::omnidir(kK, kD, kXi);
    for (const Vec3d& m : polarGrid(140 * kDegree)) {
        Point2d pixel;
        ASSERT_TRUE(camera->projectPoint(m, pixel));
        ASSERT_LT(cv::norm(pixel - oracle(m, kK, kD, kXi)), 1e-10) << m;
    }
}

// m3 > -xi, or -1 / xi: on both sides of the end, for points and for pixels.
TEST(Gmlpnp_CameraOmnidir, domain)
{
    for (const double xi : {0.0, 0.4, 0.8, 1.0, 1.3, 2.2}) {
        const Ptr<CameraModel> camera = CameraModel::omnidir(matrixK(300, 300, 320, 240), noArray(), xi);
        const double end = std::acos(-(xi <= 1 ? xi : 1 / xi));
        Point2d pixel;
        Vec3d ray;
        for (const double angle : spaced(0, end - 1e-3, 300)) {
            const Vec3d m = direction(angle, 0.7);
            ASSERT_TRUE(camera->projectPoint(m, pixel)) << xi;
            ASSERT_TRUE(camera->unprojectPoint(pixel, ray)) << xi;
            ASSERT_LT(cv::norm(ray - m), 1e-11) << xi << " at " << angle;
        }
        EXPECT_TRUE(camera->projectPoint(direction(end - 1e-6, 0.7), pixel)) << xi;
        // With xi = 1 only the point straight behind is left.
        const Vec3d beyond = xi == 1 ? Vec3d(0, 0, -1) : direction(end + 1e-6, 0.7);
        EXPECT_FALSE(camera->projectPoint(beyond, pixel)) << xi;
        if (xi > 1) {
            const double radius = 300 / std::sqrt(xi * xi - 1);
            EXPECT_TRUE(camera->unprojectPoint({320 + radius * (1 - 1e-9), 240}, ray)) << xi;
            EXPECT_NEAR(ray[2], -1 / xi, 1e-4);
            EXPECT_FALSE(camera->unprojectPoint({320 + radius * (1 + 1e-9), 240}, ray)) << xi;
        }
    }
}

TEST(Gmlpnp_CameraOmnidir, withoutMirrorAndSkewItIsThePinhole)
{
    const Matx33d K = matrixK(407.63, 409.18, 630.66, 431.52);
    Mat a, b;
    CameraModel::omnidir(K, kD, 0)->project(pointsInFront(0.8), a);
    CameraModel::pinhole(K, kD)->project(pointsInFront(0.8), b);
    EXPECT_LT(cv::norm(a, b, NORM_INF), 1e-10);
}

#ifdef GMLPNP_COMPARE_WITH_OMNIDIR

TEST(Gmlpnp_CameraOmnidir, equalsCvOmnidirProjectPoints)
{
    std::vector<Point3d> points;
    for (const Vec3d& m : polarGrid(140 * kDegree))
        points.emplace_back(3 * m);
    std::vector<Point2d> expected;
    omnidir::projectPoints(points, expected, Vec3d(0, 0, 0), Vec3d(0, 0, 0), kK, kXi, kD);
    Mat pixels, valid;
    CameraModel::omnidir(kK, kD, kXi)->project(points, pixels, valid);
    ASSERT_EQ(countNonZero(valid), static_cast<int>(points.size()));
    EXPECT_LT(cv::norm(pixels, Mat(expected).reshape(1), NORM_INF), 1e-9);
}

TEST(Gmlpnp_CameraOmnidir, equalsCvOmnidirUndistortPointsInFront)
{
    const Ptr<CameraModel> camera = CameraModel::omnidir(kK, kD, kXi);
    for (const Vec3d& m : polarGrid(80 * kDegree)) {
        std::vector<Point2d> pixel(1), plane;
        Vec3d ray;
        ASSERT_TRUE(camera->projectPoint(m, pixel[0]));
        omnidir::undistortPoints(pixel, plane, kK, kD, Mat(1, 1, CV_64F, Scalar(kXi)), Matx33d::eye());
        ASSERT_TRUE(camera->unprojectPoint(pixel[0], ray));
        EXPECT_LT(cv::norm(Point2d(ray[0] / ray[2], ray[1] / ray[2]) - plane[0]), 1e-9 * (1 + plane[0].dot(plane[0])))
            << m;
    }
}

// Where cv::omnidir is not right: it divides by z, so that a ray at 110 degrees comes back as its opposite.
TEST(Gmlpnp_CameraOmnidir, cvOmnidirUndistortPointsEndsAtARightAngle)
{
    const Ptr<CameraModel> camera = CameraModel::omnidir(kK, kD, kXi);
    std::vector<Point2d> pixel(1), plane;
    const Vec3d m = direction(110 * kDegree, 0.3);
    ASSERT_TRUE(camera->projectPoint(m, pixel[0]));
    omnidir::undistortPoints(pixel, plane, kK, kD, Mat(1, 1, CV_64F, Scalar(kXi)), Matx33d::eye());
    EXPECT_LT(cv::norm(normalize(Vec3d(plane[0].x, plane[0].y, 1)) + m), 1e-6);
    Vec3d ours;
    ASSERT_TRUE(camera->unprojectPoint(pixel[0], ours));
    EXPECT_LT(cv::norm(ours - m), 1e-13);
}

// Where cv::omnidir is not right: its 20 fixed-point steps do not invert a strong distortion.
TEST(Gmlpnp_CameraOmnidir, cvOmnidirUndistortPointsDiverges)
{
    const Vec4d strong(0.5, 0.9, 0, 0);
    const Ptr<CameraModel> camera = CameraModel::omnidir(kK, strong, 1);
    std::vector<Point2d> pixel(1), plane;
    const Vec3d m = direction(85 * kDegree, 0.3);
    ASSERT_TRUE(camera->projectPoint(m, pixel[0]));
    omnidir::undistortPoints(pixel, plane, kK, strong, Mat(1, 1, CV_64F, Scalar(1)), Matx33d::eye());
    EXPECT_FALSE(cv::norm(normalize(Vec3d(plane[0].x, plane[0].y, 1)) - m) < 1 * kDegree);
    Vec3d ours;
    ASSERT_TRUE(camera->unprojectPoint(pixel[0], ours));
    EXPECT_LT(cv::norm(ours - m), 1e-13);
}

#endif  // GMLPNP_COMPARE_WITH_OMNIDIR

}  // namespace
}  // namespace opencv_test
