// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "initial_pose.hpp"
#include "noise_estimate.hpp"
#include "rating.hpp"
#include "solve.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

namespace {

// Whether the best minimum is chosen before the alternation. A known noise may be far from the isotropic one of the
// minima, few points have none but that, and the published one has no likelihood to rate by.
bool chosenAsMinimum(const Correspondences& data, const Options& options)
{
    const bool known = options.Sigma || options.Gamma || data.hasKnown();
    return options.method == SOLVEPNP_GMLPNP_MARGINAL && !options.everyMinimum && !known &&
           data.size() >= MIN_POINTS_COVARIANCE;
}

// Up to which ratio of the costs a minimum is less than EVIDENCE nat behind: noise that is estimated, or known, from
// the n - 3 pairs of coordinates that the pose leaves.
double rivalRatio(int n)
{
    constexpr double EVIDENCE = 3;
    constexpr int FEW = 5;  // with one or two pairs any cost is possible
    return n > FEW ? std::exp(EVIDENCE / (n - 3)) : std::numeric_limits<double>::infinity();
}

// Minima up to this ratio to the best isotropic cost are rated: of noise that is far from isotropic the true pose has
// cost up to 2.2 times as much.
constexpr double RATED_COST_RATIO = 3;

// The cost of a minimum becomes its negative log-likelihood [nat] at a noise that is estimated with it, as far as the
// freedom of the residuals counts.
void rate(const Correspondences& data, const Options& options, PoseCandidate& minimum)
{
    constexpr double EXACT = 1e-13;  // what is below is rounding
    const int n = data.size();
    if (chosenAsMinimum(data, options))
        minimum.cost = costOfMinimum(data, minimum.pose, options.stopping.robust) / freedom(n);
    else
        minimum.cost = std::max(n - 3, 1) * std::log(std::max(minimum.cost, EXACT * n));
}

// Where the best minimum is chosen, the best first; with their costs in nats.
std::vector<PoseCandidate> startingPoses(const Correspondences& data, const Options& options)
{
    if (options.guess)
        return {{isotropicPose(data, data.fromObject(*options.guess)), 0}};
    const double rivals = options.extras ? rivalRatio(data.size()) : 1;
    const double looked = options.everyMinimum             ? std::numeric_limits<double>::infinity()
                          : chosenAsMinimum(data, options) ? RATED_COST_RATIO
                                                           : INITIAL_COST_RATIO;
    std::vector<PoseCandidate> minima =
        initialPoses(data, std::max(looked, rivals), std::max(CERTIFIED_COST_RATIO, rivals));
    if (minima.size() == 1)
        return minima;
    for (PoseCandidate& minimum : minima)
        rate(data, options, minimum);
    if (chosenAsMinimum(data, options))
        std::sort(minima.begin(), minima.end(),
                  [](const PoseCandidate& a, const PoseCandidate& b) { return a.cost < b.cost; });
    return minima;
}

// By how much one of the minima is likelier than the best other [nat]; costOf: its negative log-likelihood.
template <class Minimum, class Cost>
double lead(const std::vector<Minimum>& minima, size_t which, const Cost& costOf)
{
    double least = std::numeric_limits<double>::infinity();
    for (size_t k = 0; k < minima.size(); ++k)
        if (k != which)
            least = std::min(least, costOf(minima[k]) - costOf(minima[which]));
    return least;
}

Estimate estimate(const Correspondences& data, const Pose& start, const Options& options, const Parts& parts)
{
    const double unit = 1 / (data.scale * data.scale);
    const KnownNoise Sigma = options.Sigma ? KnownNoise(unit * *options.Sigma) : std::nullopt;
    if (options.method == SOLVEPNP_GMLPNP)
        return estimatePublished(data, start, Sigma, options.Gamma, options.stopping, parts);
    return estimateMarginal(data, start, Sigma, options.Gamma, options.stopping, parts);
}

// A guess is never made worse: the cost does not end above its own at the noise that was found.
void keepGuessIfBetter(const Correspondences& data, const Pose& guess, Estimate& found)
{
    const RaySums sums = rayPass(data, guess, found.noise);
    if (sums.L < found.sums.L) {
        found.pose = guess;
        found.sums = sums;
    }
}

bool sound(const Estimate& estimate, int n)
{
    return std::isfinite(estimate.sums.L) && estimate.pose.t.allFinite() && estimate.spread.allFinite() &&
           determined(estimate.sums.H) && 2 * estimate.sums.inFront > n;
}

// Weights of the tails, from squared residuals.
std::vector<double> weights(std::vector<double> c, const Tails& tails)
{
    for (double& entry : c)
        entry = tailTerms(tails, entry).w;
    return c;
}

// What solve() returns beside the pose: the noise for its own sake, the uncertainties, the weights.
void addExtras(const Correspondences& data, const Estimate& found, const Options& options, Solution& solution)
{
    const int n = data.size();
    const double area = data.scale * data.scale;
    const bool published = found.kind == NoiseKind::PUBLISHED || options.method == SOLVEPNP_GMLPNP;
    NoiseEstimate estimate =
        estimatedNoise(data, found, options.Sigma.has_value() || published, options.Gamma.has_value() || published);
    if (published)  // it collapses: what rounding has left of the least variance may be negative
        estimate.noise.Sigma = floored(estimate.noise.Sigma, TINY_FLOOR);
    std::vector<double> c(n);
    const auto costAt = [&](const Noise& noise) {
        return rayPass(data, found.pose, noise, {LeverArm::CORRECTED, NO_PRODUCTS, c.data()}).L;
    };
    double L = costAt(estimate.noise);
    // At the noise that is returned, too, a guess is not made worse.
    if (options.guess && !published && rayPass(data, data.fromObject(*options.guess), estimate.noise).L < L) {
        estimate.noise = found.noise;
        L = costAt(estimate.noise);
    }
    solution.cost += L - found.sums.L - data.logAngularScales();
    solution.noise.Sigma = area * estimate.noise.Sigma;
    solution.noise.Gamma = estimate.noise.Gamma;
    if (!options.Sigma && !published)
        solution.objectError = area * estimate.objectError;
    if (!options.Gamma && !published)
        solution.bearingError = estimate.bearingError;
    solution.weights = weights(std::move(c), estimate.noise.tails);
    if (n > 3 || (options.Sigma && options.Gamma))
        solution.covariance =
            rescaled(poseCovariance(found, effectiveNumber(solution.weights), observedDirections(data)), data.scale);
}

Solution toCaller(const Correspondences& data, const Estimate& found, const Options& options)
{
    const double area = data.scale * data.scale;
    Solution solution{data.toObject(found.pose),
                      {area * found.noise.Sigma, found.noise.Gamma, found.noise.tails},
                      found.kind,
                      found.evidence,
                      found.poseEvidence,
                      found.rounds,
                      found.converged,
                      found.sums.L + 2 * data.size() * std::log(data.scale),
                      std::nullopt,
                      {},
                      std::nullopt,
                      std::nullopt};
    if (options.extras)
        addExtras(data, found, options, solution);
    // Known noise goes back as it came; the solver's is floored.
    solution.noise.Sigma = options.Sigma.value_or(solution.noise.Sigma);
    solution.noise.Gamma = options.Gamma.value_or(solution.noise.Gamma);
    return solution;
}

// Two poses are one when their difference is far below what any data can tell [rad, and share of the distance].
constexpr double SAME_POSE = 1e-5;

bool samePose(const Pose& a, const Pose& b)
{
    return (a.R - b.R).norm() < SAME_POSE && (a.t - b.t).norm() < SAME_POSE * b.t.norm();
}

// The distinct poses that make sense, best first; one where the best minimum has been chosen.
std::vector<Estimate> fit(const Correspondences& data, const Options& options, const Parts& parts)
{
    const Correspondences& first = parts.empty() ? data : parts.front();
    const std::vector<PoseCandidate> starts = startingPoses(first, options);
    const bool chosen = chosenAsMinimum(first, options);
    Options fitting = options;
    // The last sums are needed to compare with other poses and for all that is said about this one.
    const bool needed = options.extras || options.guess || (starts.size() > 1 && !chosen);
    fitting.stopping.last = needed ? LastSums::AT_POSE : LastSums::NOTHING;
    fitting.stopping.sampled = !options.extras;
    std::vector<Estimate> found;
    for (size_t k = 0; k < starts.size() && !(chosen && !found.empty()); ++k) {
        Estimate candidate = estimate(data, starts[k].pose, fitting, parts);
        candidate.poseEvidence = lead(starts, k, [](const PoseCandidate& start) { return start.cost; });
        if (options.guess)
            keepGuessIfBetter(data, data.fromObject(*options.guess), candidate);
        const auto known = [&](const Estimate& other) { return samePose(other.pose, candidate.pose); };
        if (sound(candidate, data.size()) && std::none_of(found.begin(), found.end(), known))
            found.push_back(candidate);
    }
    std::sort(found.begin(), found.end(), [](const Estimate& a, const Estimate& b) { return a.sums.L < b.sums.L; });
    // With known noise the likelihoods of the poses themselves decide.
    if (!found.empty() && found.front().kind == NoiseKind::FIXED)
        for (size_t k = 0; k < found.size(); ++k)
            found[k].poseEvidence = lead(found, k, [](const Estimate& each) { return each.sums.L; });
    return found;
}

// Where only the pose is asked for: of MANY points, PART of them for all but the last passes, and as many passes over
// parts of up to GROWTH times as many each. What a part leaves of the noise's error is squared by each. The errors are
// those of all points for everything, within 1 % (doc/performance.md).
constexpr int PART = 300, MANY = 600, GROWTH = 8;

Parts partsOf(const Correspondences& data, Method method)
{
    Parts parts;
    if (method == SOLVEPNP_GMLPNP_MARGINAL)  // the noise of the other stays that of the first part
        for (int size = data.size() / GROWTH; size > PART; size /= GROWTH)
            parts.push_back(data.part(size));
    parts.push_back(data.part(PART));
    std::reverse(parts.begin(), parts.end());
    return parts;
}

std::vector<Estimate> fitByParts(const Correspondences& data, const Options& options)
{
    const bool fits = !options.extras && !options.everyMinimum && !options.Sigma && !options.Gamma;
    if (!fits || data.size() < MANY)
        return {};
    const Parts parts = partsOf(data, options.method);
    return parts.front().degenerate() ? std::vector<Estimate>() : fit(data, options, parts);
}

}  // namespace

Status solveAll(const Observations& observations, const Options& options, std::vector<Solution>& solutions)
{
    const int fewest = options.guess ? 3 : 4;
    if (observations.points.rows < fewest)
        return STATUS_TOO_FEW_POINTS;
    const Correspondences data(observations.points, observations.rays, observations.objectCovariances,
                               observations.rayCovariances, observations.scaled);
    if (!data.finite())
        return STATUS_NOT_FINITE;
    if (data.degenerate())
        return STATUS_DEGENERATE;
    if (!data.hasPlaces(fewest))
        return STATUS_TOO_FEW_POINTS;

    std::vector<Estimate> found = fitByParts(data, options);
    if (found.empty())
        found = fit(data, options, {});
    if (found.empty())
        return STATUS_DEGENERATE;
    if (!options.everyMinimum)
        found.resize(1);
    solutions.clear();
    for (const Estimate& each : found)
        solutions.push_back(toCaller(data, each, options));
    // The noise that is returned may judge near equals otherwise than the one that weighed them.
    std::sort(solutions.begin(), solutions.end(), [](const Solution& a, const Solution& b) { return a.cost < b.cost; });
    return solutions.front().converged ? STATUS_CONVERGED : STATUS_MAX_ROUNDS;
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
