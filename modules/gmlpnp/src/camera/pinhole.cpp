// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "common.hpp"
#include "distortion.hpp"

// Pinhole, as cv::projectPoints:
//
//     (x, y) = (X, Y) / Z,   d = G(x, y) (camera_distortion.hpp),   (a, b, c) = T(tau_x, tau_y) (d, 1)
//     u = fx a / c + cx,  v = fy b / c + cy
//
// T is the homography of a sensor tilted by Rt = Ry(tau_y) Rx(tau_x) as rotations of the axes:
//
//     T = [ Rt33 0 -Rt13;  0 Rt33 -Rt23;  0 0 1 ] Rt
//
// Valid domain: Z > 0, (x, y) where G is one-to-one, and c > 0. Every finite pixel of an undistorted camera has a ray.

namespace cv {
namespace gmlpnp {
namespace detail {
namespace {

constexpr std::initializer_list<int> kCounts = {4, 5, 8, 12, 14};

// OpenCV's signs: Rx = [1 0 0; 0 c s; 0 -s c], Ry = [c 0 -s; 0 1 0; s 0 c].
Matx33d tiltMatrix(double tauX, double tauY)
{
    const double cx = std::cos(tauX), sx = std::sin(tauX), cy = std::cos(tauY), sy = std::sin(tauY);
    const Matx33d R = Matx33d(cy, 0, -sy, 0, 1, 0, sy, 0, cy) * Matx33d(1, 0, 0, 0, cx, sx, 0, -sx, cx);
    return Matx33d(R(2, 2), 0, -R(0, 2), 0, R(2, 2), -R(1, 2), 0, 0, 1) * R;
}

// The image of p under a homography, with its Jacobian; false on and behind the line at infinity.
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

class Pinhole : public CameraModel
{
public:
    Pinhole(const Intrinsics& intrinsics, const std::vector<double>& coefficients)
        : k(intrinsics.withoutSkew()),
          D(coefficients),
          distortion(D),
          isTilted(D[12] != 0 || D[13] != 0),
          tilt(tiltMatrix(D[12], D[13])),
          untilt(tilt.inv())
    {
        if (!(tilt(2, 2) > 0))
            CV_Error(Error::StsBadArg, "'D' tilts the sensor by a right angle or more");
    }

    bool unprojectPoint(const Point2d& pixel, Vec3d& ray, Matx32d* jacobian) const override
    {
        Point2d p = k.planeOf(pixel);
        Matx22d byPlane = Matx22d::eye();
        const bool flat = isTilted || !distortion.isNone() ? flatten(p, jacobian ? &byPlane : nullptr) : true;
        if (!flat || !rayThrough(p, ray))
            return false;
        if (jacobian)
            *jacobian = k.byPixel(unitJacobian(
                ray, 1 / ray[2], Matx32d(byPlane(0, 0), byPlane(0, 1), byPlane(1, 0), byPlane(1, 1), 0, 0)));
        return true;
    }

    void unprojectPoints(const Point2d* pixels, int count, Vec3d* rays, uchar* valid) const override
    {
        if (isTilted || !distortion.isNone()) {
            CameraModel::unprojectPoints(pixels, count, rays, valid);
            return;
        }
        for (int i = 0; i < count; ++i) {  // without a call for each the divisions of several points overlap
            const bool seen = rayThrough(k.planeOf(pixels[i]), rays[i]);
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
        if (!isFinite(p))
            return false;
        if (!distortion.isNone()) {
            Matx22d J;
            if (!distortion.contains(p))
                return false;
            p = distortion.apply(p, J);
        }
        if (isTilted && !transform(tilt, p, p, nullptr))
            return false;
        return k.pixelOf(p, pixel);
    }

    void angularScales(const Vec3d* rays, int count, double* scales) const override
    {
        for (int i = 0; i < count; ++i)
            scales[i] = rays[i][2];
    }

    void write(FileStorage& fs) const override
    {
        fs.write("model", "pinhole");
        fs.write("K", Mat(k.matrix()));
        fs.write("D", Mat(D));
    }

private:
    // False for a point of the plane that is not finite, or so far out that its ray has no digits left.
    static bool rayThrough(const Point2d& p, Vec3d& ray)
    {
        const double w = 1 / std::sqrt(p.x * p.x + p.y * p.y + 1);
        if (!(w > 0))
            return false;
        ray = Vec3d(p.x * w, p.y * w, w);
        return true;
    }

    // Undoes tilt and distortion: p becomes (X/Z, Y/Z), J its derivative by what p was.
    bool flatten(Point2d& p, Matx22d* J) const
    {
        Matx22d Juntilt = Matx22d::eye(), Jdistort;
        if (isTilted && !transform(untilt, p, p, J ? &Juntilt : nullptr))
            return false;
        if (!distortion.invert(Point2d(p), p, Jdistort))
            return false;
        if (J)
            *J = inverse(Jdistort) * Juntilt;
        return true;
    }

    Intrinsics k;
    std::vector<double> D;
    Distortion distortion;
    bool isTilted;
    Matx33d tilt, untilt;
};

}  // namespace
}  // namespace detail

Ptr<CameraModel> CameraModel::pinhole(InputArray K, InputArray D)
{
    return makePtr<detail::Pinhole>(detail::intrinsicsFrom(K), detail::coefficientsFrom(D, detail::kCounts, 14));
}

}  // namespace gmlpnp
}  // namespace cv
