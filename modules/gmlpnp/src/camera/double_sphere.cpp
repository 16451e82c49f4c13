// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "lens.hpp"

// The double sphere camera (Usenko, Demmel and Cremers 2018), -1 < xi < 1, alpha in [0, 1]:
//
//     d1 = |X|,   z1 = xi d1 + Z,   d2 = sqrt(X^2 + Y^2 + z1^2),   (x, y) = (X, Y) / (alpha d2 + (1 - alpha) z1)
//     u = fx x + skew y + cx,   v = fy y + cy
//
// and back, with q = x^2 + y^2:
//
//     z = (1 - alpha^2 q) / (alpha sqrt(1 - (2 alpha - 1) q) + 1 - alpha)
//     s = (xi z + sqrt(z^2 + (1 - xi^2) q)) / (z^2 + q),   m = (s x, s y, s z - xi)
//
// The valid domain is z1 > -w d2 with w = alpha / (1 - alpha) for alpha <= 1/2, else (1 - alpha) / alpha. The lens sees
// the second sphere up to this angle, and |xi| < 1 makes the first sphere one-to-one with the second. For alpha <= 1/2
// every pixel has a ray, else those with q < 1 / (2 alpha - 1) have one. The angular scale of a unit ray is
// (alpha d2 + (1 - alpha) z1) / (1 + xi).
//
// The paper's closed form of the bound is Z > -w2 d1 with w2 = (w + xi) / sqrt(2 w xi + xi^2 + 1). It equals ours only
// at w = 1 or xi = 0. Elsewhere it excludes directions that the lens sees; with xi < 0 and a small w it admits
// directions that the lens does not see.

namespace cv {
namespace gmlpnp {
namespace detail {
namespace {

constexpr double LARGEST_XI = 1 - 1e-9;  // the model needs |xi| < 1

class DoubleSphere final : public LensOf<DoubleSphere>
{
public:
    DoubleSphere(InputArray K, double xi, double alpha)
        : LensOf("doubleSphere", intrinsicsFrom(K)),
          xi_(xi),
          alpha_(alpha),
          w_(alpha <= 0.5 ? alpha / (1 - alpha) : (1 - alpha) / alpha)
    {}

    bool unprojectPoint(const Point2d& pixel, Vec3d& ray, Matx32d* jacobian) const override
    {
        const Point2d p = k_.planeOf(pixel);
        const double q = p.x * p.x + p.y * p.y, square = 1 - (2 * alpha_ - 1) * q;
        if (!(square > 0 && q < LARGEST_SQUARED_RADIUS))
            return false;
        const double root1 = std::sqrt(square), below = alpha_ * root1 + 1 - alpha_;
        const double z = (1 - alpha_ * alpha_ * q) / below;
        const double root2 = std::sqrt(z * z + (1 - xi_ * xi_) * q), norm2 = z * z + q, s = (xi_ * z + root2) / norm2;
        ray = Vec3d(s * p.x, s * p.y, s * z - xi_);
        if (jacobian) {
            // dz and ds are twice the derivatives of z and s by q.
            const double dz = alpha_ * (z * (2 * alpha_ - 1) / root1 - 2 * alpha_) / below;
            const double ds = (xi_ * dz + (z * dz + 1 - xi_ * xi_) / root2 - 2 * s * (z * dz + 1)) / norm2;
            const double along = z * ds + s * dz;
            *jacobian = k_.byPixel(Matx32d(s + ds * p.x * p.x, ds * p.x * p.y, ds * p.x * p.y, s + ds * p.y * p.y,
                                           along * p.x, along * p.y));
        }
        return true;
    }

    bool projectPoint(const Vec3d& point, Point2d& pixel) const override
    {
        Vec3d m;
        if (!unitVector(point, m))
            return false;
        const double rho = divisor(m);
        if (!(xi_ + m[2] > -w_ * distance2(m) && rho > 0))
            return false;
        return k_.pixelOf({m[0] / rho, m[1] / rho}, pixel);
    }

private:
    friend LensOf<DoubleSphere>;

    double angularScale(const Vec3d& ray) const { return divisor(ray) / (1 + xi_); }

    void writeParameters(FileStorage& fs) const override
    {
        fs.write("xi", xi_);
        fs.write("alpha", alpha_);
    }

    double distance2(const Vec3d& m) const
    {
        const double z1 = xi_ + m[2];
        return std::sqrt(m[0] * m[0] + m[1] * m[1] + z1 * z1);
    }
    double divisor(const Vec3d& m) const { return alpha_ * distance2(m) + (1 - alpha_) * (xi_ + m[2]); }

    double xi_, alpha_;
    double w_;  // the domain is z1 > -w d2
};

}  // namespace
}  // namespace detail

Ptr<CameraModel> CameraModel::doubleSphere(InputArray K, double xi, double alpha)
{
    detail::requireRange(xi, -detail::LARGEST_XI, detail::LARGEST_XI, "xi");
    detail::requireRange(alpha, 0, 1, "alpha");
    return makePtr<detail::DoubleSphere>(K, xi, alpha);
}

}  // namespace gmlpnp
}  // namespace cv
