// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "common.hpp"

// Kannala-Brandt, as cv::fisheye but for the whole sphere. With theta the angle off the axis and phi the azimuth,
//
//     theta = atan2(sqrt(X^2 + Y^2), Z)   in [0, pi]
//     theta_d = theta (1 + k1 theta^2 + k2 theta^4 + k3 theta^6 + k4 theta^8)
//     (x, y) = theta_d (cos phi, sin phi),   u = fx x + skew y + cx,  v = fy y + cy
//
// cv::fisheye takes atan(sqrt(X^2 + Y^2) / Z) and so mirrors what lies behind the image plane. The skew is that of K,
// where cv::fisheye::calibrate writes fx alpha.
//
// Valid domain: theta below the first turning point of theta_d, and below pi; of pixels, those whose radius
// sqrt(x^2 + y^2) is below theta_d there. The point straight behind the lens has no pixel.

namespace cv {
namespace gmlpnp {
namespace detail {
namespace {

constexpr std::initializer_list<int> kCounts = {4};
const double kTolerance = 1e-15;  // relative, of the last step in theta: the last digit

class Fisheye : public CameraModel
{
public:
    Fisheye(const Intrinsics& intrinsics, const std::vector<double>& coefficients) : k(intrinsics), D(coefficients)
    {
        const double slopeByThetaSquared[] = {1, 3 * D[0], 5 * D[1], 7 * D[2], 9 * D[3]};
        thetaEnd = std::min(CV_PI, std::sqrt(firstPositiveRoot(slopeByThetaSquared, 4)));
        double slope;
        radiusEnd = radiusOf(thetaEnd, slope);
    }

    bool unprojectPoint(const Point2d& pixel, Vec3d& ray, Matx32d* jacobian) const override
    {
        const Point2d p = k.planeOf(pixel);
        const double radius = std::sqrt(p.x * p.x + p.y * p.y);
        if (!(radius < radiusEnd))
            return false;
        const auto curve = [this](double angle, double& slope) { return radiusOf(angle, slope); };
        const double theta = solveIncreasing(curve, radius, 0, thetaEnd, radius, kTolerance);
        const double sine = std::sin(theta), cosine = std::cos(theta);
        const double c = radius > 0 ? p.x / radius : 1, s = radius > 0 ? p.y / radius : 0;
        ray = Vec3d(sine * c, sine * s, cosine);
        if (jacobian) {
            double slope;
            radiusOf(theta, slope);
            // Outwards the ray turns by d(theta) = d(radius) / slope, around the axis by sin(theta) d(phi).
            const double out = 1 / slope, around = radius > 0 ? sine / radius : 1;
            *jacobian = k.byPixel(Matx32d(cosine * c * c * out + s * s * around, c * s * (cosine * out - around),
                                          c * s * (cosine * out - around), cosine * s * s * out + c * c * around,
                                          -sine * c * out, -sine * s * out));
        }
        return true;
    }

    bool projectPoint(const Vec3d& point, Point2d& pixel) const override
    {
        Vec3d m;
        if (!unitVector(point, m))
            return false;
        const double sine = std::sqrt(m[0] * m[0] + m[1] * m[1]), theta = std::atan2(sine, m[2]);
        if (!(theta < thetaEnd))
            return false;
        double slope;
        const double scale = sine > 0 ? radiusOf(theta, slope) / sine : 1;
        return k.pixelOf({scale * m[0], scale * m[1]}, pixel);
    }

    void angularScales(const Vec3d* rays, int count, double* scales) const override
    {
        for (int i = 0; i < count; ++i)
            scales[i] = aroundTheAxis(rays[i]);
    }

    void write(FileStorage& fs) const override
    {
        fs.write("model", "fisheye");
        fs.write("K", Mat(k.matrix()));
        fs.write("D", Mat(D));
    }

private:
    double aroundTheAxis(const Vec3d& m) const
    {
        const double sine = std::sqrt(m[0] * m[0] + m[1] * m[1]);
        double slope;
        return sine > 0 ? sine / radiusOf(std::atan2(sine, m[2]), slope) : 1;
    }

    // theta_d and its slope by theta.
    double radiusOf(double theta, double& slope) const
    {
        const double q = theta * theta;
        slope = 1 + q * (3 * D[0] + q * (5 * D[1] + q * (7 * D[2] + q * 9 * D[3])));
        return theta * (1 + q * (D[0] + q * (D[1] + q * (D[2] + q * D[3]))));
    }

    Intrinsics k;
    std::vector<double> D;
    double thetaEnd;   // rad, open end of the domain
    double radiusEnd;  // theta_d there
};

}  // namespace
}  // namespace detail

Ptr<CameraModel> CameraModel::fisheye(InputArray K, InputArray D)
{
    return makePtr<detail::Fisheye>(detail::intrinsicsFrom(K), detail::coefficientsFrom(D, detail::kCounts, 4));
}

}  // namespace gmlpnp
}  // namespace cv
