// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../camera/camera_util.hpp"
#include "../scenes.hpp"
#include "../test_data.hpp"

#include <functional>

// The solver behind every lens: it must see rays, whatever the pixels were.

namespace opencv_test {
namespace {

using namespace camera;
using gmlpnp::Result;

// A ray in long double: the pixels of the tests below must not be undone by the code under test.
using Ray = Vec<long double, 3>;

struct WideLens
{
    const char* name;
    Ptr<CameraModel> camera;
    std::function<Ray(const Point2d&)> ray;
};

void PrintTo(const WideLens& lens, std::ostream* out)
{
    *out << lens.name;
}

const double kFocal = 300, kCentre = 640;  // px

Ray unit(long double x, long double y, long double z)
{
    const long double n = std::sqrt(x * x + y * y + z * z);
    return {x / n, y / n, z / n};
}

Vec<long double, 2> plane(const Point2d& pixel)
{
    return {(pixel.x - static_cast<long double>(kCentre)) / kFocal,
            (pixel.y - static_cast<long double>(kCentre)) / kFocal};
}

// The ray at `angle` off the axis, towards (x, y).
Ray atAngle(long double angle, long double x, long double y)
{
    const long double r = std::sqrt(x * x + y * y);
    return r > 0 ? Ray(x / r * std::sin(angle), y / r * std::sin(angle), std::cos(angle)) : Ray(0, 0, 1);
}

// Where a growing function of the angle reaches `radius`: by halving, down to the last bit.
long double angleOf(long double radius, const std::function<long double(long double)>& radiusOf)
{
    long double low = 0, high = static_cast<long double>(115 * kDegree);
    for (int i = 0; i < 200; ++i) {
        const long double middle = (low + high) / 2;
        (radiusOf(middle) < radius ? low : high) = middle;
    }
    return low;
}

WideLens wideFisheye()
{
    static const Vec4d D(-0.02, 0.004, -0.001, 0.0001);
    return {"fisheye", CameraModel::fisheye(matrixK(kFocal, kFocal, kCentre, kCentre), D), [](const Point2d& pixel) {
                const auto p = plane(pixel);
                const long double angle = angleOf(std::hypot(p[0], p[1]), [](long double a) {
                    const long double q = a * a;
                    return a * (1 + q * (D[0] + q * (D[1] + q * (D[2] + q * D[3]))));
                });
                return atAngle(angle, p[0], p[1]);
            }};
}

WideLens wideOmnidir()
{
    static const double xi = 1.5;
    return {"omnidir", CameraModel::omnidir(matrixK(kFocal, kFocal, kCentre, kCentre), noArray(), xi),
            [](const Point2d& pixel) {
                const auto p = plane(pixel);
                const long double angle =
                    angleOf(std::hypot(p[0], p[1]), [](long double a) { return std::sin(a) / (std::cos(a) + xi); });
                return atAngle(angle, p[0], p[1]);
            }};
}

// Its inverse has a closed form: Khomutenko et al. 2016, Eq. (8).
WideLens wideEucm()
{
    static const double alpha = 0.65, beta = 1.1;
    return {"eucm", CameraModel::eucm(matrixK(kFocal, kFocal, kCentre, kCentre), alpha, beta),
            [](const Point2d& pixel) {
                const auto p = plane(pixel);
                const long double a = alpha, q = beta * (p[0] * p[0] + p[1] * p[1]);
                return unit(p[0], p[1], (1 - a * a * q) / (a * std::sqrt(1 - (2 * a - 1) * q) + 1 - a));
            }};
}

struct WideScene
{
    Mat_<double> points = Mat_<double>(0, 3), pixels = Mat_<double>(0, 2), rays = Mat_<double>(0, 3);
    Pose truth;
    int behind = 0;  // points behind the image plane
};

// Points up to 110 degrees off the axis at depths 2 to 8, their pixels with a noise of 1 px.
WideScene wideScene(cv::RNG& rng, const WideLens& lens, int n)
{
    WideScene scene;
    scene.truth = {randomRotation(rng), gaussian3(rng)};
    for (int i = 0; i < n; ++i) {
        const double angle = std::acos(rng.uniform(std::cos(110 * kDegree), 1.));
        const Vec3d X = rng.uniform(2., 8.) * direction(angle, rng.uniform(0., 2 * CV_PI));
        const Vector3d p = scene.truth.R.transpose() * (Vector3d(X[0], X[1], X[2]) - scene.truth.t);
        Point2d pixel;
        EXPECT_TRUE(lens.camera->projectPoint(X, pixel));
        pixel += Point2d(rng.gaussian(1), rng.gaussian(1));
        const Ray ray = lens.ray(pixel);
        scene.behind += X[2] < 0;
        scene.points.push_back(Mat(Matx13d(p.x(), p.y(), p.z())));
        scene.pixels.push_back(Mat(Matx12d(pixel.x, pixel.y)));
        scene.rays.push_back(
            Mat(Matx13d(static_cast<double>(ray[0]), static_cast<double>(ray[1]), static_cast<double>(ray[2]))));
    }
    return scene;
}

class Gmlpnp_SolveWideLens : public testing::TestWithParam<WideLens>
{};

// 220 degrees: one third of the pixels is behind the image plane.
TEST_P(Gmlpnp_SolveWideLens, equals_solveRays_on_rays_computed_apart)
{
    const WideLens& lens = GetParam();
    cv::RNG rng = testRng();
    for (int method : {gmlpnp::SOLVEPNP_GMLPNP, gmlpnp::SOLVEPNP_GMLPNP_MARGINAL}) {
        const WideScene scene = wideScene(rng, lens, 120);
        ASSERT_GT(scene.behind, 20);
        gmlpnp::Params params;
        params.method = method;
        Result byPixels, byRays;
        ASSERT_TRUE(gmlpnp::solve(scene.points, scene.pixels, makePtr<PlainLens>(lens.camera), byPixels, params));
        ASSERT_TRUE(gmlpnp::solveRays(scene.points, scene.rays, byRays, params));
        EXPECT_EQ(scene.points.rows, byPixels.usedPoints);
        EXPECT_EQ(byRays.status, byPixels.status);
        EXPECT_TRUE(poseNear(byPixels, poseOf(byRays.rvec, byRays.tvec), 1e-9, 1e-9));
        EXPECT_TRUE(matrixNear(matrix3(byPixels.objectNoise), matrix3(byRays.objectNoise), 1e-9));
        EXPECT_TRUE(matrixNear(matrix3(byPixels.bearingNoise), matrix3(byRays.bearingNoise), 1e-9));
        EXPECT_TRUE(matrixNear(matrix6(byPixels.poseCovariance), matrix6(byRays.poseCovariance), 1e-9));
        // And the lens itself finds the right pose: 1 px is 8 mrad at most, over the root of 120 points and with the
        // translation free.
        ASSERT_TRUE(gmlpnp::solve(scene.points, scene.pixels, lens.camera, byPixels, params));
        EXPECT_TRUE(poseNear(byPixels, scene.truth, 6e-3, 2e-2));
    }
}

INSTANTIATE_TEST_SUITE_P(Lenses, Gmlpnp_SolveWideLens, testing::Values(wideFisheye(), wideOmnidir(), wideEucm()));

// Real pixels of a real catadioptric camera. The calibration minimises the sum of squared pixel errors, so nothing can
// be below it by much. The estimated noise weighs the pixels otherwise, tails more so; that must cost little.
TEST(Gmlpnp_SolveLenses, chessboards_of_an_omnidirectional_camera)
{
    const BoardCalibration boards = omnidirChessboard();
    if (boards.views.empty())
        GMLPNP_SKIP(kNoData);
    for (const bool robust : {false, true}) {
        gmlpnp::Params params;
        params.robust = robust;
        double ours = 0, calibrated = 0;
        for (size_t i = 0; i < boards.views.size(); ++i) {
            SCOPED_TRACE(testing::Message() << "view " << i << (robust ? " robust" : ""));
            const BoardView& view = boards.views[i];
            Result result;
            ASSERT_TRUE(gmlpnp::solve(view.corners, view.pixels, boards.camera, result, params));
            EXPECT_EQ(view.corners.rows, result.usedPoints);
            const double here = squaredPixelErrors(*boards.camera, view, result.rvec, result.tvec);
            const double there = squaredPixelErrors(*boards.camera, view, view.rvec, view.tvec);
            EXPECT_NEAR(std::sqrt(here / there), 1, robust ? 0.06 : 0.02);
            ours += here;
            calibrated += there;
        }
        EXPECT_NEAR(std::sqrt(ours / calibrated), 1, 0.02);  // all 810 corners
    }
}

class Gmlpnp_SolveMasked : public testing::Test
{
protected:
    // Alpha above 1/2: pixels outside r^2 = 1 / (beta (2 alpha - 1)) have no ray.
    const Ptr<CameraModel> camera = wideEucm().camera;
    const Point2d outside{kCentre + 3 * kFocal, kCentre};

