// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "../noise/scoring.hpp"
#include "subsets.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

// Fitted: with these the errors of the pose are those of all points for everything, within 1 % (doc/lab/performance.md,
// held by Gmlpnp_PartsStatistics.thePoseOfManyPointsIsAsGoodAsFromAllOfThem).
namespace {

constexpr int FIRST = 300;  // points of the first subset
constexpr int MANY = 600;   // points from which on subsets are worth it
constexpr int GROWTH = 8;   // ratio of the sizes of two subsets

}  // namespace

Subsets Subsets::growing(const Correspondences& all, bool everySize)
{
    Subsets subsets(all);
    if (all.size() < MANY)
        return subsets;
    if (everySize)
        for (int size = all.size() / GROWTH; size > FIRST; size /= GROWTH)
            subsets.parts_.push_back(all.part(size));
    subsets.parts_.push_back(all.part(FIRST));
    std::reverse(subsets.parts_.begin(), subsets.parts_.end());
    return subsets;
}

namespace {

// Proposition 1 of the paper, with the noise of the subset.
Estimate publishedStep(const Correspondences& data, Estimate now)
{
    now.sums = rayPass(data, now.pose, now.noise, {LeverArm::AS_GIVEN});
    now.pose = perturbed(now.pose, gaussNewtonStep(now.sums));
    now.rounds = 1;
    return now;
}

Estimate fewRounds(const Correspondences& data, const Estimate& from, FitOptions options)
{
    // What the last step leaves is far less than this [nat]. Scoring squares the error, so it may stop earlier still.
    constexpr double LEFT = 4, LEFT_BY_SCORING = 0.4;
    constexpr int ROUNDS = 3;
    options.step = NoiseStep::SCORING_FROZEN;
    options.sums = SumsNeeded::ANY;
    options.tails = false;
    options.limits.tolerance =
        std::max(options.limits.tolerance, productsFor(from.kind) != NO_PRODUCTS ? LEFT_BY_SCORING : LEFT);
    options.limits.rounds = std::min(ROUNDS, options.limits.rounds);
    return alternate(data, from.pose, {from.noise, from.kind}, options);
}

// Whether a subset of this size explains by chance how far the pose of all points is from its own.
bool byChance(const Estimate& now, const Pose& ofSubset, double ratio)
{
    constexpr double UNLIKELY = 60;  // xi^T H xi is the ratio times a chi-squared of 6 degrees of freedom
    const Vector6d xi = difference(now.pose, ofSubset);
    return xi.dot(now.sums.H * xi) <= UNLIKELY * ratio;
}

}  // namespace

// The one step of the published method comes on top of its rounds, which are always the same few.
Estimate extended(const Correspondences& data, const Estimate& fromSubset, int size, const FitOptions& options)
{
    const bool published = fromSubset.kind == NoiseKind::PUBLISHED;
    FitOptions rest = options;
    if (!published)
        rest.limits.rounds -= fromSubset.rounds;
    if (rest.limits.rounds < 1)
        return fromSubset;
    Estimate now = published ? publishedStep(data, fromSubset) : fewRounds(data, fromSubset, rest);
    int rounds = fromSubset.rounds + now.rounds;
    const bool settled = (published || now.converged) && byChance(now, fromSubset.pose, double(data.size()) / size);
    if (!settled) {
        if (!published)
            rest.limits.rounds -= now.rounds;
        now = alternate(data, now.pose, {now.noise, now.kind}, rest);
        rounds += now.rounds;
    }
    now.rounds = rounds;
    now.evidence = fromSubset.evidence;
    return now;
}

KindFits extended(const Correspondences& data, const KindFits& fromSubset, int size, const FitOptions& options)
{
    KindFits larger;
    for (const KindFit& fit : withoutNegligible(fromSubset))
        larger.add({extended(data, fit.estimate, size, options), fit.penalty, fit.prior});
    return larger;
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
