// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "../noise/model.hpp"
#include "../noise/scoring.hpp"
#include "../noise/tails.hpp"
#include "noise_estimate.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

Matrix12d noiseInformation(const Correspondences& data, const Pose& pose, const Noise& noise)
{
    const RayProducts products = rayProducts(data, pose, noise, rayKernels(data.size()));
    const Matrix6d both = curvature(products.both);
    Matrix12d F;
    F << curvature(products.object), both, both, curvature(products.bearing);
    return tailInformation(noise.tails).noise * F;
}

namespace {

// Each of the two noises is sought, or not.
struct Which
{
    bool object, bearing;
};

// The 12 entries are in units of the isotropic variance at mean depth. So nothing depends on lengths.
struct Units
{
    Units(const Correspondences& data, const Pose& pose, const Noise& noise)
    {
        double depth2 = 0, depth4 = 0;
        for (int i = 0; i < data.size(); ++i) {
            const double s = data.scaledRayAt(i).dot(pose * data.pointAt(i)), s2 = s * s;
            depth2 += s2 / data.size();
            depth4 += s2 * s2 / data.size();
        }
        const double variance = (noise.Sigma.trace() + depth2 * noise.Gamma.trace()) / 3;
        entry << Vector6d::Constant(variance), Vector6d::Constant(variance / depth2);
        depth2Variance = depth4 / (depth2 * depth2) - 1;
    }

    Vector12d entry;
    double depth2Variance;  // relative variance of s^2; where it is small, object noise looks like bearing noise
};

// Rows and columns of a noise that is not sought become those of the identity.
Matrix12d restrictedTo(const Which& sought, Matrix12d F)
{
    for (int k = 0; k < 12; ++k)
        if (k < 6 ? !sought.object : !sought.bearing) {
            F.row(k).setZero();
            F.col(k).setZero();
            F(k, k) = 1;
        }
    return F;
}

// Statistics: variances below this share of the largest are chance or rounding, and would weigh points in the next
// step.
constexpr double SMALLEST_VARIANCE = 1e-3;

Noise stepped(const Noise& noise, const Which& sought, const Vector12d& step, const Matrix3d& R)
{
    Noise next = noise;
    if (sought.object)
        next.Sigma = regular(floored(noise.Sigma + R.transpose() * symmetric(step.data()) * R, SMALLEST_VARIANCE), 0);
    if (sought.bearing)
        next.Gamma = regular(floored(noise.Gamma + symmetric(step.data() + 6), SMALLEST_VARIANCE), 0);
    return next;
}

// Damped scoring hardly moves a direction that the data hardly observe: after k steps one with the information f has
// gone 1 - (damping / (damping + f))^k of its way.
Noise scored(const Correspondences& data, const Estimate& found, const Which& sought, const Units& units)
{
    constexpr int STEPS = 3;
    constexpr double DAMPING = SHRINKAGE / 2;  // information of a point
    Vector12d damping;
    damping << 1, 2, 2, 1, 2, 1, 1, 2, 2, 1, 2, 1;
    const Matrix12d F = noiseInformation(data, found.pose, found.noise);
    Matrix12d A = units.entry.asDiagonal() * F * units.entry.asDiagonal();
    A.diagonal() += DAMPING * damping;
    const Eigen::LDLT<Matrix12d> solver(restrictedTo(sought, A));
    Noise noise = found.noise;
    for (int k = 0; k < STEPS; ++k) {
        const RaySums sums = rayPass(data, found.pose, noise);
        const double f = restriction(data.size());
        Vector12d score;
        score << againstUnits(f * sums.Zo - sums.Go), againstUnits(f * sums.Zb - sums.Gb);
        score = 0.5 * units.entry.cwiseProduct(score);
        score.head<6>() *= sought.object;
        score.tail<6>() *= sought.bearing;
        const Vector12d step = units.entry.cwiseProduct(solver.solve(score));
        if (!step.allFinite())
            break;
        noise = stepped(noise, sought, step, found.pose.R);
    }
    return noise;
}

// Standard deviations of the entries of R^T C R, from the covariance of the entries of C.
Matrix3d entryDeviations(const Matrix6d& covariance, const Matrix3d& R)
{
    Matrix6d rotation;
    for (int k = 0; k < 6; ++k) {
        const Vector6d unit = Vector6d::Unit(k);
        rotation.col(k) = entriesOf(R.transpose() * symmetric(unit.data()) * R);
    }
    const Vector6d deviations = (rotation * covariance * rotation.transpose()).diagonal().cwiseMax(0).cwiseSqrt();
    return symmetric(deviations.data());
}

void addErrors(const Matrix12d& F, const Units& units, const Which& open, int n, const Matrix3d& R, NoiseEstimate& out)
{
    // Where the data tell nothing at all, this information stands for an error of 1e5 times the noise.
    constexpr double NOTHING = 1e-10;
    Matrix12d A = units.entry.asDiagonal() * F * units.entry.asDiagonal();
    A.diagonal().array() += NOTHING;
    const Matrix12d inverse = restrictedTo(open, A).ldlt().solve(Matrix12d::Identity());
    const Matrix12d covariance = restriction(n) * (units.entry.asDiagonal() * inverse * units.entry.asDiagonal());
    if (open.object)
        out.objectError = entryDeviations(covariance.topLeftCorner<6, 6>(), R);
    if (open.bearing)
        out.bearingError = entryDeviations(covariance.bottomRightCorner<6, 6>(), Matrix3d::Identity());
}

// A noise that did not weigh the pose is sought, too, because leaving it out makes the other one too large. Where
// depths are so alike that hardly anything tells them apart it is not: the floors would spoil the sum of the two.
Which soughtOf(NoiseKind kind, const Which& open, const Units& units)
{
    // The relative variance of s^2 is .06 for equal depths in a field of 45 degrees, and .6 where depths differ by a
    // factor of four. Fitted: scripts/figures.sh recovery; held by Gmlpnp_NoiseEstimate.*.
    constexpr double ALIKE = 0.25;
    const bool both = kind == NoiseKind::BOTH || units.depth2Variance > ALIKE;
    if (isConstant(kind))
        return {false, false};
    return {open.object && (both || kind == NoiseKind::OBJECT), open.bearing && (both || kind == NoiseKind::BEARING)};
}

}  // namespace

NoiseEstimate estimatedNoise(const Correspondences& data, const Estimate& found, bool givenObject, bool givenBearing)
{
    NoiseEstimate out{found.noise, Matrix3d::Zero(), Matrix3d::Zero()};
    const Which open{!givenObject, !givenBearing};
    if (!open.object && !open.bearing)
        return out;
    const Units units(data, found.pose, found.noise);
    const Which sought = soughtOf(found.kind, open, units);
    if (sought.object || sought.bearing)
        out.noise = scored(data, found, sought, units);
    addErrors(noiseInformation(data, found.pose, out.noise), units, open, data.size(), found.pose.R, out);
    return out;
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
