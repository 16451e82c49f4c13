// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "precomp.hpp"

#include "estimate.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

namespace {

Vector6d gaussNewtonStep(const RaySums& sums)
{
    const UnitDiagonal H(sums.H);
    return H.scale.cwiseProduct(H.matrix.ldlt().solve(-H.scale.cwiseProduct(sums.g)));
}

constexpr int STEP_HALVINGS = 5;

// With a fixed noise the cost must fall. With an estimated one L may rise a little: shrinkage and the corrected
// gradient do not follow it exactly. A rise beyond this [nat per point, at least RISE] is a step gone wrong.
constexpr double RISE = 3, RISE_PER_POINT = 0.05;

bool accepted(bool noiseChanged, const RaySums& before, const RaySums& after, int n)
{
    if (!noiseChanged)
        return after.misfit <= before.misfit;
    return after.L <= before.L + std::max(RISE, RISE_PER_POINT * n) && 2 * after.inFront > n;
}

bool finished(NoiseKind kind, const Estimate& before, const Estimate& after, double tolerance)
{
    if (kind == NoiseKind::PUBLISHED)
        return (after.noise.Sigma - before.noise.Sigma).norm() < tolerance * after.noise.Sigma.norm();
    // With a fixed noise Gauss-Newton converges fast: a tighter end costs a round and gives the minimum itself.
    constexpr double FIXED_TOLERANCE = 1e-6;  // nat
    const double change = std::abs(after.sums.L - before.sums.L);
    return change < (isConstant(kind) ? std::min(tolerance, FIXED_TOLERANCE) : tolerance);
}

}  // namespace

