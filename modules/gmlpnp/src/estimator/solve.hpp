// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_ESTIMATOR_SOLVE_HPP
#define OPENCV_GMLPNP_ESTIMATOR_SOLVE_HPP

#include "pose_covariance.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

/** What was observed, checked: N x 3 points and rays; known covariances N x 9 or empty. */
struct Observations
{
    Mat_<double> points, rays, objectCovariances, rayCovariances;
    bool scaled = false;  //!< whether rays are as long as their angular scales; else their length means nothing
};

/** Checked options, object frame and caller's units. */
struct Options
{
    Method method = SOLVEPNP_GMLPNP_MARGINAL;
    Stopping stopping{};
    std::optional<Pose> guess;
    KnownNoise Sigma, Gamma;
    bool everyMinimum = false;  //!< also those that noise cannot have swapped with the best
    bool extras = true;         //!< covariance, noise for its own sake, weights
};

/** What a solve found, object frame and caller's units. */
struct Solution
{
    Pose pose;
    Noise noise;
    NoiseKind kind;
    double evidence, poseEvidence;
    int rounds;
    bool converged;
    double cost;
    std::optional<Matrix6d> covariance;                 // of xi; none without degrees of freedom to judge it by
    std::vector<double> weights;                        // of the tails
    std::optional<Matrix3d> objectError, bearingError;  // standard errors of the entries of an estimated noise
};

/** Whether a status comes with a pose. */
inline bool isSuccess(int status)
{
    return status == STATUS_CONVERGED || status == STATUS_MAX_ROUNDS;
}

/** The distinct poses, best first, with their noise; with a status that is not a success `solutions` is untouched. */
CV_EXPORTS Status solveAll(const Observations& observations, const Options& options, std::vector<Solution>& solutions);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_ESTIMATOR_SOLVE_HPP
