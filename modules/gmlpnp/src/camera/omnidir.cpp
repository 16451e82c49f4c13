// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "distortion.hpp"
#include "lens.hpp"

// The unified camera with mirror parameter xi >= 0 (Mei and Rives 2007), as in cv::omnidir:
//
//     m = (X, Y, Z) / |X|,   (x, y) = (m1, m2) / (m3 + xi),   (x', y') = G(x, y) with k1, k2, p1, p2
//     u = fx x' + skew y' + cx,   v = fy y' + cy
//
// The lift back, with q = x^2 + y^2 and the real root, is
//
//     f = (xi + sqrt(1 + (1 - xi^2) q)) / (1 + q),   m = (f x, f y, f - xi)
//
// The valid domain is m3 > -w with w = xi for xi <= 1, else 1 / xi. There (x, y) is one-to-one and 1 + (1 - xi^2) q >
// 0. In addition (x, y) must lie in the domain of G (camera/distortion.hpp). The angular scale is (m3 + xi) / (1 + xi);
// it leaves the distortion out.

namespace cv {
namespace gmlpnp {
namespace detail {
namespace {

constexpr size_t DISTORTION_SIZE = 12;  // Distortion takes so many; those behind the four given stay zero
constexpr double LARGEST_XI = 1e6;      // far beyond any lens: here the camera is orthographic

class Omnidir final : public LensOf<Omnidir>
{
public:
    Omnidir(InputArray K, InputArray D, double xi)
        : LensOf("omnidir", intrinsicsFrom(K)),
          D_(coefficientsFrom(D, {4}, DISTORTION_SIZE)),
          distortion_(D_),
          xi_(xi),
          limit_(-(xi <= 1 ? xi : 1 / xi))
    {}

    bool unprojectPoint(const Point2d& pixel, Vec3d& ray, Matx32d* jacobian) const override
    {
        const Point2d distorted = k_.planeOf(pixel);
        Point2d p;
        Matx22d Jdistort;
        if (!isFinite(distorted) || !distortion_.invert(distorted, p, Jdistort))
            return false;
        const double q = p.x * p.x + p.y * p.y, square = 1 + (1 - xi_ * xi_) * q;
        if (!(square > 0 && q < LARGEST_SQUARED_RADIUS))
            return false;
        const double root = std::sqrt(square), f = (xi_ + root) / (1 + q);
        ray = Vec3d(f * p.x, f * p.y, f - xi_);
        if (jacobian) {
            const double df = ((1 - xi_ * xi_) / root - 2 * f) / (1 + q);  // twice the derivative of f by q
            const Matx32d lift(f + df * p.x * p.x, df * p.x * p.y, df * p.x * p.y, f + df * p.y * p.y, df * p.x,
                               df * p.y);
            *jacobian = k_.byPixel(lift * inverse(Jdistort));
        }
        return true;
    }

    bool projectPoint(const Vec3d& point, Point2d& pixel) const override
    {
        Vec3d m;
        if (!unitVector(point, m) || !(m[2] > limit_))
            return false;
        Point2d p(m[0] / (m[2] + xi_), m[1] / (m[2] + xi_));
        return isFinite(p) && distortion_.applyInside(p) && k_.pixelOf(p, pixel);
    }

private:
    friend LensOf<Omnidir>;

    double angularScale(const Vec3d& ray) const { return (ray[2] + xi_) / (1 + xi_); }

    void writeParameters(FileStorage& fs) const override
    {
        fs.write("D", Mat(D_).rowRange(0, 4));
        fs.write("xi", xi_);
    }

    std::vector<double> D_;
    Distortion distortion_;
    double xi_;
    double limit_;  // the domain is m3 > limit
};

}  // namespace
}  // namespace detail

Ptr<CameraModel> CameraModel::omnidir(InputArray K, InputArray D, double xi)
{
    detail::requireRange(xi, 0, detail::LARGEST_XI, "xi");
    return makePtr<detail::Omnidir>(K, D, xi);
}

}  // namespace gmlpnp
}  // namespace cv
