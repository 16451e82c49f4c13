// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "camera_util.hpp"

namespace opencv_test {
namespace {

using namespace camera;

class Gmlpnp_CameraEquirectangular : public testing::Test
{
protected:
    const double W = 2000, H = 1000;
    Ptr<CameraModel> camera = CameraModel::equirectangular(Size(2000, 1000));

    void expectPixel(const Vec3d& m, double u, double v) const
    {
        Point2d pixel;
        ASSERT_TRUE(camera->projectPoint(m, pixel)) << m;
        EXPECT_NEAR(pixel.x, u, 1e-10) << m;
        EXPECT_NEAR(pixel.y, v, 1e-10) << m;
    }
};

TEST_F(Gmlpnp_CameraEquirectangular, convention)
{
    expectPixel({0, 0, 1}, W / 2 - 0.5, H / 2 - 0.5);
    expectPixel({1, 0, 0}, 3 * W / 4 - 0.5, H / 2 - 0.5);
    expectPixel({-1, 0, 0}, W / 4 - 0.5, H / 2 - 0.5);
    expectPixel({0, 1, 1}, W / 2 - 0.5, 3 * H / 4 - 0.5);
    expectPixel({0, -1, 1}, W / 2 - 0.5, H / 4 - 0.5);
    expectPixel({-1e-300, 0, -1}, -0.5, H / 2 - 0.5);
    expectPixel({0, 0, -1}, W - 0.5, H / 2 - 0.5);
}

TEST_F(Gmlpnp_CameraEquirectangular, poles)
{
    expectPixel({0, -1, 0}, W / 2 - 0.5, -0.5);
    expectPixel({0, 1, 0}, W / 2 - 0.5, H - 0.5);
    for (const double u : {0.0, 700.0, 1999.0}) {
        Vec3d ray;
        Matx32d J;
        ASSERT_TRUE(camera->unprojectPoint({u, -0.5}, ray, &J));
        EXPECT_LT(cv::norm(ray - Vec3d(0, -1, 0)), 1e-15);
        EXPECT_LT(cv::norm(J.col(0)), 1e-15);  // rank 1
        EXPECT_NEAR(cv::norm(J.col(1)), CV_PI / H, 1e-15);
        EXPECT_FALSE(camera->unprojectPoint({u, -0.5001}, ray));
        EXPECT_FALSE(camera->unprojectPoint({u, H - 0.4999}, ray));
    }
}

TEST_F(Gmlpnp_CameraEquirectangular, everyPixelOfThePicture)
{
    for (int v = 0; v < H; v += 7)
        for (int u = 0; u < W; u += 7) {
            Vec3d ray;
            Point2d again;
            ASSERT_TRUE(camera->unprojectPoint(Point2d(u, v), ray));
            ASSERT_TRUE(camera->projectPoint(ray, again));
            ASSERT_LT(cv::norm(again - Point2d(u, v)), 1e-9) << u << " " << v;
        }
}

TEST_F(Gmlpnp_CameraEquirectangular, thePictureContinuesAround)
{
    Vec3d a, b;
    ASSERT_TRUE(camera->unprojectPoint({-3, 200}, a));
    ASSERT_TRUE(camera->unprojectPoint({W - 3, 200}, b));
    EXPECT_LT(cv::norm(a - b), 1e-14);
}

}  // namespace
}  // namespace opencv_test
