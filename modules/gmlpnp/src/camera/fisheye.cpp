// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "lens.hpp"

// The Kannala-Brandt camera of cv::fisheye, but for the whole sphere. With theta the angle off the axis and phi the
// azimuth,
//
//     theta = atan2(sqrt(X^2 + Y^2), Z)   in [0, pi]
//     theta_d = theta (1 + k1 theta^2 + k2 theta^4 + k3 theta^6 + k4 theta^8)
//     (x, y) = theta_d (cos phi, sin phi),   u = fx x + skew y + cx,  v = fy y + cy
//
// cv::fisheye takes atan(sqrt(X^2 + Y^2) / Z) and so mirrors the points behind the image plane. The skew is K(0, 1),
// where cv::fisheye::calibrate writes fx alpha.
//
// The valid domain is theta below the first turning point of theta_d and below pi. A pixel has a ray if its radius
// sqrt(x^2 + y^2) is below theta_d at that end. The point straight behind the lens has no pixel. The angular scale is
// sin(theta) / theta_d.

namespace cv {
namespace gmlpnp {
namespace detail {
namespace {

constexpr double THETA_TOLERANCE = 1e-15;  // rounding, of the last step in theta, relative

class Fisheye final : public LensOf<Fisheye>
{
public:
    Fisheye(InputArray K, InputArray D) : LensOf("fisheye", intrinsicsFrom(K)), D_(coefficientsFrom(D, {4}, 4))
    {
        const double slopeByThetaSquared[] = {1, 3 * D_[0], 5 * D_[1], 7 * D_[2], 9 * D_[3]};
        thetaEnd_ = std::min(CV_PI, std::sqrt(firstPositiveRoot(slopeByThetaSquared, 4)));
        double slope;
        radiusEnd_ = radiusOf(thetaEnd_, slope);
    }

    bool unprojectPoint(const Point2d& pixel, Vec3d& ray, Matx32d* jacobian) const override
    {
        const Point2d p = k_.planeOf(pixel);
        const double radius = std::sqrt(p.x * p.x + p.y * p.y);
        if (!(radius < radiusEnd_))
            return false;
        const auto curve = [this](double angle, double& slope) { return radiusOf(angle, slope); };
        const double theta = solveIncreasing(curve, radius, 0, thetaEnd_, radius, THETA_TOLERANCE);
        const double sine = std::sin(theta), cosine = std::cos(theta);
        const double c = radius > 0 ? p.x / radius : 1, s = radius > 0 ? p.y / radius : 0;
        ray = Vec3d(sine * c, sine * s, cosine);
        if (jacobian) {
            double slope;
            radiusOf(theta, slope);
            // The ray turns outwards by d(theta) = d(radius) / slope and around the axis by sin(theta) d(phi).
            const double out = 1 / slope, around = radius > 0 ? sine / radius : 1;
            *jacobian = k_.byPixel(Matx32d(cosine * c * c * out + s * s * around, c * s * (cosine * out - around),
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
        if (!(theta < thetaEnd_))
            return false;
        double slope;
        const double scale = sine > 0 ? radiusOf(theta, slope) / sine : 1;
        return k_.pixelOf({scale * m[0], scale * m[1]}, pixel);
    }

private:
    friend LensOf<Fisheye>;

    double angularScale(const Vec3d& m) const
    {
        const double sine = std::sqrt(m[0] * m[0] + m[1] * m[1]);
        double slope;
        return sine > 0 ? sine / radiusOf(std::atan2(sine, m[2]), slope) : 1;
    }

    void writeParameters(FileStorage& fs) const override { fs.write("D", Mat(D_)); }

    // Returns theta_d and sets its slope by theta.
    double radiusOf(double theta, double& slope) const
    {
        const double q = theta * theta;
        slope = 1 + q * (3 * D_[0] + q * (5 * D_[1] + q * (7 * D_[2] + q * 9 * D_[3])));
        return theta * (1 + q * (D_[0] + q * (D_[1] + q * (D_[2] + q * D_[3]))));
    }

    std::vector<double> D_;
    double thetaEnd_;   // rad; the domain ends before it
    double radiusEnd_;  // theta_d at that angle
};

}  // namespace
}  // namespace detail

Ptr<CameraModel> CameraModel::fisheye(InputArray K, InputArray D)
{
    return makePtr<detail::Fisheye>(K, D);
}

}  // namespace gmlpnp
}  // namespace cv
