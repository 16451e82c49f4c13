// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_EXPERIMENTS_SOLVERS_HPP
#define GMLPNP_EXPERIMENTS_SOLVERS_HPP

#include "problem.hpp"

namespace experiments {

/** A solver under comparison, by the name it has in the paper's Table I. */
struct Solver
{
    std::string name;
    bool anyLens;  //!< works on rays; the others need a perspective camera
    std::function<std::optional<Pose>(const Problem&)> solve;
};

/** All of them: OpenCV's, OpenGV's where the build found it, the baselines, and ours. EPnPU, DLSU, MLPnP, REPPnP and
GMLPnP* are given the true noise. */
const std::vector<Solver>& allSolvers();

/** Those that can solve the experiment's problems. */
std::vector<Solver> solversFor(bool perspective);

/** Options of the method with the true noise: GMLPnP* of the paper's Proposition 1. */
cv::gmlpnp::Params trueNoise(const Problem& problem);

/** cv::gmlpnp::solve() with everything it gives; none where there is no pose. */
std::optional<cv::gmlpnp::Result> solved(const Problem& problem, const cv::gmlpnp::Params& params);

using synthetic::poseOf;
Pose poseOf(const cv::gmlpnp::Result& result);
Matrix3d matrixOf(const cv::Mat& m);

}  // namespace experiments

#endif  // GMLPNP_EXPERIMENTS_SOLVERS_HPP
