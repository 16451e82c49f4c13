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
    std::vector<Pose> poses;
    for (const PoseCandidate& candidate : initialPoses(data))
        poses.push_back(candidate.pose);
    return poses;
}

Estimate estimate(const Correspondences& data, const Pose& start, const Options& options)
{
    const double unit = 1 / (data.scale * data.scale);
    const std::optional<Matrix3d> Sigma = options.Sigma ? std::optional<Matrix3d>(unit * *options.Sigma) : std::nullopt;
    if (options.method == SOLVEPNP_GMLPNP)
        return estimatePublished(data, start, Sigma, options.Gamma, options.stopping);
    return estimateMarginal(data, start, Sigma, options.Gamma, options.stopping);
}

bool sound(const Estimate& estimate, int n)
{
    return std::isfinite(estimate.sums.L) && estimate.pose.t.allFinite() && determined(estimate.sums.H) &&
           2 * estimate.sums.inFront > n;
}

Solution toCaller(const Correspondences& data, const Estimate& found, bool noiseKnown)
{
    const int n = data.size();
    const double area = data.scale * data.scale;
    Solution solution{data.toObject(found.pose),
                      {area * found.noise.Sigma, found.noise.Gamma},
                      found.rounds,
                      found.sums.L + 2 * n * std::log(data.scale),
                      std::nullopt};
    if (noiseKnown || n > 3)
        solution.covariance = rescaled(poseCovariance(found, n), data.scale);
    return solution;
}

}  // namespace

Status solveRays(const Mat_<double>& objectPoints, const Mat_<double>& rays, const Options& options, Solution& solution)
{
    if (objectPoints.rows < (options.guess ? 3 : 4))
        return STATUS_TOO_FEW_POINTS;
    if (!finite(objectPoints, rays))
        return STATUS_NOT_FINITE;
    const Correspondences data(objectPoints, rays);
    if (data.degenerate())
        return STATUS_DEGENERATE;

    std::optional<Estimate> best;
    for (const Pose& start : startingPoses(data, options)) {
        const Estimate found = estimate(data, start, options);
        if (sound(found, data.size()) && (!best || found.sums.L < best->sums.L))
            best = found;
    }
    if (!best)
        return STATUS_DEGENERATE;
    solution = toCaller(data, *best, options.Sigma && options.Gamma);
    return best->converged ? STATUS_CONVERGED : STATUS_MAX_ROUNDS;
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
