// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "precomp.hpp"

#include "pose_covariance.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

namespace {

Vector6d unitDiagonal(const Matrix6d& H)
{
    return H.diagonal().cwiseSqrt().cwiseInverse();
}

}  // namespace

bool determined(const Matrix6d& H)
{
    if (!H.allFinite() || !(H.diagonal().minCoeff() > 0))
        return false;
    // The smallest eigenvalue of the correlation form; far small objects come near (extent / distance)^2.
    constexpr double SINGULAR = 1e-14;
    const Vector6d scale = unitDiagonal(H);
    const Matrix6d correlation = scale.asDiagonal() * H * scale.asDiagonal();
    return Eigen::SelfAdjointEigenSolver<Matrix6d>(correlation, Eigen::EigenvaluesOnly).eigenvalues()(0) > SINGULAR;
}

Matrix6d poseCovariance(const Estimate& estimate, int n)
{
    const Matrix6d& H = estimate.sums.H;
    const Vector6d scale = unitDiagonal(H);
    const Matrix6d correlation = scale.asDiagonal() * H * scale.asDiagonal();
    const Matrix6d inverse = correlation.ldlt().solve(Matrix6d::Identity());
    // The pose has fitted away six of the 2n residual coordinates that the noise was estimated from.
    const double freedom = estimate.kind == NoiseKind::FIXED ? 1 : 2. * n / (2 * n - 6);
    const Matrix6d covariance = freedom * (scale.asDiagonal() * inverse * scale.asDiagonal());
    return 0.5 * (covariance + covariance.transpose());
}

Matrix6d rescaled(const Matrix6d& covariance, double scale)
{
    Vector6d units;
    units << 1, 1, 1, scale, scale, scale;
    return units.asDiagonal() * covariance * units.asDiagonal();
}

Matrix6d toRvecTvec(const Matrix6d& covariance, const Pose& pose)
{
    Matrix6d J = Matrix6d::Identity();
    J.topLeftCorner<3, 3>() = leftJacobianInverse(logSO3(pose.R));
    J.bottomLeftCorner<3, 3>() = -hat(pose.t);
    const Matrix6d out = J * covariance * J.transpose();
    return 0.5 * (out + out.transpose());
}

Matrix3d toCameraCenter(const Matrix6d& covariance, const Pose& pose)
{
    return symmetrised(pose.R.transpose() * covariance.bottomRightCorner<3, 3>() * pose.R);
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
