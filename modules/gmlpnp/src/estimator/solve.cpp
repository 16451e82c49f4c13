// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "kinds_of_noise.hpp"
#include "pose_covariance.hpp"
#include "solve.hpp"
#include "starting_poses.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

// The method on one page. It answers three nested questions:
//
//     which minimum   the isotropic cost has a few, of which one is right      starting_poses, rating
//     which noise     object noise, bearing noise, or both                     kinds_of_noise, averaging
//     which step      of the pose by Gauss-Newton, of the noise by MM          alternation
//
// Where only the pose is asked for, they are asked of a small part of many points first, and of all points at the end.

Status check(const Correspondences& data, int fewest)
{
    if (!data.finite())
        return STATUS_NOT_FINITE;
    if (data.degenerate())
        return STATUS_DEGENERATE;
    return data.hasPlaces(fewest) ? STATUS_CONVERGED : STATUS_TOO_FEW_POINTS;
}

namespace {

FitOptions fitOptions(const Options& options, const StartingPoses& starts)
{
    // Accurate sums are needed to compare the pose with others and for everything that is reported about it.
    const bool compared = options.guess || (starts.poses.size() > 1 && !starts.chosen);
    return {options.limits, options.tails, options.report || compared ? SumsNeeded::EXACT : SumsNeeded::ROUGH,
            options.report ? NoiseStep::SCORING : NoiseStep::SCORING_SAMPLED};
}

Estimate fitFrom(const Subsets& data, const Pose& start, const Options& options, const FitOptions& fitting)
{
    const double unit = 1 / (data.first().scale * data.first().scale);
    const KnownNoise Sigma = options.Sigma ? KnownNoise(unit * *options.Sigma) : std::nullopt;
    return options.marginal() ? fitMarginal(data, start, Sigma, options.Gamma, fitting)
                              : fitPublished(data, start, Sigma, options.Gamma, fitting);
}

// A guess is never made worse: the cost at the noise that was found does not end above that of the guess.
void keepGuessIfBetter(const Correspondences& data, const Pose& guess, Estimate& found)
{
    const RaySums sums = rayPass(data, guess, found.noise);
    if (sums.L < found.sums.L) {
        found.pose = guess;
        found.sums = sums;
    }
}

bool isPose(const Estimate& estimate, int n)
{
    return std::isfinite(estimate.sums.L) && estimate.pose.t.allFinite() && estimate.spread.allFinite() &&
           determined(estimate.sums.H) && 2 * estimate.sums.inFront > n;
}

// Two poses are one when they differ by far less than any data can tell [rad, and share of the distance]. It is closer
// than two minima of the isotropic cost (initial_pose.cpp), because the alternation has ended at both.
bool samePose(const Pose& a, const Pose& b)
{
    constexpr double SAME = 1e-5;
    return (a.R - b.R).norm() < SAME && (a.t - b.t).norm() < SAME * b.t.norm();
}

void sortByLikelihood(std::vector<Estimate>& found)
{
    const auto L = [](const Estimate& each) { return each.sums.L; };
    std::sort(found.begin(), found.end(), [=](const Estimate& a, const Estimate& b) { return L(a) < L(b); });
    // With a known noise the likelihoods of the poses themselves tell which is right.
    if (!found.empty() && found.front().kind == NoiseKind::FIXED)
        for (size_t k = 0; k < found.size(); ++k)
            found[k].poseEvidence = evidenceOf(k, found, L);
}

// The distinct poses to which the starts lead, best first; one alone where the best start was chosen beforehand.
std::vector<Estimate> fitAll(const Subsets& data, const StartingPoses& starts, const Options& options)
{
    const Correspondences& all = data[data.count() - 1];
    const FitOptions fitting = fitOptions(options, starts);
    std::vector<Estimate> found;
    for (const Start& start : starts.poses) {
        Estimate estimate = fitFrom(data, start.pose, options, fitting);
        estimate.poseEvidence = start.evidence;
        if (options.guess)
            keepGuessIfBetter(all, all.fromObject(*options.guess), estimate);
        const auto isKnown = [&](const Estimate& other) { return samePose(other.pose, estimate.pose); };
        if (isPose(estimate, all.size()) && std::none_of(found.begin(), found.end(), isKnown))
            found.push_back(estimate);
        if (starts.chosen && !found.empty())
            break;
    }
    sortByLikelihood(found);
    return found;
}

// By way of a part of the points where that is enough, or else of all of them.
// @param startsOf the starting poses for these points.
template <class StartsOf>
std::vector<Estimate> fitPoses(const Correspondences& data, const Options& options, const StartsOf& startsOf)
{
    const bool poseOnly = !options.report && !options.everyMinimum && !options.Sigma && !options.Gamma;
    std::vector<Estimate> found;
    if (poseOnly && options.bySubsets) {
        const Subsets subsets = Subsets::growing(data, options.marginal());
        if (subsets.count() > 1 && !subsets.first().degenerate())
            found = fitAll(subsets, startsOf(subsets.first()), options);
    }
    return found.empty() ? fitAll(Subsets(data), startsOf(data), options) : found;
}

}  // namespace

std::optional<Estimate> fitNear(const Correspondences& data, const Pose& start, const Options& options)
{
    const std::vector<Estimate> found =
        fitPoses(data, options, [&](const Correspondences& points) { return startNear(points, start); });
    return found.empty() ? std::nullopt : std::optional<Estimate>(found.front());
}

Status solveMinima(const Observations& observations, const Options& options, std::vector<Solution>& solutions)
{
    if (observations.points.rows < options.fewestPoints())
        return STATUS_TOO_FEW_POINTS;
    const Correspondences data(observations);
    const Status status = check(data, options.fewestPoints());
    if (!isSuccess(status))
        return status;

    std::vector<Estimate> found =
        fitPoses(data, options, [&](const Correspondences& points) { return startingPoses(points, options); });
    if (found.empty())
        return STATUS_DEGENERATE;
    if (!options.everyMinimum)
        found.resize(1);

    solutions.clear();
    for (const Estimate& each : found)
        solutions.push_back(reported(data, each, options));
    // The reported noise may judge near equals otherwise than the one that weighed them.
    std::sort(solutions.begin(), solutions.end(), [](const Solution& a, const Solution& b) { return a.cost < b.cost; });
    return solutions.front().converged ? STATUS_CONVERGED : STATUS_MAX_ROUNDS;
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
