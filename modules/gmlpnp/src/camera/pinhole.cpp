// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "distortion.hpp"
#include "lens.hpp"

// The pinhole camera of cv::projectPoints:
//
//     (x, y) = (X, Y) / Z,   d = G(x, y) (camera/distortion.hpp),   (a, b, c) = T(tau_x, tau_y) (d, 1)
//     u = fx a / c + cx,  v = fy b / c + cy
//
// T is the homography of a sensor tilted by Rt = Ry(tau_y) Rx(tau_x) as rotations of the axes:
//
//     T = [ Rt33 0 -Rt13;  0 Rt33 -Rt23;  0 0 1 ] Rt
//
// The valid domain is Z > 0, (x, y) where G is one-to-one, and c > 0. Every finite pixel of an undistorted camera has a
// ray. The angular scale is cos(theta) = m3 for the angle theta off the axis; it leaves the distortion out.

namespace cv {
namespace gmlpnp {
namespace detail {
namespace {

constexpr size_t MOST_COEFFICIENTS = 14;

// OpenCV's signs are Rx = [1 0 0; 0 c s; 0 -s c] and Ry = [c 0 -s; 0 1 0; s 0 c].
Matx33d tiltMatrix(double tauX, double tauY)
{
    const double cx = std::cos(tauX), sx = std::sin(tauX), cy = std::cos(tauY), sy = std::sin(tauY);
    const Matx33d R = Matx33d(cy, 0, -sy, 0, 1, 0, sy, 0, cy) * Matx33d(1, 0, 0, 0, cx, sx, 0, -sx, cx);
    return Matx33d(R(2, 2), 0, -R(0, 2), 0, R(2, 2), -R(1, 2), 0, 0, 1) * R;
}

// Sets the image of p under a homography, with its Jacobian. Returns false on and behind the line at infinity.
bool transform(const Matx33d& H, const Point2d& p, Point2d& q, Matx22d* J)
{
    const double w = H(2, 0) * p.x + H(2, 1) * p.y + H(2, 2);
    if (!(w > 0))
        return false;
    q = {(H(0, 0) * p.x + H(0, 1) * p.y + H(0, 2)) / w, (H(1, 0) * p.x + H(1, 1) * p.y + H(1, 2)) / w};
    if (J)
        *J = Matx22d(H(0, 0) - q.x * H(2, 0), H(0, 1) - q.x * H(2, 1), H(1, 0) - q.y * H(2, 0),
                     H(1, 1) - q.y * H(2, 1)) *
             (1 / w);
    return true;
}

class Pinhole final : public LensOf<Pinhole>
{
public:
    Pinhole(InputArray K, InputArray D)
        : LensOf("pinhole", intrinsicsFrom(K).withoutSkew()),
          D_(coefficientsFrom(D, {4, 5, 8, 12, MOST_COEFFICIENTS}, MOST_COEFFICIENTS)),
          distortion_(D_),
          isTilted_(D_[12] != 0 || D_[13] != 0),
          tilt_(tiltMatrix(D_[12], D_[13])),
          untilt_(tilt_.inv())
    {
        if (!(tilt_(2, 2) > 0))
            CV_Error(Error::StsBadArg, "'D' tilts the sensor by a right angle or more");
    }

    bool unprojectPoint(const Point2d& pixel, Vec3d& ray, Matx32d* jacobian) const override
    {
        Point2d p = k_.planeOf(pixel);
        Matx22d byPlane = Matx22d::eye();
        const bool flat = isBent() ? flatten(p, jacobian ? &byPlane : nullptr) : true;
        if (!flat || !rayThrough(p, ray))
            return false;
        if (jacobian)
            *jacobian = k_.byPixel(unitJacobian(
                ray, 1 / ray[2], Matx32d(byPlane(0, 0), byPlane(0, 1), byPlane(1, 0), byPlane(1, 1), 0, 0)));
        return true;
    }

    void unprojectPoints(const Point2d* pixels, int count, Vec3d* rays, uchar* valid) const override
    {
        if (isBent()) {
            CameraModel::unprojectPoints(pixels, count, rays, valid);
            return;
        }
        for (int i = 0; i < count; ++i) {  // without a call for each point the divisions of several points overlap
            const bool seen = rayThrough(k_.planeOf(pixels[i]), rays[i]);
            valid[i] = seen ? 255 : 0;
            if (!seen)
                rays[i] = Vec3d();
        }
    }

    bool projectPoint(const Vec3d& point, Point2d& pixel) const override
    {
        if (!(point[2] > 0) || !std::isfinite(point[2]))
            return false;
        Point2d p(point[0] / point[2], point[1] / point[2]);
        if (!isFinite(p) || !distortion_.applyInside(p))
            return false;
        if (isTilted_ && !transform(tilt_, p, p, nullptr))
            return false;
        return k_.pixelOf(p, pixel);
    }

private:
    friend LensOf<Pinhole>;

    double angularScale(const Vec3d& ray) const { return ray[2]; }

    void writeParameters(FileStorage& fs) const override { fs.write("D", Mat(D_)); }

    // Sets the unit ray through a point of the plane. Returns false for a point that is not finite, or so far out that
    // its ray has no digits left.
    static bool rayThrough(const Point2d& p, Vec3d& ray)
    {
        const double w = 1 / std::sqrt(p.x * p.x + p.y * p.y + 1);
        if (!(w > 0))
            return false;
        ray = Vec3d(p.x * w, p.y * w, w);
        return true;
    }

    bool isBent() const { return isTilted_ || !distortion_.isNone(); }

    // Undoes tilt and distortion: p becomes (X/Z, Y/Z), and J the derivative of the new p by the old one.
    bool flatten(Point2d& p, Matx22d* J) const
    {
        Matx22d Juntilt = Matx22d::eye(), Jdistort;
        if (isTilted_ && !transform(untilt_, p, p, J ? &Juntilt : nullptr))
            return false;
        if (!distortion_.invert(Point2d(p), p, Jdistort))
            return false;
        if (J)
            *J = inverse(Jdistort) * Juntilt;
        return true;
    }

    std::vector<double> D_;
    Distortion distortion_;
    bool isTilted_;
    Matx33d tilt_, untilt_;
};

}  // namespace
}  // namespace detail

Ptr<CameraModel> CameraModel::pinhole(InputArray K, InputArray D)
{
    return makePtr<detail::Pinhole>(K, D);
}

}  // namespace gmlpnp
}  // namespace cv
