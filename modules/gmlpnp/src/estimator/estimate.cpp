// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "estimate.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

namespace {

// Evidence: a model with a noise more must be this much better [nat].
constexpr double PENALTY = 2;
// Models less likely than this share of the best do not move the pose.
constexpr double NEGLIGIBLE = 1e-3;

// A known noise may be singular, or zero; the determinants must not be.
Matrix3d usable(const Matrix3d& known)
{
    return regular(floored(known, TINY_FLOOR), 0);
}

Estimate estimateIsotropic(const Correspondences& data, const Pose& start, const KnownNoise& Sigma,
                           const KnownNoise& Gamma, const Stopping& stopping)
{
    const Noise object = isotropic(splitResiduals(data, start).object.a, 0);
    return alternate(data, start, {Sigma ? usable(*Sigma) : object.Sigma, Gamma.value_or(object.Gamma), {}},
                     Sigma ? NoiseKind::FIXED : NoiseKind::ISOTROPIC,
                     {stopping.maxRounds, stopping.tolerance, false, stopping.last});
}

// Points whose known noise is far below that of others bend the cost: where their residuals are many standard
// deviations, Gauss-Newton leaves in their direction for good. So from the isotropic pose on a common noise falls until
// the residuals are what the known noise lets expect.
Pose nearKnown(const Correspondences& data, Pose pose, const Noise& noise)
{
    constexpr double GROSS = 2, STEP = 0.01;  // mean squared residual over its expectation; factor of the variance
    const auto gross = [&] { return !(rayPass(data, pose, noise).misfit <= GROSS * data.size()); };
    for (double common = splitResiduals(data, pose).object.a; common > NOISE_FLOOR * NOISE_FLOOR && gross();
         common *= STEP)
        pose = alternate(data, pose, {noise.Sigma + common * Matrix3d::Identity(), noise.Gamma, {}}, NoiseKind::FIXED,
                         {5, DEFAULT_TOLERANCE, false, LastSums::NOTHING})
                   .pose;
    return pose;
}

// L has optima that are no poses anybody wants: noise as large as the object explains any rays once the camera is
// inside it, or a flat object is seen edge on. Such an end is far from the isotropic pose and fits clearly worse.
bool ranAway(const Correspondences& data, const Pose& start, const Estimate& end)
{
    constexpr double NEAR = 0.15;                        // rad
    constexpr double WORSE = 12;                         // twice the mean of a chi-squared of 6 degrees of freedom
    const bool wrongPoints = end.noise.tails.share > 0;  // they spoil the isotropic pose, not this one
    if (wrongPoints || (end.pose.R - start.R).squaredNorm() < 2 * NEAR * NEAR)
        return false;
    const Noise unit = isotropic(1, 0);
    const double least = rayPass(data, start, unit).misfit, excess = rayPass(data, end.pose, unit).misfit - least;
    return !((2 * data.size() - 6) * excess <= WORSE * least);
}

// The alternation from a pose and a noise near its end. Where it runs away from the isotropic pose it is done again
// from there, with an isotropic noise that stays, and no tails: anisotropy would look like them.
Estimate contend(const Correspondences& data, const Pose& start, const Noise& unshaped, NoiseKind kind,
                 const Pose& from, const Noise& noise, const Stopping& stopping)
{
    Estimate found = alternate(data, from, noise, kind, stopping);
    if (ranAway(data, start, found)) {
        Stopping plain = stopping;
        plain.robust = false;
        found = alternate(data, start, unshaped, NoiseKind::ISOTROPIC, plain);
    }
    return found;
}

struct Rival
{
    Estimate estimate;
    double penalty;    // nat
    double prior = 0;  // nat, where the data cannot tell

