// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "precomp.hpp"

#include "initial_pose.hpp"
#include "solve.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

namespace {

std::vector<Pose> startingPoses(const Correspondences& data, const Options& options)
{
    if (options.guess)
        return {isotropicPose(data, data.fromObject(*options.guess))};
    const double all = std::numeric_limits<double>::infinity();
    std::vector<Pose> poses;
    for (const PoseCandidate& candidate : initialPoses(data, options.everyMinimum ? all : INITIAL_COST_RATIO))
        poses.push_back(candidate.pose);
    return poses;
}

Estimate estimate(const Correspondences& data, const Pose& start, const Options& options, const Correspondences* part)
{
    const double unit = 1 / (data.scale * data.scale);
    const KnownNoise Sigma = options.Sigma ? KnownNoise(unit * *options.Sigma) : std::nullopt;
    if (options.method == SOLVEPNP_GMLPNP)
        return estimatePublished(data, start, Sigma, options.Gamma, options.stopping, part);
    return estimateMarginal(data, start, Sigma, options.Gamma, options.stopping, part);
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
    return std::isfinite(estimate.sums.L) && estimate.pose.t.allFinite() && determined(estimate.sums.H) &&
           2 * estimate.sums.inFront > n;
}

std::vector<double> weights(const Correspondences& data, const Estimate& found)
{
    const double tail = found.noise.tail;
    std::vector<double> out(data.size(), 1.);
    if (tail == 0)
        return out;
    rayPass(data, found.pose, found.noise, {LeverArm::CORRECTED, NO_PRODUCTS, out.data()});
    for (double& c : out)
        c = (1 + 2 * tail) / (1 + tail * c);
    return out;
}

Solution toCaller(const Correspondences& data, const Estimate& found, const Options& options)
{
    const int n = data.size();
    const double area = data.scale * data.scale;
    Solution solution{data.toObject(found.pose),
                      {area * found.noise.Sigma, found.noise.Gamma, found.noise.tail},
                      found.kind,
                      found.evidence,
                      found.rounds,
                      found.converged,
                      found.sums.L + 2 * n * std::log(data.scale),
                      std::nullopt,
                      {}};
    // Known noise goes back as it came; the solver's is floored.
    solution.noise.Sigma = options.Sigma.value_or(solution.noise.Sigma);
    solution.noise.Gamma = options.Gamma.value_or(solution.noise.Gamma);
    if (!options.extras)
        return solution;
    if (n > 3 || (options.Sigma && options.Gamma))
        solution.covariance = rescaled(poseCovariance(found, n), data.scale);
    solution.weights = weights(data, found);
    return solution;
}

// Two poses are one when their difference is far below what any data can tell [rad, and share of the distance].
constexpr double SAME_POSE = 1e-5;

bool samePose(const Pose& a, const Pose& b)
{
    return (a.R - b.R).norm() < SAME_POSE && (a.t - b.t).norm() < SAME_POSE * b.t.norm();
}

// The distinct poses that make sense, best first.
std::vector<Estimate> fit(const Correspondences& data, const Options& options, const Correspondences* part)
{
    const std::vector<Pose> starts = startingPoses(part ? *part : data, options);
    Options fitting = options;
    // The last sums are needed to compare with other poses and for all that is said about this one.
    fitting.stopping.evaluate = options.extras || options.guess || starts.size() > 1;
    std::vector<Estimate> found;
    for (const Pose& start : starts) {
        Estimate candidate = estimate(data, start, fitting, part);
        if (options.guess)
            keepGuessIfBetter(data, data.fromObject(*options.guess), candidate);
        const auto known = [&](const Estimate& other) { return samePose(other.pose, candidate.pose); };
        if (sound(candidate, data.size()) && std::none_of(found.begin(), found.end(), known))
            found.push_back(candidate);
    }
    std::sort(found.begin(), found.end(), [](const Estimate& a, const Estimate& b) { return a.sums.L < b.sums.L; });
    return found;
}

// Where only the pose is asked for: of MANY points, PART of them for all but the last passes. The errors are those of
// all points for everything, within .5 % (doc/performance.md).
constexpr int PART = 300, MANY = 600;

std::vector<Estimate> fitByPart(const Correspondences& data, const Options& options)
{
    const bool fits = !options.extras && !options.everyMinimum && !options.Sigma && !options.Gamma;
    if (!fits || data.size() < MANY)
        return {};
    const Correspondences part = data.part(PART);
    return part.degenerate() ? std::vector<Estimate>() : fit(data, options, &part);
}

}  // namespace

Status solveAll(const Observations& observations, const Options& options, std::vector<Solution>& solutions)
{
    if (observations.points.rows < (options.guess ? 3 : 4))
        return STATUS_TOO_FEW_POINTS;
    const Correspondences data(observations.points, observations.rays, observations.objectCovariances,
                               observations.rayCovariances);
    if (!data.finite())
        return STATUS_NOT_FINITE;
    if (data.degenerate())
        return STATUS_DEGENERATE;

    std::vector<Estimate> found = fitByPart(data, options);
    if (found.empty())
        found = fit(data, options, nullptr);
    if (found.empty())
        return STATUS_DEGENERATE;
    if (!options.everyMinimum)
        found.resize(1);
    solutions.clear();
    for (const Estimate& each : found)
        solutions.push_back(toCaller(data, each, options));
    return found.front().converged ? STATUS_CONVERGED : STATUS_MAX_ROUNDS;
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
