// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_TEST_GMLPNP_WIDE_LENS_HPP
#define OPENCV_TEST_GMLPNP_WIDE_LENS_HPP

#include <functional>

#include "../camera/camera_util.hpp"
#include "../scenes.hpp"

// Lenses that see behind the image plane, with their rays computed apart from the code under test.

namespace opencv_test {
namespace wide {

using namespace camera;

// A ray in long double: the pixels of the tests below must not be undone by the code under test.
using Ray = Vec<long double, 3>;

struct WideLens
{
    const char* name;
    Ptr<CameraModel> camera;
    std::function<Ray(const Point2d&)> ray;
};

inline void PrintTo(const WideLens& lens, std::ostream* out)
{
    *out << lens.name;
}

// px
constexpr double kFocal = 300, kCentre = 640;

inline Ray unit(long double x, long double y, long double z)
{
    const long double n = std::sqrt(x * x + y * y + z * z);
    return {x / n, y / n, z / n};
}

inline Vec<long double, 2> plane(const Point2d& pixel)
{
    return {(pixel.x - static_cast<long double>(kCentre)) / kFocal,
            (pixel.y - static_cast<long double>(kCentre)) / kFocal};
}

// The ray at `angle` off the axis, towards (x, y).
inline Ray atAngle(long double angle, long double x, long double y)
{
    const long double r = std::sqrt(x * x + y * y);
    return r > 0 ? Ray(x / r * std::sin(angle), y / r * std::sin(angle), std::cos(angle)) : Ray(0, 0, 1);
}

// Where a growing function of the angle reaches `radius`: by halving, down to the last bit.
inline long double angleOf(long double radius, const std::function<long double(long double)>& radiusOf)
{
    long double low = 0, high = static_cast<long double>(115 * kDegree);
    for (int i = 0; i < 200; ++i) {
        const long double middle = (low + high) / 2;
        (radiusOf(middle) < radius ? low : high) = middle;
    }
    return low;
}

inline WideLens wideFisheye()
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

inline WideLens wideOmnidir()
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
inline WideLens wideEucm()
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
inline WideScene wideScene(cv::RNG& rng, const WideLens& lens, int n)
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

}  // namespace wide
}  // namespace opencv_test

#endif  // OPENCV_TEST_GMLPNP_WIDE_LENS_HPP
