// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "every_lens.hpp"

// What holds for every lens.

namespace opencv_test {
namespace {

using namespace camera;

TEST_P(Gmlpnp_Camera, raysToPixelsAndBack)
{
    double worst = 0;
    for (const Vec3d& m : grid) {
        Point2d pixel;
        Vec3d ray;
        ASSERT_TRUE(camera->projectPoint(m, pixel)) << m;
        ASSERT_TRUE(camera->unprojectPoint(pixel, ray)) << m << pixel;
        ASSERT_NEAR(ray.dot(ray), 1, 1e-14) << m;
        worst = std::max(worst, cv::norm(ray - m));
    }
    EXPECT_LT(worst, 1e-12);
    RecordProperty("worst_rad", std::to_string(worst));
}

TEST_P(Gmlpnp_Camera, pixelsToRaysAndBack)
{
    double worst = 0;
    for (const Vec3d& m : grid) {
        Point2d pixel, again;
        Vec3d ray;
        ASSERT_TRUE(camera->projectPoint(m, pixel));
        const Point2d rounded(std::round(pixel.x), pixel.y);
        if (!camera->unprojectPoint(rounded, ray))
            continue;  // rounding left the domain
        ASSERT_TRUE(camera->projectPoint(ray, again)) << rounded;
        worst = std::max(worst, cv::norm(again - rounded) / (1 + cv::norm(rounded)));
    }
    EXPECT_LT(worst, 1e-12);  // relative
}

TEST_P(Gmlpnp_Camera, lengthOfThePointDoesNotMatter)
{
    for (const double length : {1e-200, 1e-3, 1e5, 1e200})
        for (size_t i = 0; i < grid.size(); i += 7) {
            Point2d unit, scaled;
            ASSERT_TRUE(camera->projectPoint(grid[i], unit));
            ASSERT_TRUE(camera->projectPoint(grid[i] * length, scaled)) << grid[i] << length;
            ASSERT_LT(cv::norm(unit - scaled), 1e-10 * (1 + cv::norm(unit))) << grid[i] << length;
        }
}

TEST_P(Gmlpnp_Camera, nothingIsSeenOfWhatIsNotFinite)
{
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    for (const double bad : {nan, inf, -inf}) {
        Vec3d ray(7, 7, 7);
        Point2d pixel(7, 7);
        Matx32d J;
        EXPECT_FALSE(camera->unprojectPoint({bad, 200}, ray, &J));
        EXPECT_FALSE(camera->unprojectPoint({300, bad}, ray, &J));
        EXPECT_FALSE(camera->projectPoint({bad, 0, 1}, pixel));
        EXPECT_FALSE(camera->projectPoint({0.1, bad, 1}, pixel));
        EXPECT_FALSE(camera->projectPoint({0.1, 0, bad}, pixel));
        EXPECT_EQ(ray, Vec3d(7, 7, 7));
        EXPECT_EQ(pixel, Point2d(7, 7));
    }
    Point2d pixel(7, 7);
    EXPECT_FALSE(camera->projectPoint({0, 0, 0}, pixel));
    EXPECT_EQ(pixel, Point2d(7, 7));
}

// Far outside of any picture: either no ray, or a finite unit ray.
TEST_P(Gmlpnp_Camera, extremePixelsGiveAUnitRayOrNone)
{
    for (const double far : {1e3, 1e5, 1e8, 1e20, 1e100, 1e200, 1e308})
        for (const Point2d& pixel : {Point2d(far, 3), Point2d(-3, -far), Point2d(far, -far)}) {
            Vec3d ray;
            Matx32d J;
            if (!camera->unprojectPoint(pixel, ray, &J))
                continue;
            EXPECT_NEAR(ray.dot(ray), 1, 1e-12) << pixel;
            EXPECT_TRUE(std::isfinite(cv::norm(J))) << pixel;
        }
}

TEST_P(Gmlpnp_Camera, arraysEqualSinglePoints)
{
    std::vector<Point2d> pixels;
    for (int v = -2000; v < 3000; v += 211)
        for (int u = -2000; u < 3000; u += 197)
            pixels.emplace_back(u, v);
    Mat rays, valid, jacobian;
    camera->unproject(pixels, rays, valid, jacobian);
    const int n = static_cast<int>(pixels.size());
    ASSERT_EQ(rays.size(), Size(3, n));
    ASSERT_EQ(rays.type(), CV_64F);
    ASSERT_EQ(valid.size(), Size(1, n));
    ASSERT_EQ(valid.type(), CV_8U);
    ASSERT_EQ(jacobian.size(), Size(6, n));
    ASSERT_EQ(jacobian.type(), CV_64F);
    for (int i = 0; i < n; ++i) {
        Vec3d ray(0, 0, 0);
        Matx32d J = Matx32d::zeros();
        const bool seen = camera->unprojectPoint(pixels[i], ray, &J);
        ASSERT_EQ(valid.at<uchar>(i), seen ? 255 : 0);
        ASSERT_EQ(Vec3d(rays.ptr<double>(i)), ray);
        ASSERT_EQ(Matx32d(jacobian.ptr<double>(i)), J);
        ASSERT_TRUE(checkRange(rays.row(i)));
    }
}

// A batch with behind, zero and NaN: masked, and zero in the output.
TEST_P(Gmlpnp_Camera, masksOfProjection)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<Point3d> points = {{0.1, 0.2, 1}, {0, 0, 0}, {nan, 0, 1}, {-0.1, 0.1, 2}};
    Mat pixels, valid;
    camera->project(points, pixels, valid);
    ASSERT_EQ(pixels.size(), Size(2, 4));
    EXPECT_EQ(Vec4b(valid.ptr()), Vec4b(255, 0, 0, 255));
    EXPECT_EQ(cv::norm(pixels.rowRange(1, 3)), 0);
    Point2d first;
    ASSERT_TRUE(camera->projectPoint(Vec3d(points[0].x, points[0].y, points[0].z), first));
    EXPECT_EQ(pixels.at<double>(0, 0), first.x);
    EXPECT_EQ(pixels.at<double>(0, 1), first.y);
}

TEST_P(Gmlpnp_Camera, writtenAndReadItIsTheSameToTheLastBit)
{
    for (const char* extension : {".yml", ".xml", ".json"}) {
        FileStorage out(extension, FileStorage::WRITE | FileStorage::MEMORY);
        out << "camera"
            << "{";
        camera->write(out);
        out << "}";
        const String text = out.releaseAndGetString();
        const FileStorage in(text, FileStorage::READ | FileStorage::MEMORY);
        const Ptr<CameraModel> again = CameraModel::read(in["camera"]);
        for (const Vec3d& m : grid) {
            Point2d a, b;
            ASSERT_TRUE(camera->projectPoint(m, a));
            ASSERT_TRUE(again->projectPoint(m, b));
            ASSERT_EQ(a, b) << extension << m;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(/**/, Gmlpnp_Camera, testing::ValuesIn(everyLens()), lensName);

}  // namespace
}  // namespace opencv_test
