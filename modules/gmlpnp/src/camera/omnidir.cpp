// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "common.hpp"
#include "distortion.hpp"

// Unified camera with mirror parameter xi >= 0 (Mei and Rives 2007), as cv::omnidir:
//
//     m = (X, Y, Z) / |X|,   (x, y) = (m1, m2) / (m3 + xi),   (x', y') = G(x, y) with k1, k2, p1, p2
//     u = fx x' + skew y' + cx,   v = fy y' + cy
//
// The lift back, with q = x^2 + y^2 and the real root:
//
//     f = (xi + sqrt(1 + (1 - xi^2) q)) / (1 + q),   m = (f x, f y, f - xi)
//
// Valid domain: m3 > -w, w = xi for xi <= 1, else 1 / xi: where (x, y) is one-to-one; there 1 + (1 - xi^2) q > 0. And
// (x, y) in the domain of G (camera_distortion.hpp).

namespace cv {
namespace gmlpnp {
namespace detail {
namespace {

constexpr std::initializer_list<int> kCounts = {4};
const size_t kDistortionSize = 12;  // what Distortion takes; the rest stays zero
const double kLargestXi = 1e6;      // far beyond any lens: an orthographic camera

class Omnidir : public CameraModel
{
public:
    Omnidir(const Intrinsics& intrinsics, const std::vector<double>& coefficients, double mirror)
        : k(intrinsics), D(coefficients), distortion(D), xi(mirror), limit(-(mirror <= 1 ? mirror : 1 / mirror))
    {}

    bool unprojectPoint(const Point2d& pixel, Vec3d& ray, Matx32d* jacobian) const override
    {
        const Point2d distorted = k.planeOf(pixel);
        Point2d p;
        Matx22d Jdistort;
        if (!isFinite(distorted) || !distortion.invert(distorted, p, Jdistort))
            return false;
        const double q = p.x * p.x + p.y * p.y, square = 1 + (1 - xi * xi) * q;
        if (!(square > 0 && q < kLargestSquaredRadius))
            return false;
        const double root = std::sqrt(square), f = (xi + root) / (1 + q);
        ray = Vec3d(f * p.x, f * p.y, f - xi);
        if (jacobian) {
            const double df = ((1 - xi * xi) / root - 2 * f) / (1 + q);  // twice the derivative of f by q
            const Matx32d lift(f + df * p.x * p.x, df * p.x * p.y, df * p.x * p.y, f + df * p.y * p.y, df * p.x,
                               df * p.y);
            *jacobian = k.byPixel(lift * inverse(Jdistort));
        }
        return true;
    }

    bool projectPoint(const Vec3d& point, Point2d& pixel) const override
    {
        Vec3d m;
        if (!unitVector(point, m) || !(m[2] > limit))
            return false;
        Point2d p(m[0] / (m[2] + xi), m[1] / (m[2] + xi));
        if (!isFinite(p))
            return false;
        if (!distortion.isNone()) {
            Matx22d J;
            if (!distortion.contains(p))
                return false;
            p = distortion.apply(p, J);
        }
        return k.pixelOf(p, pixel);
    }

    void angularScales(const Vec3d* rays, int count, double* scales) const override
    {
        for (int i = 0; i < count; ++i)
            scales[i] = (rays[i][2] + xi) / (1 + xi);
    }

    void write(FileStorage& fs) const override
    {
        fs.write("model", "omnidir");
        fs.write("K", Mat(k.matrix()));
        fs.write("D", Mat(D).rowRange(0, 4));
        fs.write("xi", xi);
    }

private:
    Intrinsics k;
    std::vector<double> D;
    Distortion distortion;
    double xi;
    double limit;  // of m3, open
};

}  // namespace
}  // namespace detail

Ptr<CameraModel> CameraModel::omnidir(InputArray K, InputArray D, double xi)
{
    detail::requireRange(xi, 0, detail::kLargestXi, "xi");
    return makePtr<detail::Omnidir>(detail::intrinsicsFrom(K),
                                    detail::coefficientsFrom(D, detail::kCounts, detail::kDistortionSize), xi);
}

}  // namespace gmlpnp
}  // namespace cv
