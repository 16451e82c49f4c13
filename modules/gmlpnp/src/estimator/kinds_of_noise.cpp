// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "../noise/model.hpp"
#include "kinds_of_noise.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

namespace {

// A known noise may be singular, or zero; the determinants must not be.
Matrix3d usable(const Matrix3d& known)
{
    return regular(floored(known, TINY_FLOOR), 0);
}

Estimate fitIsotropic(const Correspondences& data, const Pose& start, const KnownNoise& Sigma, const KnownNoise& Gamma,
                      FitOptions options)
{
    const Noise object = isotropic(splitResiduals(data, start).object.a, 0);
    options.tails = false;
    return alternate(data, start,
                     {{Sigma ? usable(*Sigma) : object.Sigma, Gamma.value_or(object.Gamma), {}},
                      Sigma ? NoiseKind::FIXED : NoiseKind::ISOTROPIC},
                     options);
}

// Points whose known noise is far below that of others bend the cost: where their residuals are many deviations,
// Gauss-Newton leaves in their direction for good. So the pose starts with a common noise on top of the known one,
// which falls until the residuals are as large as the known noise lets expect.
Pose annealToKnown(const Correspondences& data, Pose pose, const Noise& known)
{
    // The first is the mean squared residual over its expectation, the second the factor of the variance. Both are held
    // by Gmlpnp_Solve.knownNoisesOfVeryDifferentSizes.
    constexpr double GROSS = 2, STEP = 0.01;
    constexpr Limits FEW_ROUNDS = {5, DEFAULT_TOLERANCE};
    const auto gross = [&] { return !(rayPass(data, pose, known).misfit <= GROSS * data.size()); };
    for (double common = splitResiduals(data, pose).object.a; common > NOISE_FLOOR * NOISE_FLOOR && gross();
         common *= STEP)
        pose = alternate(data, pose, {{known.Sigma + common * Matrix3d::Identity(), known.Gamma, {}}, NoiseKind::FIXED},
                         {FEW_ROUNDS, false, SumsNeeded::ROUGH})
                   .pose;
    return pose;
}

// L has optima that are no poses anybody wants: noise as large as the object explains any rays once the camera is
// inside it, or a flat object is seen edge on. Such an end is far from the isotropic pose and fits clearly worse. Both
// bounds are fitted: gmlpnp_reliability, held by Gmlpnp_RunawayStatistics.doesNotRunAwayFromTheIsotropicPose.
bool noiseSwallowedTheObject(const Correspondences& data, const Pose& start, const Estimate& end)
{
    constexpr double FAR = 0.15;                         // rad
    constexpr double WORSE = 12;                         // twice the mean of a chi-squared of 6 degrees of freedom
    const bool wrongPoints = end.noise.tails.share > 0;  // they spoil the isotropic pose, not this one
    if (wrongPoints || (end.pose.R - start.R).squaredNorm() < 2 * FAR * FAR)
        return false;
    const Noise unit = isotropic(1, 0);
    const double least = rayPass(data, start, unit).misfit, excess = rayPass(data, end.pose, unit).misfit - least;
    return !((2 * data.size() - 6) * excess <= WORSE * least);
}

// A pose and a noise at which the fit of a kind starts, and the isotropic ones that it falls back to.
struct KindStart
{
    Pose pose;
    NoiseStart noise;
    Pose isotropicPose;
    Noise isotropicNoise;
};

// The alternation of one kind. Where the noise swallows the object, the isotropic noise stays as it is, without tails:
// anisotropy would look like them.
Estimate fitKind(const Correspondences& data, const KindStart& start, FitOptions options)
{
    Estimate found = alternate(data, start.pose, start.noise, options);
    if (noiseSwallowedTheObject(data, start.isotropicPose, found)) {
        options.tails = false;
        found = alternate(data, start.isotropicPose,
                          {start.isotropicNoise, NoiseKind::ISOTROPIC, start.noise.otherKnown}, options);
    }
    return found;
}

// A kind of noise as isotropic residuals rate it.
struct RatedKind
{
    NoiseKind kind;
    IsotropicNoise isotropic;
    double prior;  // nat

