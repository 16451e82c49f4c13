// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "../noise/model.hpp"
#include "noise_estimate.hpp"
#include "pose_covariance.hpp"
#include "solution.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

namespace {

// Weights by the tails, from squared residuals.
std::vector<double> weightsOf(std::vector<double> c, const Tails& tails)
{
    for (double& entry : c)
        entry = tailTerms(tails, entry).w;
    return c;
}

// The noise for its own sake, in the solver's units.
NoiseEstimate noiseToReport(const Correspondences& data, const Estimate& found, const Options& options)
{
    if (options.marginal())
        return estimatedNoise(data, found, options.Sigma.has_value(), options.Gamma.has_value());
    NoiseEstimate published = estimatedNoise(data, found, true, true);
    // Its covariance collapses: the least variance that rounding has left may be negative.
    published.noise.Sigma = floored(published.noise.Sigma, TINY_FLOOR);
    return published;
}

void addReport(const Correspondences& data, const Estimate& found, const Options& options, Solution& solution)
{
    const int n = data.size();
    const double area = data.scale * data.scale;
    NoiseEstimate estimate = noiseToReport(data, found, options);
    std::vector<double> c(n);
    const auto costAt = [&](const Noise& noise) {
        return rayPass(data, found.pose, noise, {LeverArm::CORRECTED, NO_PRODUCTS, c.data()}).L;
    };
    double L = costAt(estimate.noise);
    // A guess is not made worse at the noise that is returned, either.
    if (options.guess && options.marginal() && rayPass(data, data.fromObject(*options.guess), estimate.noise).L < L) {
        estimate.noise = found.noise;
        L = costAt(estimate.noise);
    }
    solution.cost += L - found.sums.L - data.logAngularScales();
    solution.noise.Sigma = area * estimate.noise.Sigma;
    solution.noise.Gamma = estimate.noise.Gamma;
    if (!options.Sigma && options.marginal())
        solution.objectError = area * estimate.objectError;
    if (!options.Gamma && options.marginal())
        solution.bearingError = estimate.bearingError;
    solution.weights = weightsOf(std::move(c), estimate.noise.tails);
    if (n > 3 || (options.Sigma && options.Gamma))
        solution.covariance =
            rescaled(poseCovariance(found, effectiveNumber(solution.weights), observedDirections(data)), data.scale);
}

}  // namespace

Solution reported(const Correspondences& data, const Estimate& found, const Options& options)
{
    Solution solution;
    solution.pose = data.toObject(found.pose);
    solution.noise = {data.scale * data.scale * found.noise.Sigma, found.noise.Gamma, found.noise.tails};
    solution.kind = found.kind;
    solution.evidence = found.evidence;
    solution.poseEvidence = found.poseEvidence;
    solution.rounds = found.rounds;
    solution.converged = found.converged;
    solution.cost = found.sums.L + 2 * data.size() * std::log(data.scale);
    if (options.report)
        addReport(data, found, options, solution);
    // A known noise goes back as it came. The fit has used one with its singular directions lifted.
    solution.noise.Sigma = options.Sigma.value_or(solution.noise.Sigma);
    solution.noise.Gamma = options.Gamma.value_or(solution.noise.Gamma);
    return solution;
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
