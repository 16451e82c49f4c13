// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "common.hpp"

// Enhanced unified camera (Khomutenko, Garcia and Martinet 2016), alpha in [0, 1], beta > 0:
//
//     d = sqrt(beta (X^2 + Y^2) + Z^2),   (x, y) = (X, Y) / (alpha d + (1 - alpha) Z)
//     u = fx x + skew y + cx,   v = fy y + cy
//
// and back, with q = x^2 + y^2:
//
//     z = (1 - alpha^2 beta q) / (alpha sqrt(1 - (2 alpha - 1) beta q) + 1 - alpha),   ray along (x, y, z)
//
// Valid domain: Z > -w d, w = alpha / (1 - alpha) for alpha <= 1/2, else (1 - alpha) / alpha; of pixels, all for
// alpha <= 1/2, else beta q < 1 / (2 alpha - 1).

namespace cv {
namespace gmlpnp {
namespace detail {
namespace {

const double kSmallestBeta = 1e-9, kLargestBeta = 1e9;

class Eucm : public CameraModel
{
public:
    Eucm(const Intrinsics& intrinsics, double alpha_, double beta_)
        : k(intrinsics), alpha(alpha_), beta(beta_), w(alpha_ <= 0.5 ? alpha_ / (1 - alpha_) : (1 - alpha_) / alpha_)
    {}

    bool unprojectPoint(const Point2d& pixel, Vec3d& ray, Matx32d* jacobian) const override
    {
        const Point2d p = k.planeOf(pixel);
        const double q = p.x * p.x + p.y * p.y, square = 1 - (2 * alpha - 1) * beta * q;
        if (!(square > 0 && q < kLargestSquaredRadius))
            return false;
        const double root = std::sqrt(square), below = alpha * root + 1 - alpha;
        const double z = (1 - alpha * alpha * beta * q) / below;
        const double norm = std::sqrt(q + z * z);
        ray = Vec3d(p.x / norm, p.y / norm, z / norm);
        if (jacobian) {
            // Twice the derivative of z by q.
            const double dz = alpha * beta * (z * (2 * alpha - 1) / root - 2 * alpha) / below;
            *jacobian = k.byPixel(unitJacobian(ray, norm, Matx32d(1, 0, 0, 1, dz * p.x, dz * p.y)));
        }
        return true;
    }

    bool projectPoint(const Vec3d& point, Point2d& pixel) const override
    {
        Vec3d m;
        if (!unitVector(point, m))
            return false;
        const double rho = divisor(m);
        if (!(m[2] > -w * distance(m) && rho > 0))
            return false;
        return k.pixelOf({m[0] / rho, m[1] / rho}, pixel);
    }

    void angularScales(const Vec3d* rays, int count, double* scales) const override
    {
        for (int i = 0; i < count; ++i)
            scales[i] = divisor(rays[i]);
    }

    void write(FileStorage& fs) const override
    {
        fs.write("model", "eucm");
        fs.write("K", Mat(k.matrix()));
        fs.write("alpha", alpha);
        fs.write("beta", beta);
    }

private:
    double distance(const Vec3d& m) const { return std::sqrt(beta * (m[0] * m[0] + m[1] * m[1]) + m[2] * m[2]); }
    double divisor(const Vec3d& m) const { return alpha * distance(m) + (1 - alpha) * m[2]; }

    Intrinsics k;
    double alpha, beta;
    double w;  // the domain is Z > -w d
};

}  // namespace
}  // namespace detail

Ptr<CameraModel> CameraModel::eucm(InputArray K, double alpha, double beta)
{
    detail::requireRange(alpha, 0, 1, "alpha");
    detail::requireRange(beta, detail::kSmallestBeta, detail::kLargestBeta, "beta");
    return makePtr<detail::Eucm>(detail::intrinsicsFrom(K), alpha, beta);
}

}  // namespace gmlpnp
}  // namespace cv