    double L() const { return estimate.sums.L + penalty; }
    double posterior() const { return L() + prior; }
};

// The pose has fitted away six of the 2n residual coordinates; what was estimated from them is that much too small.
Noise restricted(const Estimate& estimate, int n)
{
    Noise noise = estimate.noise;
    if (estimate.kind == NoiseKind::OBJECT || estimate.kind == NoiseKind::BOTH)
        noise.Sigma *= freedom(n);
    if (estimate.kind == NoiseKind::BEARING || estimate.kind == NoiseKind::BOTH)
        noise.Gamma *= freedom(n);
    return noise;
}

constexpr int KINDS = 3;
using Shares = std::array<double, KINDS>;
using Deviations = std::array<Vector6d, KINDS>;

// Shares of e^-cost; none of what is negligible.
template <class Cost>
Shares sharesOf(const Rival* rivals, int count, const Cost& cost)
{
    double least = std::numeric_limits<double>::infinity(), total = 0;
    for (int k = 0; k < count; ++k)
        least = std::min(least, cost(rivals[k]));
    Shares shares{};
    for (int k = 0; k < count; ++k) {
        const double weight = std::exp(least - cost(rivals[k]));
        shares[k] = weight > NEGLIGIBLE ? weight : 0;
        total += shares[k];
    }
    for (double& share : shares)
        share /= total;
    return shares;
}

Deviations deviationsFrom(const Rival& best, const Rival* rivals, int count)
{
    Deviations xi;
    xi.fill(Vector6d::Zero());
    for (int k = 0; k < count; ++k)
        if (&rivals[k] != &best)
            xi[k] = difference(rivals[k].estimate.pose, best.estimate.pose);
    return xi;
}

Vector6d meanOf(const Deviations& xi, const Shares& shares)
{
    Vector6d mean = Vector6d::Zero();
    for (int k = 0; k < KINDS; ++k)
        if (shares[k] > 0)
            mean += shares[k] * xi[k];
    return mean;
}

// Summed as squares: poses may be so far apart that differences of their squares are rounding.
Matrix6d spreadAbout(const Vector6d& centre, const Deviations& xi, const Shares& shares)
{
    Matrix6d spread = Matrix6d::Zero();
    for (int k = 0; k < KINDS; ++k)
        if (shares[k] > 0)
            spread += shares[k] * (xi[k] - centre) * (xi[k] - centre).transpose();
    return spread;
}

// The posterior mean of the pose over the kinds of noise: where the data cannot tell bearing noise from object noise
// (one depth), the two pull the pose to either side of the truth along the viewing direction. What the prior decided is
// no knowledge: the spread about that mean is by the likelihoods alone.
Estimate averaged(const Correspondences& data, const Rival* rivals, int count, LastSums last)
{
    const Rival& best = *std::min_element(rivals, rivals + count,
                                          [](const Rival& a, const Rival& b) { return a.posterior() < b.posterior(); });
    Estimate out = best.estimate;
    for (const Rival* rival = rivals; rival != rivals + count; ++rival)
        if (rival != &best)
            out.evidence = std::min(out.evidence, std::max(0., rival->L() - best.L()));
    const Deviations xi = deviationsFrom(best, rivals, count);
    const Vector6d mean = meanOf(xi, sharesOf(rivals, count, [](const Rival& r) { return r.posterior(); }));
    const Shares likelihood = sharesOf(rivals, count, [](const Rival& r) { return r.L(); });
    out.spread = spreadAbout(mean, xi, likelihood);
    out.pose = perturbed(best.estimate.pose, mean);
    out.noise = restricted(out, data.size());
    const bool far = !(0.5 * mean.dot(best.estimate.sums.H * mean) < RISE);
    if (last == LastSums::AT_POSE || far)
        out.sums = rayPass(data, out.pose, out.noise);
    // Between two minima the mean is no pose that anything speaks for.
    if (far && !accepted(true, best.estimate.sums, out.sums, data.size())) {
        out.pose = best.estimate.pose;
        out.spread = spreadAbout(Vector6d::Zero(), xi, likelihood);
        out.sums = rayPass(data, out.pose, out.noise);
    }
    return out;
}

// A kind of noise with the isotropic noise it starts from.
struct Contender
{
    NoiseKind kind;
    IsotropicNoise start;
    double penalty = 0;  // nat
    double prior = 0;    // nat

    double cost() const { return start.cost + penalty; }
};

// Those that isotropic noises leave in the race, the likeliest first.
struct Race
{
    std::array<Contender, KINDS> contenders;
    int count = 0;
    double evidence;  // nat, of the first over the best that was left out
};

}  // namespace

double evidenceAsked(NoiseKind kind)
{
    return kind == NoiseKind::BOTH ? PENALTY : 0;
}

double priorAgainst(NoiseKind kind, const IsotropicSplit& split)
{
    // In favour of bearing noise [nat], and the relative variance of s^2 by which the data begin to tell.
    constexpr double COMPACT_PRIOR = 8, COMPACT = 0.02;
    return kind == NoiseKind::OBJECT ? COMPACT_PRIOR * std::exp(-split.depth2Variance / COMPACT) : 0;
}

namespace {

Race contenders(const IsotropicSplit& split)
{
    // What anisotropy may make up for [nat]; measured: a wider margin changes no figure.
    const double margin = -std::log(NEGLIGIBLE);
    // Both noises are one of them and a little of the other where they do not gain this much more than the penalty
    // asks.
    constexpr double BOTH_MARGIN = 1;

    std::array<Contender, KINDS> all = {Contender{NoiseKind::OBJECT, split.object},
                                        Contender{NoiseKind::BEARING, split.bearing},
                                        Contender{NoiseKind::BOTH, split.both}};
    for (Contender& contender : all) {
        contender.penalty = evidenceAsked(contender.kind);
        contender.prior = priorAgainst(contender.kind, split);
    }
    std::sort(all.begin(), all.end(), [](const Contender& a, const Contender& b) { return a.cost() < b.cost(); });
    Race race{all, 0, std::numeric_limits<double>::infinity()};
    for (const Contender& contender : all) {
        const double behind = contender.cost() - all[0].cost();
        if (behind <= (contender.kind == NoiseKind::BOTH ? BOTH_MARGIN : margin))
            race.contenders[race.count++] = contender;
        else
            race.evidence = std::min(race.evidence, behind);
    }
    return race;
}

// The noise of a contender with the shape and the tails that another kind came to.
Noise inShapeOf(const Estimate& other, double meanDepth2, const IsotropicNoise& size)
{
    const Matrix3d& R = other.pose.R;
    const Matrix3d total = R * other.noise.Sigma * R.transpose() + meanDepth2 * other.noise.Gamma;
    const Matrix3d shape = 3 / total.trace() * total;
    return {symmetrised(size.a * R.transpose() * shape * R), size.b * shape, other.noise.tails};
}

}  // namespace

