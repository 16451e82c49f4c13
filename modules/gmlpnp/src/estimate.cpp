// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "precomp.hpp"

#include "estimate.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

namespace {

// Solved after scaling to a unit diagonal: rotations and translations have different units.
Vector6d gaussNewtonStep(const RaySums& sums)
{
    const Vector6d scale = sums.H.diagonal().cwiseMax(std::numeric_limits<double>::min()).cwiseSqrt().cwiseInverse();
    const Matrix6d H = scale.asDiagonal() * sums.H * scale.asDiagonal();
    return scale.cwiseProduct(H.ldlt().solve(-scale.cwiseProduct(sums.g)));
}

constexpr int STEP_HALVINGS = 5;

// With a fixed noise the cost must fall. With an estimated one L may rise a little: shrinkage and the corrected
// gradient do not follow it exactly. A rise beyond this [nat per point, at least RISE] is a step gone wrong.
constexpr double RISE = 3, RISE_PER_POINT = 0.05;

bool accepted(NoiseKind kind, const RaySums& before, const RaySums& after, int n)
{
    if (kind == NoiseKind::FIXED)
        return after.c <= before.c;
    return after.L <= before.L + std::max(RISE, RISE_PER_POINT * n) && 2 * after.inFront > n;
}

bool finished(NoiseKind kind, const Estimate& before, const Estimate& after, double tolerance)
{
    if (kind == NoiseKind::PUBLISHED)
        return (after.noise.Sigma - before.noise.Sigma).norm() < tolerance * after.noise.Sigma.norm();
    // With a fixed noise Gauss-Newton converges fast: a tighter end costs a round and gives the minimum itself.
    constexpr double FIXED_TOLERANCE = 1e-6;  // nat
    const double change = std::abs(after.sums.L - before.sums.L);
    return change < (kind == NoiseKind::FIXED ? std::min(tolerance, FIXED_TOLERANCE) : tolerance);
}

}  // namespace

Estimate alternate(const Correspondences& data, const Pose& start, const Noise& noise, NoiseKind kind,
                   const Stopping& stopping)
{
    const int n = data.size();
    const LeverArm lever = kind == NoiseKind::PUBLISHED ? LeverArm::AS_GIVEN : LeverArm::CORRECTED;
    Estimate now{start, noise, kind, rayPass(data, start, noise, lever), 0, false};
    while (now.rounds < stopping.maxRounds && !now.converged) {
        Vector6d xi = gaussNewtonStep(now.sums);
        Estimate next = now;
        next.rounds++;
        next.noise = updatedNoise(kind, now.noise, now.sums, now.pose.R, n);
        next.pose = perturbed(now.pose, xi);
        next.sums = rayPass(data, next.pose, next.noise, lever);
        for (int k = 0; k < STEP_HALVINGS && !accepted(kind, now.sums, next.sums, n); ++k) {
            xi *= 0.5;
            next.pose = perturbed(now.pose, xi);
            next.sums = rayPass(data, next.pose, next.noise, lever);
        }
        if (kind == NoiseKind::FIXED && !accepted(kind, now.sums, next.sums, n)) {
            now.converged = true;  // no step falls any more: this is the minimum, to rounding
            break;
        }
        next.converged = finished(kind, now, next, stopping.tolerance);
        now = next;
    }
    return now;
}

Pose isotropicPose(const Correspondences& data, const Pose& start)
{
    Noise unit;
    unit.Sigma.setIdentity();
    return alternate(data, start, unit, NoiseKind::FIXED, {30, 1e-12}).pose;
}

namespace {

// Evidence: a model with a noise more must be this much better [nat].
constexpr double PENALTY = 2;
// Fewer points leave too few degrees of freedom for a covariance: isotropic noise.
constexpr int MIN_POINTS_COVARIANCE = 6;
// Object noise in a model of bearing noise alone, as a share of the variance at mean depth: a point at the very centre
// of projection must not weigh infinitely.
constexpr double BEARING_ONLY_SHARE = 1e-6;

Noise isotropic(double a, double b)
{
    return {a * Matrix3d::Identity(), b * Matrix3d::Identity()};
}

// A known noise may be singular, or zero; the determinants must not be.
Matrix3d regular(const Matrix3d& known)
{
    constexpr double RELATIVE = 1e-12;
    return floored(known, RELATIVE) + NOISE_FLOOR * NOISE_FLOOR * Matrix3d::Identity();
}

void keepBetter(const Estimate& rival, double penalty, Estimate& best)
{
    if (rival.sums.L + penalty < best.sums.L)
        best = rival;
}

}  // namespace

Estimate estimatePublished(const Correspondences& data, const Pose& start, const KnownNoise& Sigma,
                           const KnownNoise& Gamma, const Stopping& stopping)
{
    const Noise noise{Sigma ? regular(*Sigma) : Matrix3d::Identity(), Gamma.value_or(Matrix3d::Zero())};
    return alternate(data, start, noise, Sigma ? NoiseKind::FIXED : NoiseKind::PUBLISHED, stopping);
}

Estimate estimateMarginal(const Correspondences& data, const Pose& start, const KnownNoise& Sigma,
                          const KnownNoise& Gamma, const Stopping& stopping)
{
    const auto run = [&](const Noise& noise, NoiseKind kind) { return alternate(data, start, noise, kind, stopping); };
    if (Sigma && Gamma)
        return run({regular(*Sigma), *Gamma}, NoiseKind::FIXED);
    const ResidualSplit split = splitResiduals(data, start);
    const Noise object = isotropic(split.aOnly, 0);
    if (data.size() < MIN_POINTS_COVARIANCE)
        return run({Sigma ? regular(*Sigma) : object.Sigma, Gamma.value_or(object.Gamma)}, NoiseKind::FIXED);
    const Noise bearing = isotropic(BEARING_ONLY_SHARE * split.bOnly * split.meanDepth2, split.bOnly);
    const Noise both = isotropic(split.a, split.b);

    if (Sigma) {
        Estimate best = run({regular(*Sigma), object.Gamma}, NoiseKind::FIXED);
        keepBetter(run({regular(*Sigma), both.Gamma}, NoiseKind::BEARING), PENALTY, best);
        return best;
    }
    if (Gamma) {
        Estimate best = run({bearing.Sigma, *Gamma}, NoiseKind::FIXED);
        keepBetter(run({both.Sigma, *Gamma}, NoiseKind::OBJECT), PENALTY, best);
        return best;
    }
    Estimate best = run(object, NoiseKind::OBJECT);
    keepBetter(run(bearing, NoiseKind::BEARING), 0, best);
    keepBetter(run(both, NoiseKind::BOTH), PENALTY, best);
    return best;
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
