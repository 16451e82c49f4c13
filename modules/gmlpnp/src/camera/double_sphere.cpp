// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "common.hpp"

// Double sphere (Usenko, Demmel and Cremers 2018), -1 < xi < 1, alpha in [0, 1]:
//
//     d1 = |X|,   z1 = xi d1 + Z,   d2 = sqrt(X^2 + Y^2 + z1^2),   (x, y) = (X, Y) / (alpha d2 + (1 - alpha) z1)
//     u = fx x + skew y + cx,   v = fy y + cy
//
// and back, with q = x^2 + y^2:
//
//     z = (1 - alpha^2 q) / (alpha sqrt(1 - (2 alpha - 1) q) + 1 - alpha)
//     s = (xi z + sqrt(z^2 + (1 - xi^2) q)) / (z^2 + q),   m = (s x, s y, s z - xi)
//
// Valid domain: z1 > -w d2, w = alpha / (1 - alpha) for alpha <= 1/2, else (1 - alpha) / alpha: the second sphere is
// seen up to this angle, and |xi| < 1 makes the first one-to-one with it. Of pixels, all for alpha <= 1/2, else
// q < 1 / (2 alpha - 1). The paper's closed form of the bound, Z > -w2 d1 with w2 = (w + xi) / sqrt(2 w xi + xi^2 + 1),
// equals this one at w = 1 or xi = 0 only: elsewhere it leaves out directions that the lens sees, or, with xi < 0 and a
// small w, lets in some that it does not.

namespace cv {
namespace gmlpnp {
namespace detail {
namespace {

const double kLargestXi = 1 - 1e-9;  // open interval (-1, 1)

class DoubleSphere : public CameraModel
{
public:
    DoubleSphere(const Intrinsics& intrinsics, double xi_, double alpha_)
        : k(intrinsics), xi(xi_), alpha(alpha_), w(alpha_ <= 0.5 ? alpha_ / (1 - alpha_) : (1 - alpha_) / alpha_)
    {}

    bool unprojectPoint(const Point2d& pixel, Vec3d& ray, Matx32d* jacobian) const override
    {
        const Point2d p = k.planeOf(pixel);
        const double q = p.x * p.x + p.y * p.y, square = 1 - (2 * alpha - 1) * q;
        if (!(square > 0 && q < kLargestSquaredRadius))
            return false;
        const double root1 = std::sqrt(square), below = alpha * root1 + 1 - alpha;
        const double z = (1 - alpha * alpha * q) / below;
        const double root2 = std::sqrt(z * z + (1 - xi * xi) * q), norm2 = z * z + q, s = (xi * z + root2) / norm2;
        ray = Vec3d(s * p.x, s * p.y, s * z - xi);
        if (jacobian) {
            // Twice the derivatives of z and s by q.
            const double dz = alpha * (z * (2 * alpha - 1) / root1 - 2 * alpha) / below;
            const double ds = (xi * dz + (z * dz + 1 - xi * xi) / root2 - 2 * s * (z * dz + 1)) / norm2;
            const double along = z * ds + s * dz;
            *jacobian = k.byPixel(Matx32d(s + ds * p.x * p.x, ds * p.x * p.y, ds * p.x * p.y, s + ds * p.y * p.y,
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
        if (!(xi + m[2] > -w * distance2(m) && rho > 0))
            return false;
        return k.pixelOf({m[0] / rho, m[1] / rho}, pixel);
    }

    void angularScales(const Vec3d* rays, int count, double* scales) const override
    {
        for (int i = 0; i < count; ++i)
            scales[i] = divisor(rays[i]) / (1 + xi);
    }

    void write(FileStorage& fs) const override
    {
        fs.write("model", "doubleSphere");
        fs.write("K", Mat(k.matrix()));
        fs.write("xi", xi);
        fs.write("alpha", alpha);
    }

private:
    double distance2(const Vec3d& m) const
    {
        const double z1 = xi + m[2];
        return std::sqrt(m[0] * m[0] + m[1] * m[1] + z1 * z1);
    }
    double divisor(const Vec3d& m) const { return alpha * distance2(m) + (1 - alpha) * (xi + m[2]); }

    Intrinsics k;
    double xi, alpha;
    double w;  // the domain is z1 > -w d2
};

}  // namespace
}  // namespace detail

Ptr<CameraModel> CameraModel::doubleSphere(InputArray K, double xi, double alpha)
{
    detail::requireRange(xi, -detail::kLargestXi, detail::kLargestXi, "xi");
    detail::requireRange(alpha, 0, 1, "alpha");
    return makePtr<detail::DoubleSphere>(detail::intrinsicsFrom(K), xi, alpha);
}

}  // namespace gmlpnp
}  // namespace cv
