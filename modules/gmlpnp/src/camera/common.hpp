// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_CAMERA_COMMON_HPP
#define OPENCV_GMLPNP_CAMERA_COMMON_HPP

#include "../precomp.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

// What the lenses share: the camera matrix, the parameters' checks, the way from a vector to a unit ray and its
// derivative, and two small tools of one variable.

inline bool isFinite(const Point2d& p)
{
    return std::isfinite(p.x) && std::isfinite(p.y);
}

/** The affine end of every lens: u = fx x + skew y + cx, v = fy y + cy. */
class Intrinsics
{
public:
    Intrinsics(double fx_, double fy_, double skew_, double cx_, double cy_)
        : fx(fx_), fy(fy_), skew(skew_), cx(cx_), cy(cy_), wx(1 / fx_), wy(1 / fy_)
    {}

    // False, and nothing written, where the pixel is beyond the range of a double.
    bool pixelOf(const Point2d& p, Point2d& pixel) const
    {
        const Point2d found(fx * p.x + skew * p.y + cx, fy * p.y + cy);
        if (!isFinite(found))
            return false;
        pixel = found;
        return true;
    }

    Point2d planeOf(const Point2d& pixel) const
    {
        const double y = (pixel.y - cy) * wy;
        return {(pixel.x - cx - skew * y) * wx, y};
    }

    // J * d(plane)/d(pixel): from a derivative by the plane to the derivative by the pixel.
    Matx32d byPixel(const Matx32d& J) const
    {
        const double xy = -skew * wx * wy;
        return {J(0, 0) * wx, J(0, 0) * xy + J(0, 1) * wy, J(1, 0) * wx, J(1, 0) * xy + J(1, 1) * wy,
                J(2, 0) * wx, J(2, 0) * xy + J(2, 1) * wy};
    }

    Intrinsics withoutSkew() const { return {fx, fy, 0, cx, cy}; }

    Matx33d matrix() const { return {fx, skew, cx, 0, fy, cy, 0, 0, 1}; }

private:
    double fx, fy, skew, cx, cy;  // px
    double wx, wy;                // 1 / fx, 1 / fy
};

/** Of a point on the image plane: beyond, its ray has no digits left and squares would overflow. */
const double kLargestSquaredRadius = 1e60;

/** Camera matrix "K", 3x3 of any numeric depth. StsAssert for another shape, StsBadArg for a focal length of zero (less
than 1e-30) or a value that is not finite (more than 1e30): the derivatives of a lens need room. */
Intrinsics intrinsicsFrom(InputArray cameraMatrix);

/** Distortion coefficients "D": a row or column of any numeric depth, none, or one of `counts` of them; returned with
zeros behind the last. StsAssert for another shape or count, StsBadArg for a value that is not finite (more than
1e30). */
std::vector<double> coefficientsFrom(InputArray coefficients, std::initializer_list<int> counts, size_t size);

/** StsBadArg, naming the parameter, unless low <= value <= high (no NaN). */
void requireRange(double value, double low, double high, const char* name);

/** Unit vector along v, of any length short of overflow; false for zero and for what is not finite. */
inline bool unitVector(const Vec3d& v, Vec3d& unit)
{
    const double size = std::max(std::abs(v[0]), std::max(std::abs(v[1]), std::abs(v[2])));
    if (!(size > 0) || !std::isfinite(v[0] + v[1] + v[2]))
        return false;
    const Vec3d scaled(v[0] / size, v[1] / size, v[2] / size);
    unit = scaled * (1 / std::sqrt(scaled.dot(scaled)));
    return true;
}

/** Derivative of v/|v|: (I - m m^T) J / |v| for the derivative J of v and m = v/|v|. */
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

/** c[0] + c[1] x + ... + c[degree] x^degree. */
inline double polynomial(const double* c, int degree, double x)
{
    double value = c[degree];
    while (degree > 0)
        value = value * x + c[--degree];
    return value;
}

/** Smallest positive root of a polynomial of degree <= 8 that is positive at 0, to the last digit and from below: the
polynomial is positive on [0, root). Infinity where it has none below 1e12. */
CV_EXPORTS double firstPositiveRoot(const double* c, int degree);

/** Solves f(x) = target for a function that increases on [low, high], f(low) <= target <= f(high): Newton steps, and
bisection where they leave the bracket or do not halve the residual. f(x, slope) returns the value and sets the slope.
Stops when the step is within `tolerance` of x and the residual small, both relative. */
template <class Function>
double solveIncreasing(const Function& f, double target, double low, double high, double start, double tolerance)
{
    const int kMaxSteps = 100;
    const double kSmallResidual = std::max(tolerance, 1e-9);  // near a pole steps are short far from the solution
    double x = start >= low && start < high ? start : 0.5 * (low + high);
    double before = std::numeric_limits<double>::infinity();
    for (int step = 0; step < kMaxSteps; ++step) {
        double slope = 0;
        const double excess = f(x, slope) - target;
        if (excess == 0)
            break;
        (excess > 0 ? high : low) = x;
        const double move = excess / slope;
        if (std::abs(move) <= tolerance * x && std::abs(excess) <= kSmallResidual * std::abs(target))
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
