// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_MATH_LIE_HPP
#define OPENCV_GMLPNP_MATH_LIE_HPP

#include "../precomp.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Matrix6d = Eigen::Matrix<double, 6, 6>;
using Vector6d = Eigen::Matrix<double, 6, 1>;

/** A pose turns object coordinates p into camera coordinates X = R p + t. */
struct Pose
{
    Matrix3d R = Matrix3d::Identity();
    Vector3d t = Vector3d::Zero();

    Vector3d operator*(const Vector3d& p) const { return R * p + t; }
};

/** Returns the cross product matrix [v]_x: [v]_x a = v x a. */
inline Matrix3d hat(const Vector3d& v)
{
    Matrix3d A;
    A << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return A;
}

/** Rounding: below this angle [rad] two terms of the series of sin(x)/x and its kin are exact to double precision. */
constexpr double SMALL_ANGLE = 1e-4;

/** Returns Exp(phi), the rotation by the angle |phi| [rad] about phi: Rodrigues' formula. */
inline Matrix3d expSO3(const Vector3d& phi)
{
    const double theta2 = phi.squaredNorm(), theta = std::sqrt(theta2);
    const bool small = theta < SMALL_ANGLE;
    const double a = small ? 1 - theta2 / 6 : std::sin(theta) / theta;
    const double sinHalf = std::sin(theta / 2);
    const double b = small ? 0.5 - theta2 / 24 : 2 * sinHalf * sinHalf / theta2;
    const Matrix3d K = hat(phi);
    return Matrix3d::Identity() + a * K + b * K * K;
}

/** Returns the phi with Exp(phi) = R and |phi| <= pi [rad]. It goes by way of the quaternion, whose vector part keeps
its precision up to pi. */
inline Vector3d logSO3(const Matrix3d& R)
{
    Eigen::Quaterniond q(R);
    if (q.w() < 0)
        q.coeffs() = -q.coeffs();
    const double sinHalf = q.vec().norm();
    const double scale =
        sinHalf < SMALL_ANGLE ? 2 * (1 + sinHalf * sinHalf / 6) : 2 * std::atan2(sinHalf, q.w()) / sinHalf;
    return scale * q.vec();
}

/** Returns the inverse of the left Jacobian of SO(3): Log(Exp(d) Exp(phi)) = phi + J_l^-1(phi) d + O(d^2). */
inline Matrix3d leftJacobianInverse(const Vector3d& phi)
{
    const double theta = phi.norm();
    const double b =
        theta < SMALL_ANGLE ? 1. / 12 + theta * theta / 720 : (1 - theta / 2 / std::tan(theta / 2)) / (theta * theta);
    const Matrix3d K = hat(phi);
    return Matrix3d::Identity() - 0.5 * K + b * K * K;
}

/** Returns the rotation nearest to M in the Frobenius norm. */
inline Matrix3d nearestRotation(const Matrix3d& M)
{
    const Eigen::JacobiSVD<Matrix3d> svd(M, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Matrix3d U = svd.matrixU();
    if ((U * svd.matrixV().transpose()).determinant() < 0)
        U.col(2) = -U.col(2);
    return U * svd.matrixV().transpose();
}

/** Perturbs a pose. Everywhere in this module the perturbation is on the LEFT, with xi = (phi, delta) in rad and
length: R <- Exp(phi) R, t <- Exp(phi) t + delta. Hence dX/dxi = [ -[R p + t]_x , I ] (doc/theory.md, section 1). */
inline Pose perturbed(const Pose& pose, const Vector6d& xi)
{
    const Matrix3d dR = expSO3(xi.head<3>());
    return {dR * pose.R, dR * pose.t + xi.tail<3>()};
}

/** Returns the xi with perturbed(from, xi) = to. */
inline Vector6d difference(const Pose& to, const Pose& from)
{
    const Matrix3d dR = to.R * from.R.transpose();
    Vector6d xi;
    xi << logSO3(dR), to.t - dR * from.t;
    return xi;
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_MATH_LIE_HPP