Estimate alternate(const Correspondences& data, const Pose& start, const Noise& noise, NoiseKind kind,
                   const Stopping& stopping)
{
    const int n = data.size();
    const LeverArm lever = kind == NoiseKind::PUBLISHED ? LeverArm::AS_GIVEN : LeverArm::CORRECTED;
    Estimate now;
    now.pose = start;
    now.noise = noise;
    now.kind = kind;
    now.sums = rayPass(data, start, noise, lever);
    while (now.rounds < stopping.maxRounds && !now.converged) {
        Vector6d xi = gaussNewtonStep(now.sums);
        Estimate next = now;
        next.rounds++;
        next.noise = updatedNoise(kind, now.noise, now.sums, now.pose.R, n);
        if (stopping.robust)
            next.noise.tail = updatedTail(data, now.pose, now.noise, now.sums);
        const bool noiseChanged = !isConstant(kind) || next.noise.tail != now.noise.tail;
        next.pose = perturbed(now.pose, xi);
        next.sums = rayPass(data, next.pose, next.noise, lever);
        for (int k = 0; k < STEP_HALVINGS && !accepted(noiseChanged, now.sums, next.sums, n); ++k) {
            xi *= 0.5;
            next.pose = perturbed(now.pose, xi);
            next.sums = rayPass(data, next.pose, next.noise, lever);
        }
        if (!noiseChanged && !accepted(noiseChanged, now.sums, next.sums, n)) {
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
    return alternate(data, start, unit, NoiseKind::FIXED, {30, 1e-12, false}).pose;
}

namespace {

// Evidence: a model with a noise more must be this much better [nat].
constexpr double PENALTY = 2;
// Models less likely than this share of the best do not move the pose.
constexpr double NEGLIGIBLE = 1e-4;
// Fewer points leave too few degrees of freedom for a covariance: isotropic noise.
constexpr int MIN_POINTS_COVARIANCE = 6;
// Object noise in a model of bearing noise alone, as a share of the variance at mean depth: a point at the very centre
// of projection must not weigh infinitely.
constexpr double BEARING_ONLY_SHARE = 1e-6;

Noise isotropic(double a, double b)
{
    return {a * Matrix3d::Identity(), b * Matrix3d::Identity(), 0};
}

// A known noise may be singular, or zero; the determinants must not be.
Matrix3d usable(const Matrix3d& known)
{
    return regular(known, TINY_FLOOR);
}

Estimate estimateIsotropic(const Correspondences& data, const Pose& start, const KnownNoise& Sigma,
                           const KnownNoise& Gamma, const Stopping& stopping)
{
    const Noise object = isotropic(splitResiduals(data, start).aOnly, 0);
    return alternate(data, start, {Sigma ? usable(*Sigma) : object.Sigma, Gamma.value_or(object.Gamma), 0},
                     Sigma ? NoiseKind::FIXED : NoiseKind::ISOTROPIC, {stopping.maxRounds, stopping.tolerance, false});
}

struct Rival
{
    Estimate estimate;
    double penalty;  // nat

    double L() const { return estimate.sums.L + penalty; }
};

// The pose has fitted away six of the 2n residual coordinates; what was estimated from them is that much too small.
Noise restricted(const Estimate& estimate, int n)
{
    const double freedom = 2. * n / (2 * n - 6);
    Noise noise = estimate.noise;
    if (estimate.kind == NoiseKind::OBJECT || estimate.kind == NoiseKind::BOTH)
        noise.Sigma *= freedom;
    if (estimate.kind == NoiseKind::BEARING || estimate.kind == NoiseKind::BOTH)
        noise.Gamma *= freedom;
    return noise;
}

// The posterior mean of the pose over the kinds of noise: where the data cannot tell bearing noise from object noise
// (one depth), the two pull the pose to either side of the truth along the viewing direction.
template <size_t COUNT>
Estimate averaged(const Correspondences& data, const std::array<Rival, COUNT>& rivals)
{
    const auto likelier = [](const Rival& a, const Rival& b) { return a.L() < b.L(); };
    const Rival& best = *std::min_element(rivals.begin(), rivals.end(), likelier);
    Estimate out = best.estimate;
    out.evidence = std::numeric_limits<double>::infinity();
    double total = 0;
    Vector6d mean = Vector6d::Zero();
    Matrix6d square = Matrix6d::Zero();
    for (const Rival& rival : rivals) {
        if (&rival != &best)
            out.evidence = std::min(out.evidence, rival.L() - best.L());
        const double weight = std::exp(best.L() - rival.L());
        if (!(weight > NEGLIGIBLE))
            continue;
        const Vector6d xi = difference(rival.estimate.pose, best.estimate.pose);
        total += weight;
        mean += weight * xi;
        square += weight * xi * xi.transpose();
    }
    mean /= total;
    out.spread = square / total - mean * mean.transpose();
    out.pose = perturbed(best.estimate.pose, mean);
    out.noise = restricted(out, data.size());
    out.sums = rayPass(data, out.pose, out.noise);
    return out;
}

}  // namespace

Estimate estimatePublished(const Correspondences& data, const Pose& start, const KnownNoise& Sigma,
                           const KnownNoise& Gamma, const Stopping& stopping)
{
    if (data.size() < MIN_POINTS_COVARIANCE)
        return estimateIsotropic(data, start, Sigma, Gamma, stopping);
    const Noise noise{Sigma ? usable(*Sigma) : Matrix3d::Identity(), Gamma.value_or(Matrix3d::Zero()), 0};
    return alternate(data, start, noise, Sigma ? NoiseKind::FIXED : NoiseKind::PUBLISHED, stopping);
}

Estimate estimateMarginal(const Correspondences& data, const Pose& start, const KnownNoise& Sigma,
                          const KnownNoise& Gamma, const Stopping& stopping)
{
    const auto run = [&](const Noise& noise, NoiseKind kind) { return alternate(data, start, noise, kind, stopping); };
    if (Sigma && Gamma)
        return run({usable(*Sigma), *Gamma, 0}, NoiseKind::FIXED);
    if (data.size() < MIN_POINTS_COVARIANCE)
        return estimateIsotropic(data, start, Sigma, Gamma, stopping);
    const ResidualSplit split = splitResiduals(data, start);
    const Noise object = isotropic(split.aOnly, 0);
    const Noise bearing = isotropic(BEARING_ONLY_SHARE * split.bOnly * split.meanDepth2, split.bOnly);
    const Noise both = isotropic(split.a, split.b);

    if (Sigma)
        return averaged(data,
                        std::array<Rival, 2>{Rival{run({usable(*Sigma), object.Gamma, 0}, NoiseKind::FIXED), 0},
                                             Rival{run({usable(*Sigma), both.Gamma, 0}, NoiseKind::BEARING), PENALTY}});
    if (Gamma)
        return averaged(data, std::array<Rival, 2>{Rival{run({bearing.Sigma, *Gamma, 0}, NoiseKind::FIXED), 0},
                                                   Rival{run({both.Sigma, *Gamma, 0}, NoiseKind::OBJECT), PENALTY}});
    return averaged(
        data, std::array<Rival, 3>{Rival{run(object, NoiseKind::OBJECT), 0}, Rival{run(bearing, NoiseKind::BEARING), 0},
                                   Rival{run(both, NoiseKind::BOTH), PENALTY}});
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
