// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_TEST_GMLPNP_CAMERA_UTIL_HPP
#define OPENCV_TEST_GMLPNP_CAMERA_UTIL_HPP

#include "../expect_error.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace opencv_test {
namespace camera {

using gmlpnp::CameraModel;

const double kDegree = CV_PI / 180;

inline Matx33d matrixK(double fx, double fy, double cx, double cy, double skew = 0)
{
    return {fx, skew, cx, 0, fy, cy, 0, 0, 1};
}

// The unit vector `angle` off the optical axis, at `azimuth` from x towards y.
inline Vec3d direction(double angle, double azimuth)
{
    return {std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth), std::cos(angle)};
}

// Directions on a polar grid: the axis, close to it, then every degree up to `maxAngle`, at 24 azimuths that avoid the
// axes of the image.
inline std::vector<Vec3d> polarGrid(double maxAngle)
{
    std::vector<Vec3d> grid = {Vec3d(0, 0, 1)};
    for (int step = 0; step * kDegree <= maxAngle; ++step)
        for (int i = 0; i < 24; ++i)
            grid.push_back(direction(1e-9 + step * kDegree, (i + 0.3) * CV_PI / 12));
    return grid;
}

// `count` numbers, evenly spaced from `low` to `high`.
inline std::vector<double> spaced(double low, double high, int count)
{
    std::vector<double> values;
    for (int i = 0; i < count; ++i)
        values.push_back(low + (high - low) * i / (count - 1));
    return values;
}

// Derivative of the ray by the pixel from four evaluations per column; the error is of fourth order in step [px].
inline bool numericJacobian(const CameraModel& camera, const Point2d& pixel, double step, Matx32d& J)
{
    for (int j = 0; j < 2; ++j) {
        const Point2d d = j == 0 ? Point2d(step, 0) : Point2d(0, step);
        Vec3d r[4];
        if (!camera.unprojectPoint(pixel - 2 * d, r[0]) || !camera.unprojectPoint(pixel - d, r[1]) ||
            !camera.unprojectPoint(pixel + d, r[2]) || !camera.unprojectPoint(pixel + 2 * d, r[3]))
            return false;
        for (int i = 0; i < 3; ++i)
            J(i, j) = (r[0][i] - r[3][i] + 8 * (r[2][i] - r[1][i])) / (12 * step);
    }
    return true;
}

// Points of the camera frame around the axis, for comparisons with OpenCV's functions.
inline std::vector<Point3d> pointsInFront(double maxTangent, int side = 21)
{
    std::vector<Point3d> points;
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j) {
            const double depth = 1 + 0.1 * ((i + j) % 5), s = 2 * maxTangent / (side - 1);
            points.emplace_back(depth * (s * i - maxTangent), depth * (s * j - maxTangent), depth);
        }
    return points;
}

}  // namespace camera
}  // namespace opencv_test

#endif  // OPENCV_TEST_GMLPNP_CAMERA_UTIL_HPP
