// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "../noise/tails.hpp"
#include "pose_covariance.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

namespace {

// P(F > f) for the F distribution with 6 and d degrees of freedom (finite sum for an even first number).
double upperTail(double f, double d)
{
    const double x = d / (d + 6 * f), y = 1 - x, a = d / 2;
    return std::pow(x, a) * (1 + a * y * (1 + (a + 1) * y / 2));
}

// The 0.95 quantile of F(6, d) over that of its limit chi^2(6) / 6. It makes the 95 % ellipsoid hold the truth although
// the noise was estimated from few residuals.
double ellipsoidFactor(double d)
{
    constexpr double CHI2_OVER_6 = 12.591587 / 6;  // mathematics
    double low = 1, high = 1e3;
    for (int k = 0; k < 60; ++k) {
        const double middle = std::sqrt(low * high);
        (upperTail(middle, d) > 0.05 ? low : high) = middle;
    }
    return low / CHI2_OVER_6;
}

// Residual degrees of freedom. One variance is judged by 2n - 6. A covariance leaves about n - 6 to a direction for
// object noise across a narrow view, fewer where a third direction is seen, and more for bearings, whose noise has the
// two directions of a picture. Fitted so that the ellipsoid covers as promised: scripts/figures.sh coverage; held by
// Gmlpnp_CoverageStatistics.poseCovarianceCovers.
double freedomOf(NoiseKind kind, double n, double directions)
{
    constexpr double THIRD_DIRECTION = 11, BEARINGS = 3.5, NARROW = 6;
    switch (kind) {
        case NoiseKind::ISOTROPIC:
            return 2 * n - 6;
        case NoiseKind::BEARING:
            return n - BEARINGS;
        case NoiseKind::PUBLISHED:
            return n - NARROW;
        default:
            return n - NARROW - THIRD_DIRECTION * (directions - 2);
    }
}

double smallSample(NoiseKind kind, double n, double directions)
{
    constexpr double FEWEST = 2;
    return kind == NoiseKind::FIXED ? 1 : ellipsoidFactor(std::max(freedomOf(kind, n, directions), FEWEST));
}

}  // namespace

bool determined(const Matrix6d& H)
{
    if (!H.allFinite() || !(H.diagonal().minCoeff() > 0))
        return false;
    // Rounding: far small objects have a smallest eigenvalue near (extent / distance)^2.
    constexpr double SINGULAR = 1e-14;
    const UnitDiagonal unit(H);
    // Five eigenvalues of a trace of 6 have a product of at most (6/5)^5 < 2.5. So the determinant mostly proves it.
    const Eigen::LLT<Matrix6d> llt(unit.matrix);
    const double rootDeterminant = llt.matrixLLT().diagonal().prod();
    if (llt.info() == Eigen::Success && rootDeterminant * rootDeterminant > 2.5 * SINGULAR)
        return true;
    return Eigen::SelfAdjointEigenSolver<Matrix6d>(unit.matrix, Eigen::EigenvaluesOnly).eigenvalues()(0) > SINGULAR;
}

double effectiveNumber(const std::vector<double>& weights)
{
    double sum = 0, square = 0;
    for (double w : weights) {
        sum += w;
        square += w * w;
    }
    return sum * sum / square;
}

double observedDirections(const Correspondences& data)
{
    MomentSums moments;
    rayKernels(data.size()).moments(data.arrays(), moments);
    const Matrix3d seen = symmetric(moments.Q) / data.size();  // mean of I - m m^T, of trace 2
    return 4 / seen.squaredNorm();
}

Matrix6d poseCovariance(const Estimate& estimate, double n, double directions)
{
    if (estimate.noise.tails.share > 0)
        n -= 1;  // the share of the tails is estimated, too
    const UnitDiagonal H(estimate.sums.H);
    const Matrix6d inverse = H.matrix.ldlt().solve(Matrix6d::Identity());
    const Matrix6d covariance = smallSample(estimate.kind, n, directions) / tailInformation(estimate.noise.tails).pose *
                                    (H.scale.asDiagonal() * inverse * H.scale.asDiagonal()) +
                                estimate.spread;
    return symmetrised(covariance);
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
    return symmetrised(J * covariance * J.transpose());
}

Matrix3d toCameraCenter(const Matrix6d& covariance, const Pose& pose)
{
    return symmetrised(pose.R.transpose() * covariance.bottomRightCorner<3, 3>() * pose.R);
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