    double cost() const { return isotropic.cost + penaltyOf(kind); }
};

// The kinds that anisotropy may still make the likeliest, best first.
struct PlausibleKinds
{
    std::array<RatedKind, KINDS> kinds;
    int count = 0;
    double evidence;  // of the first over the best that was left out [nat]
};

PlausibleKinds plausibleKinds(const IsotropicSplit& split)
{
    // Both noises without this much more gain [nat] than the penalty asks are one of them and a little of the other.
    constexpr double BOTH_MARGIN = 1;
    // The gain of a shape [nat]: a wider margin changes no figure of doc/lab/.
    const double margin = negligibleMargin();

    const auto rated = [&](NoiseKind kind, const IsotropicNoise& isotropic) {
        return RatedKind{kind, isotropic, priorCost(kind, split)};
    };
    std::array<RatedKind, KINDS> all = {rated(NoiseKind::OBJECT, split.object),
                                        rated(NoiseKind::BEARING, split.bearing), rated(NoiseKind::BOTH, split.both)};
    std::sort(all.begin(), all.end(), [](const RatedKind& a, const RatedKind& b) { return a.cost() < b.cost(); });
    PlausibleKinds plausible{all, 0, std::numeric_limits<double>::infinity()};
    for (const RatedKind& kind : all) {
        const double behind = kind.cost() - all[0].cost();
        if (behind <= (kind.kind == NoiseKind::BOTH ? BOTH_MARGIN : margin))
            plausible.kinds[plausible.count++] = kind;
        else
            plausible.evidence = std::min(plausible.evidence, behind);
    }
    return plausible;
}

// Noise of the size that isotropic residuals give a kind, with the shape and the tails that another kind came to.
Noise inShapeOf(const Estimate& other, double meanDepth2, const IsotropicNoise& size)
{
    const Matrix3d& R = other.pose.R;
    const Matrix3d total = R * other.noise.Sigma * R.transpose() + meanDepth2 * other.noise.Gamma;
    const Matrix3d shape = 3 / total.trace() * total;
    return {symmetrised(size.a * R.transpose() * shape * R), size.b * shape, other.noise.tails};
}

// Each kind starts where the one before it ended.
KindFits fitKinds(const Correspondences& data, const Pose& start, const FitOptions& options, const Tails& tails)
{
    const IsotropicSplit split = splitResiduals(data, start);
    const PlausibleKinds plausible = plausibleKinds(split);
    KindFits fits;
    for (int k = 0; k < plausible.count; ++k) {
        const RatedKind& kind = plausible.kinds[k];
        Noise unshaped = isotropic(kind.isotropic.a, kind.isotropic.b);
        unshaped.tails = tails;
        const Estimate* before = k > 0 ? &fits[k - 1].estimate : nullptr;
        const Noise noise = before ? inShapeOf(*before, split.meanDepth2, kind.isotropic) : unshaped;
        FitOptions fitting = options;
        fitting.sums = plausible.count > 1 ? SumsNeeded::COMPARABLE : SumsNeeded::ROUGH;
        const KindStart from = {before ? before->pose : start, {noise, kind.kind}, start, unshaped};
        KindFit& fit = fits.add({fitKind(data, from, fitting), penaltyOf(kind.kind), kind.prior});
        fit.estimate.evidence = plausible.evidence;
    }
    return fits;
}

// One noise is known. The other one is estimated, or absent.
Estimate fitBesideKnown(const Correspondences& data, const Pose& start, const KnownNoise& Sigma,
                        const KnownNoise& Gamma, FitOptions options)
{
    const IsotropicSplit split = splitResiduals(data, start);
    const Noise both = isotropic(split.both.a, split.both.b), alone = isotropic(split.bearing.a, 0);
    const Noise without{Sigma ? usable(*Sigma) : alone.Sigma, Gamma.value_or(Matrix3d::Zero()), {}};
    const Noise with{Sigma ? without.Sigma : both.Sigma, Sigma ? both.Gamma : without.Gamma, {}};
    const NoiseKind estimated = Sigma ? NoiseKind::BEARING : NoiseKind::OBJECT;
    const SumsNeeded sums = std::exchange(options.sums, SumsNeeded::COMPARABLE);
    KindFits fits;
    fits.add({alternate(data, start, {without, NoiseKind::FIXED, true}, options)});
    fits.add({fitKind(data, {start, {with, estimated, true}, start, with}, options), penaltyOf(NoiseKind::BOTH)});
    return averaged(data, fits, sums);
}

}  // namespace

Estimate fitPublished(const Subsets& data, const Pose& start, const KnownNoise& Sigma, const KnownNoise& Gamma,
                      const FitOptions& options)
{
    const Correspondences& first = data.first();
    if (first.size() < MIN_POINTS_COVARIANCE)
        return fitIsotropic(first, start, Sigma, Gamma, options);
    const Noise noise{Sigma ? usable(*Sigma) : Matrix3d::Identity(), Gamma.value_or(Matrix3d::Zero()), {}};
    Estimate found = alternate(first, start, {noise, Sigma ? NoiseKind::FIXED : NoiseKind::PUBLISHED}, options);
    for (int k = 1; k < data.count(); ++k)
        found = extended(data[k], found, data[k - 1].size(), options);
    return found;
}

Estimate fitMarginal(const Subsets& data, const Pose& start, const KnownNoise& Sigma, const KnownNoise& Gamma,
                     const FitOptions& options, const Tails& tails)
{
    const Correspondences& first = data.first();
    if (Sigma && Gamma) {
        const Noise known{usable(*Sigma), *Gamma, {}};
        return alternate(first, annealToKnown(first, start, known), {known, NoiseKind::FIXED}, options);
    }
    if (first.size() < MIN_POINTS_COVARIANCE)
        return fitIsotropic(first, start, Sigma, Gamma, options);
    if (Sigma || Gamma)
        return fitBesideKnown(first, start, Sigma, Gamma, options);

    KindFits fits = fitKinds(first, start, options, tails);
    FitOptions extending = options;
    extending.sums = fits.size() > 1 ? SumsNeeded::COMPARABLE : SumsNeeded::ROUGH;
    for (int k = 1; k < data.count(); ++k)
        fits = extended(data[k], fits, data[k - 1].size(), extending);
    return averaged(data[data.count() - 1], fits, options.sums);
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
