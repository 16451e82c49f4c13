// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "every_lens.hpp"

// The derivative of the ray by the pixel, of every lens.

namespace opencv_test {
namespace {

using namespace camera;

// Pixels in a radian at the optical axis.
double pixelsPerRadian(const CameraModel& camera)
{
    Point2d centre, aside;
    EXPECT_TRUE(camera.projectPoint(Vec3d(0, 0, 1), centre) && camera.projectPoint(Vec3d(1e-5, 0, 1), aside));
    return cv::norm(aside - centre) / 1e-5;
}

TEST_P(Gmlpnp_Camera, jacobianIsTheDerivativeAndTangent)
{
    int compared = 0;
    for (const Vec3d& m : grid) {
        Point2d pixel;
        Vec3d ray;
        Matx32d J, Jn;
        ASSERT_TRUE(camera->projectPoint(m, pixel));
        ASSERT_TRUE(camera->unprojectPoint(pixel, ray, &J));
        const double size = cv::norm(J);
        ASSERT_LT(cv::norm(ray.t() * J), 1e-13 * size) << m;
        if (!numericJacobian(*camera, pixel, 1e-4 / size, Jn))
            continue;  // a neighbour lies outside of the domain
        ASSERT_LT(cv::norm(J - Jn), 1e-8 * size) << m << "\n" << J << "\n" << Jn;
        ++compared;
    }
    EXPECT_GT(compared, static_cast<int>(grid.size() * 9 / 10));
}

// The Jacobian leads along the sphere to the ray whose pixel is the moved one: project() is the independent side.
TEST_P(Gmlpnp_Camera, jacobianAgreesWithProjection)
{
    for (const Vec3d& m : grid) {
        Point2d pixel, moved;
        Vec3d ray;
        Matx32d J;
        ASSERT_TRUE(camera->projectPoint(m, pixel));
        ASSERT_TRUE(camera->unprojectPoint(pixel, ray, &J));
        const Vec2d step(1e-5, -2e-5);  // px
        ASSERT_TRUE(camera->projectPoint(ray + J * step, moved));
        ASSERT_LT(cv::norm(moved - pixel - Point2d(step)), 1e-8 + 1e-12 * cv::norm(pixel)) << m;
    }
}

// The angle that a pixel spans around the axis, by the Jacobian. Distortion of the plane may be left out of it, and
// where fx and fy differ the axis sees their mean; a panorama has no axis.
TEST_P(Gmlpnp_Camera, angularScaleIsThatOfTheJacobianAroundTheAxis)
{
    const std::string name = GetParam().name;
    if (name == "equirectangular")
        return;
    const std::set<std::string> distorted = {"pinhole4",  "pinhole5",    "pinhole8",       "pinhole12",
                                             "pinhole14", "omnidirUnit", "omnidirLargeXi", "omnidirSmallXi"};
    const bool exact = distorted.count(name) == 0;
    const double focal = pixelsPerRadian(*camera);
    for (const Vec3d& m : polarGrid((exact ? GetParam().maxAngle : 15) * kDegree)) {
        Point2d pixel;
        Vec3d ray;
        Matx32d J;
        ASSERT_TRUE(camera->projectPoint(m, pixel) && camera->unprojectPoint(pixel, ray, &J)) << m;
        double scale = 0;
        camera->angularScales(&m, 1, &scale);
        const double sine = std::hypot(m[0], m[1]);
        const Vec3d around = sine > 0 ? Vec3d(-m[1], m[0], 0) / sine : Vec3d(1, 0, 0);
        EXPECT_NEAR(1, scale / (cv::norm(J.t() * around) * focal), exact ? 0.005 : 0.1) << m;
    }
}

TEST_P(Gmlpnp_Camera, orientationIsKept)
{
    for (const Vec3d& m : grid) {
        Point2d pixel;
        Vec3d ray;
        Matx32d J;
        ASSERT_TRUE(camera->projectPoint(m, pixel));
        ASSERT_TRUE(camera->unprojectPoint(pixel, ray, &J));
        const Vec3d x(J(0, 0), J(1, 0), J(2, 0)), y(J(0, 1), J(1, 1), J(2, 1));
        ASSERT_GT(x.cross(y).dot(ray), 0) << m;  // x right, y down, z forward: never folded over
    }
}

}  // namespace
}  // namespace opencv_test
