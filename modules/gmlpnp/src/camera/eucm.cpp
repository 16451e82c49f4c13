// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "lens.hpp"

// The enhanced unified camera (Khomutenko, Garcia and Martinet 2016), alpha in [0, 1], beta > 0:
//
//     d = sqrt(beta (X^2 + Y^2) + Z^2),   (x, y) = (X, Y) / (alpha d + (1 - alpha) Z)
//     u = fx x + skew y + cx,   v = fy y + cy
//
// and back, with q = x^2 + y^2:
//
//     z = (1 - alpha^2 beta q) / (alpha sqrt(1 - (2 alpha - 1) beta q) + 1 - alpha),   ray along (x, y, z)
//
// The valid domain is Z > -w d with w = alpha / (1 - alpha) for alpha <= 1/2, else (1 - alpha) / alpha. Every pixel
// has a ray for alpha <= 1/2, else those with beta q < 1 / (2 alpha - 1) have one. The angular scale of a unit ray is
// alpha d + (1 - alpha) m3.

namespace cv {
namespace gmlpnp {
namespace detail {
namespace {

constexpr double SMALLEST_BETA = 1e-9, LARGEST_BETA = 1e9;  // far beyond any lens, which has a beta of about 1

class Eucm final : public LensOf<Eucm>
{
public:
    Eucm(InputArray K, double alpha, double beta)
        : LensOf("eucm", intrinsicsFrom(K)),
          alpha_(alpha),
          beta_(beta),
          w_(alpha <= 0.5 ? alpha / (1 - alpha) : (1 - alpha) / alpha)
    {}

    bool unprojectPoint(const Point2d& pixel, Vec3d& ray, Matx32d* jacobian) const override
    {
        const Point2d p = k_.planeOf(pixel);
        const double q = p.x * p.x + p.y * p.y, square = 1 - (2 * alpha_ - 1) * beta_ * q;
        if (!(square > 0 && q < LARGEST_SQUARED_RADIUS))
            return false;
        const double root = std::sqrt(square), below = alpha_ * root + 1 - alpha_;
        const double z = (1 - alpha_ * alpha_ * beta_ * q) / below;
        const double norm = std::sqrt(q + z * z);
        ray = Vec3d(p.x / norm, p.y / norm, z / norm);
        if (jacobian) {
            const double dz = alpha_ * beta_ * (z * (2 * alpha_ - 1) / root - 2 * alpha_) / below;  // 2 dz/dq
            *jacobian = k_.byPixel(unitJacobian(ray, norm, Matx32d(1, 0, 0, 1, dz * p.x, dz * p.y)));
        }
        return true;
    }

    bool projectPoint(const Vec3d& point, Point2d& pixel) const override
    {
        Vec3d m;
        if (!unitVector(point, m))
            return false;
        const double rho = divisor(m);
        if (!(m[2] > -w_ * distance(m) && rho > 0))
            return false;
        return k_.pixelOf({m[0] / rho, m[1] / rho}, pixel);
    }

private:
    friend LensOf<Eucm>;

    double angularScale(const Vec3d& ray) const { return divisor(ray); }

    void writeParameters(FileStorage& fs) const override
    {
        fs.write("alpha", alpha_);
        fs.write("beta", beta_);
    }

    double distance(const Vec3d& m) const { return std::sqrt(beta_ * (m[0] * m[0] + m[1] * m[1]) + m[2] * m[2]); }
    double divisor(const Vec3d& m) const { return alpha_ * distance(m) + (1 - alpha_) * m[2]; }

    double alpha_, beta_;
    double w_;  // the domain is Z > -w d
};

}  // namespace
}  // namespace detail

Ptr<CameraModel> CameraModel::eucm(InputArray K, double alpha, double beta)
{
    detail::requireRange(alpha, 0, 1, "alpha");
    detail::requireRange(beta, detail::SMALLEST_BETA, detail::LARGEST_BETA, "beta");
    return makePtr<detail::Eucm>(K, alpha, beta);
}

}  // namespace gmlpnp
}  // namespace cv