    void SetUp() override
    {
        Vec3d ray;
        ASSERT_FALSE(camera->unprojectPoint(outside, ray));
    }
};

TEST_F(Gmlpnp_SolveMasked, pixels_without_ray_do_not_take_part)
{
    cv::RNG rng = testRng();
    const WideScene scene = wideScene(rng, wideEucm(), 40);
    Mat_<double> pixels = scene.pixels.clone(), keptPoints(0, 3), keptPixels(0, 2);
    for (int i = 0; i < 40; ++i)
        if (i % 4 == 1) {
            pixels(i, 0) = outside.x + i;
            pixels(i, 1) = outside.y - i;
        } else {
            keptPoints.push_back(scene.points.row(i));
            keptPixels.push_back(scene.pixels.row(i));
        }
    Result masked, kept;
    ASSERT_TRUE(gmlpnp::solve(scene.points, pixels, camera, masked));
    ASSERT_TRUE(gmlpnp::solve(keptPoints, keptPixels, camera, kept));
    EXPECT_EQ(30, masked.usedPoints);
    EXPECT_EQ(kept.rvec, masked.rvec);
    EXPECT_EQ(kept.tvec, masked.tvec);
    EXPECT_EQ(kept.cost, masked.cost);
    EXPECT_EQ(0, cv::norm(kept.poseCovariance, masked.poseCovariance, cv::NORM_INF));
    ASSERT_EQ(40, masked.weights.rows);
    for (int i = 0; i < 40; ++i)
        EXPECT_EQ(i % 4 == 1, masked.weights.at<double>(i) == 0) << i;
}

TEST_F(Gmlpnp_SolveMasked, too_few_rays_are_too_few_points)
{
    cv::RNG rng = testRng();
    const WideScene scene = wideScene(rng, wideEucm(), 12);
    for (int rays : {0, 3, 4}) {
        Mat_<double> pixels = scene.pixels.clone();
        for (int i = rays; i < 12; ++i)
            pixels(i, 0) = outside.x, pixels(i, 1) = outside.y;
        Result result;
        EXPECT_EQ(rays >= 4, gmlpnp::solve(scene.points, pixels, camera, result)) << rays;
        if (rays < 4) {
            EXPECT_EQ(gmlpnp::STATUS_TOO_FEW_POINTS, result.status) << rays;
        } else {
            EXPECT_EQ(rays, result.usedPoints);
        }
    }
}

}  // namespace
}  // namespace opencv_test
