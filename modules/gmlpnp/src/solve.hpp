// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_SOLVE_HPP
#define OPENCV_GMLPNP_SOLVE_HPP

#include "pose_covariance.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

/** Checked options, object frame and caller's units. */
struct Options
{
    Method method = SOLVEPNP_GMLPNP_MARGINAL;
    Stopping stopping{};
    std::optional<Pose> guess;
    std::optional<Matrix3d> Sigma, Gamma;  // known noise
};

/** What a solve found, object frame and caller's units. */
struct Solution
{
    Pose pose;
    Noise noise;
    int rounds;
    double cost;
    std::optional<Matrix6d> covariance;  // of xi; none without degrees of freedom to judge it by
};

/** Pose and noise from N x 3 points and rays. On a status that is not a success `solution` is untouched. */
CV_EXPORTS Status solveRays(const Mat_<double>& objectPoints, const Mat_<double>& rays, const Options& options,
                            Solution& solution);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_SOLVE_HPP
