// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_CAMERA_DISTORTION_HPP
#define OPENCV_GMLPNP_CAMERA_DISTORTION_HPP

#include "../precomp.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

/** The distortion of the image plane that the pinhole and the unified camera share. With r^2 = x^2 + y^2,

    R(r^2) = (1 + k1 r^2 + k2 r^4 + k3 r^6) / (1 + k4 r^2 + k5 r^4 + k6 r^6)
    G(x, y) = (x R + 2 p1 x y + p2 (r^2 + 2 x^2) + s1 r^2 + s2 r^4,
               y R + p1 (r^2 + 2 y^2) + 2 p2 x y + s3 r^2 + s4 r^4)

The valid domain holds the points u that a straight line from the centre reaches while the symmetric part of the
Jacobian J of G stays positive definite. There det J > 0. On every convex part of the domain G is one-to-one, because (a
- b)^T (G(a) - G(b)) > 0. Without p and s the domain is the disk in which r R(r^2) increases. The formula folds the
points beyond its edge back into the picture, where they have no meaning. So each distorted point has one ray or none.
*/
class CV_EXPORTS Distortion
{
public:
    /** @param D k1, k2, p1, p2, k3, k4, k5, k6, s1, s2, s3, s4: 12 numbers; more are ignored. */
    explicit Distortion(const std::vector<double>& D);

    bool isNone() const { return none_; }

    /** Returns G(u) and sets its Jacobian. */
    Point2d apply(const Point2d& u, Matx22d& J) const;

    /** Replaces u by G(u). Returns false, and leaves u as it is, outside of the valid domain. */
    bool applyInside(Point2d& u) const;

    /** Says whether u lies in the valid domain. */
    bool contains(const Point2d& u) const;

    /** Finds the u of the valid domain with G(u) = distorted, and the Jacobian of G there. Returns false where there is
    none. */
    bool invert(const Point2d& distorted, Point2d& u, Matx22d& J) const;

private:
    double radial(double r, double& slope) const;
    double lowestEigenvalueBound(double r) const;
    bool startRadially(const Point2d& distorted, Point2d& u) const;
    bool refine(const Point2d& distorted, Point2d& u, Matx22d& J) const;
    bool follow(const Point2d& distorted, Point2d& u, Matx22d& J) const;

    double N_[4], M_[4];  // coefficients of the numerator and the denominator of R by powers of r^2
    double p1_, p2_, s1_, s2_, s3_, s4_;
    bool none_, isRadial_;
    double foldRadius_;  // r R(r^2) increases on [0, foldRadius)
    double safeRadius_;  // every u within this distance lies in the domain
};

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_CAMERA_DISTORTION_HPP
