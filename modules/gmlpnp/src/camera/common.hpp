// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_CAMERA_COMMON_HPP
#define OPENCV_GMLPNP_CAMERA_COMMON_HPP

#include "../precomp.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

// The mathematics that several lenses need: unit rays and their derivatives, and functions of one variable.

/** Largest squared distance of a point on the image plane from its centre. It is a limit of the range of doubles: the
ray of a point further out has no digits left, and its squares would overflow. */
constexpr double LARGEST_SQUARED_RADIUS = 1e60;

inline bool isFinite(const Point2d& p)
{
    return std::isfinite(p.x) && std::isfinite(p.y);
}

/** Sets the unit vector along v, which may have any length short of overflow. Returns false for zero and for a vector
that is not finite. */
inline bool unitVector(const Vec3d& v, Vec3d& unit)
{
    const double size = std::max(std::abs(v[0]), std::max(std::abs(v[1]), std::abs(v[2])));
    if (!(size > 0) || !std::isfinite(v[0] + v[1] + v[2]))
        return false;
    const Vec3d scaled(v[0] / size, v[1] / size, v[2] / size);
    unit = scaled * (1 / std::sqrt(scaled.dot(scaled)));
    return true;
}

/** Returns the derivative of m = v/|v|, which is (I - m m^T) J / |v| for the derivative J of v. */
inline Matx32d unitJacobian(const Vec3d& m, double norm, const Matx32d& J)
{
    const double w = 1 / norm;
    const double along0 = m[0] * J(0, 0) + m[1] * J(1, 0) + m[2] * J(2, 0);
    const double along1 = m[0] * J(0, 1) + m[1] * J(1, 1) + m[2] * J(2, 1);
    return {w * (J(0, 0) - along0 * m[0]), w * (J(0, 1) - along1 * m[0]), w * (J(1, 0) - along0 * m[1]),
            w * (J(1, 1) - along1 * m[1]), w * (J(2, 0) - along0 * m[2]), w * (J(2, 1) - along1 * m[2])};
}

inline Matx22d inverse(const Matx22d& M)
{
    const double w = 1 / (M(0, 0) * M(1, 1) - M(0, 1) * M(1, 0));
    return {M(1, 1) * w, -M(0, 1) * w, -M(1, 0) * w, M(0, 0) * w};
}

/** Returns c[0] + c[1] x + ... + c[degree] x^degree. */
inline double polynomial(const double* c, int degree, double x)
{
    double value = c[degree];
    while (degree > 0)
        value = value * x + c[--degree];
    return value;
}

/** Returns the smallest positive root of a polynomial of degree <= 8 that is positive at 0, or infinity where there is
none below 1e12. The root is exact to the last digit and is approached from below: the polynomial is positive on
[0, root). */
CV_EXPORTS double firstPositiveRoot(const double* c, int degree);

/** Solves f(x) = target for a function that increases on [low, high], f(low) <= target <= f(high). It takes Newton
steps, and bisects where they leave the bracket or do not halve the residual.
@param f f(x, slope) returns the value and sets the slope.
@param target value to reach.
@param low, high bracket.
@param start where the first step starts; a start outside the bracket is replaced by its middle.
@param tolerance relative: the iteration stops when the step is within `tolerance` of x and the residual is small. */
template <class Function>
double solveIncreasing(const Function& f, double target, double low, double high, double start, double tolerance)
{
    constexpr int MAX_STEPS = 100;
    constexpr double SMALL_RESIDUAL = 1e-9;  // rounding, relative: near a pole steps are short far from the solution
    const double smallResidual = std::max(tolerance, SMALL_RESIDUAL);
    double x = start >= low && start < high ? start : 0.5 * (low + high);
    double before = std::numeric_limits<double>::infinity();
    for (int step = 0; step < MAX_STEPS; ++step) {
        double slope = 0;
        const double excess = f(x, slope) - target;
        if (excess == 0)
            break;
        (excess > 0 ? high : low) = x;
        const double move = excess / slope;
        if (std::abs(move) <= tolerance * x && std::abs(excess) <= smallResidual * std::abs(target))
            return std::min(std::max(x - move, low), high);
        const bool halved = std::abs(excess) <= 0.5 * before;
        x = halved && x - move > low && x - move < high ? x - move : 0.5 * (low + high);
        before = std::abs(excess);
    }
    return x;
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_CAMERA_COMMON_HPP
