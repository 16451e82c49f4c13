// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "kinds_of_noise.hpp"
#include "rating.hpp"
#include "starting_poses.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

namespace {

// Whether the best minimum is chosen before any pose is refined. Three kinds of problems are left to the end: a known
// noise may be far from the isotropic one of the minima; few points have only the isotropic noise; the published method
// has no likelihood to rate by.
bool canBeRated(const Correspondences& data, const Options& options)
{
    const bool known = options.Sigma || options.Gamma || data.hasKnown();
    return options.marginal() && !options.everyMinimum && !known && data.size() >= MIN_POINTS_COVARIANCE;
}

constexpr double NO_OTHER = std::numeric_limits<double>::infinity();  // evidence where no other minimum is known

// Largest ratio of the costs at which another minimum is still within EVIDENCE nat. The noise is estimated, or known,
// from the n - 3 pairs of coordinates that the pose leaves.
double plausibleRatio(int n)
{
    constexpr double EVIDENCE = 3;
    constexpr int FEWEST = 5;  // with one or two pairs any cost is possible
    return n > FEWEST ? std::exp(EVIDENCE / (n - 3)) : std::numeric_limits<double>::infinity();
}

// Fitted (doc/reliability.md, "(d): the best minimum"): where the noise is far from isotropic the true
// pose has up to 2.2 times the best isotropic cost.
constexpr double RATED_COST_RATIO = 3;

double ratioLookedAt(const Correspondences& data, const Options& options)
{
    if (options.everyMinimum)
        return std::numeric_limits<double>::infinity();
    return canBeRated(data, options) ? RATED_COST_RATIO : INITIAL_COST_RATIO;
}

// A minimum of the isotropic cost with its negative log-likelihood.
struct RatedMinimum
{
    Pose pose;
    double nats;
};

// The likelihood is that with a noise estimated at the minimum, as far as the degrees of freedom of the residuals
// count.
RatedMinimum rated(const Correspondences& data, const Options& options, const PoseCandidate& minimum)
{
    constexpr double EXACT = 1e-13;  // rounding: smaller costs cannot be told apart
    const int n = data.size();
    if (canBeRated(data, options))
        return {minimum.pose, costOfMinimum(data, minimum.pose, options.tails) / restriction(n)};
    return {minimum.pose, std::max(n - 3, 1) * std::log(std::max(minimum.cost, EXACT * n))};
}

}  // namespace

StartingPoses startNear(const Correspondences& data, const Pose& pose)
{
    return {{{isotropicPose(data, pose), NO_OTHER}}, false};
}

StartingPoses startingPoses(const Correspondences& data, const Options& options)
{
    if (options.guess)
        return startNear(data, data.fromObject(*options.guess));
    const double plausible = options.report ? plausibleRatio(data.size()) : 1;
    const std::vector<PoseCandidate> minima = initialPoses(data, std::max(ratioLookedAt(data, options), plausible),
                                                           std::max(CERTIFIED_COST_RATIO, plausible));
    const bool chosen = canBeRated(data, options);
    if (minima.size() == 1)
        return {{{minima.front().pose, NO_OTHER}}, chosen};
    std::vector<RatedMinimum> ratedMinima;
    for (const PoseCandidate& minimum : minima)
        ratedMinima.push_back(rated(data, options, minimum));
    if (chosen)
        std::sort(ratedMinima.begin(), ratedMinima.end(),
                  [](const RatedMinimum& a, const RatedMinimum& b) { return a.nats < b.nats; });
    StartingPoses starts{{}, chosen};
    for (size_t k = 0; k < ratedMinima.size(); ++k)
        starts.poses.push_back(
            {ratedMinima[k].pose, evidenceOf(k, ratedMinima, [](const RatedMinimum& each) { return each.nats; })});
    return starts;
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