Estimate estimatePublished(const Correspondences& data, const Pose& start, const KnownNoise& Sigma,
                           const KnownNoise& Gamma, const Stopping& stopping, const Parts& parts)
{
    if (data.size() < MIN_POINTS_COVARIANCE)
        return estimateIsotropic(data, start, Sigma, Gamma, stopping);
    const Noise noise{Sigma ? usable(*Sigma) : Matrix3d::Identity(), Gamma.value_or(Matrix3d::Zero()), {}};
    const NoiseKind kind = Sigma ? NoiseKind::FIXED : NoiseKind::PUBLISHED;
    if (parts.empty())
        return alternate(data, start, noise, kind, stopping);
    return overAll(data, alternate(parts.front(), start, noise, kind, stopping), parts.front().size(), stopping);
}

namespace {

// One noise is known; the other is there or not.
Estimate estimateOther(const Correspondences& data, const Pose& start, const KnownNoise& Sigma, const KnownNoise& Gamma,
                       const Stopping& stopping)
{
    const IsotropicSplit split = splitResiduals(data, start);
    const Noise both = isotropic(split.both.a, split.both.b), bearing = isotropic(split.bearing.a, 0);
    const Noise without{Sigma ? usable(*Sigma) : bearing.Sigma, Gamma.value_or(Matrix3d::Zero()), {}};
    const Noise with{Sigma ? without.Sigma : both.Sigma, Sigma ? both.Gamma : without.Gamma, {}};
    const NoiseKind estimated = Sigma ? NoiseKind::BEARING : NoiseKind::OBJECT;
    Stopping fitting = stopping;
    fitting.last = LastSums::COMPARE;
    fitting.otherKnown = true;
    const std::array<Rival, 2> rivals = {Rival{alternate(data, start, without, NoiseKind::FIXED, fitting), 0},
                                         Rival{contend(data, start, with, estimated, start, with, fitting), PENALTY}};
    return averaged(data, rivals.data(), 2, stopping.last);
}

// Those that the part of this size has not ruled out, over more points; how many.
int overAll(const Correspondences& data, Rival* rivals, int count, int size, const Stopping& stopping)
{
    double likeliest = std::numeric_limits<double>::infinity(), best = likeliest;
    for (int k = 0; k < count; ++k) {
        likeliest = std::min(likeliest, rivals[k].L());
        best = std::min(best, rivals[k].posterior());
    }
    int kept = 0;
    for (int k = 0; k < count; ++k)
        if (std::exp(likeliest - rivals[k].L()) > NEGLIGIBLE || std::exp(best - rivals[k].posterior()) > NEGLIGIBLE)
            rivals[kept++] = {overAll(data, rivals[k].estimate, size, stopping), rivals[k].penalty, rivals[k].prior};
    return kept;
}

}  // namespace

Estimate estimateMarginal(const Correspondences& data, const Pose& start, const KnownNoise& Sigma,
                          const KnownNoise& Gamma, const Stopping& stopping, const Parts& parts)
{
    if (Sigma && Gamma) {
        const Noise noise{usable(*Sigma), *Gamma, {}};
        return alternate(data, nearKnown(data, start, noise), noise, NoiseKind::FIXED, stopping);
    }
    if (data.size() < MIN_POINTS_COVARIANCE)
        return estimateIsotropic(data, start, Sigma, Gamma, stopping);
    if (Sigma || Gamma)
        return estimateOther(data, start, Sigma, Gamma, stopping);

    const Correspondences& fitted = parts.empty() ? data : parts.front();
    const IsotropicSplit split = splitResiduals(fitted, start);
    const Race race = contenders(split);
    std::array<Rival, KINDS> rivals;
    Stopping fitting = stopping;
    fitting.last = race.count > 1 ? LastSums::COMPARE : LastSums::NOTHING;
    for (int k = 0; k < race.count; ++k) {
        const Contender& next = race.contenders[k];
        Noise unshaped = isotropic(next.start.a, next.start.b);
        unshaped.tails = stopping.tails;
        // A kind starts where the one before it ended.
        const Pose& from = k == 0 ? start : rivals[k - 1].estimate.pose;
        const Noise noise = k == 0 ? unshaped : inShapeOf(rivals[k - 1].estimate, split.meanDepth2, next.start);
        rivals[k] = {contend(fitted, start, unshaped, next.kind, from, noise, fitting), next.penalty, next.prior};
        rivals[k].estimate.evidence = race.evidence;
    }
    int count = race.count;
    for (size_t k = 0; k < parts.size(); ++k) {
        const Correspondences& larger = k + 1 < parts.size() ? parts[k + 1] : data;
        count = overAll(larger, rivals.data(), count, parts[k].size(), fitting);
    }
    return averaged(data, rivals.data(), count, stopping.last);
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
