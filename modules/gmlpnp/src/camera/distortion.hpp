// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_CAMERA_DISTORTION_HPP
#define OPENCV_GMLPNP_CAMERA_DISTORTION_HPP

#include "../precomp.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

/** The distortion of the image plane that the pinhole and the omnidirectional camera share. With r^2 = x^2 + y^2,

    R(r^2) = (1 + k1 r^2 + k2 r^4 + k3 r^6) / (1 + k4 r^2 + k5 r^4 + k6 r^6)
    G(x, y) = (x R + 2 p1 x y + p2 (r^2 + 2 x^2) + s1 r^2 + s2 r^4,
               y R + p1 (r^2 + 2 y^2) + 2 p2 x y + s3 r^2 + s4 r^4)

Valid domain: the points u that can be reached from the centre along a straight line on which the symmetric part
of the Jacobian J of G stays positive definite. There det J > 0, and on every convex part of it G is one-to-one:
(a - b)^T (G(a) - G(b)) > 0. Without p and s the domain is the disk in which r R(r^2) increases; what lies beyond its
edge is folded back into the picture by the formula and has no meaning. Each distorted point thus has one ray or none.
*/
class CV_EXPORTS Distortion
{
public:
    /** @param D k1, k2, p1, p2, k3, k4, k5, k6, s1, s2, s3, s4: 12 or more numbers. */
    explicit Distortion(const std::vector<double>& D);

    bool isNone() const { return none; }

    /** G(u) and its Jacobian. */
    Point2d apply(const Point2d& u, Matx22d& J) const;

    /** Whether u lies in the valid domain. */
    bool contains(const Point2d& u) const;

    /** The u of the valid domain with G(u) = distorted, and the Jacobian of G there. False where there is none. */
    bool invert(const Point2d& distorted, Point2d& u, Matx22d& J) const;

private:
    double radial(double r, double& slope) const;
    double lowestEigenvalueBound(double r) const;
    bool startRadially(const Point2d& distorted, Point2d& u) const;
    bool refine(const Point2d& distorted, Point2d& u, Matx22d& J) const;
    bool follow(const Point2d& distorted, Point2d& u, Matx22d& J) const;

    double N[4], M[4];  // numerator and denominator of R by powers of r^2
    double p1, p2, s1, s2, s3, s4;
    bool none, isRadial;
    double foldRadius;  // r R(r^2) increases on [0, foldRadius)
    double safeRadius;  // every u within lies in the domain
};

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_CAMERA_DISTORTION_HPP
