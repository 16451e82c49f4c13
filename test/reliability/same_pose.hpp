// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_RELIABILITY_SAME_POSE_HPP
#define GMLPNP_RELIABILITY_SAME_POSE_HPP

#include "solvers.hpp"

namespace reliability {

/** How far two poses are apart: the larger of the angle [rad] and the way of the object's centre, as a share of its
distance. */
double apart(const Vector3d& centre, const Pose& a, const Pose& b);

/** Whether rounding is small in the pose that the solver finds: the problem is solvable and at the origin, where `tvec`
has all its digits. The published covariance collapses, which is why its conditions are narrower. */
bool roundingIsSmall(const Solver& solver, const Problem& problem);

/** How far it may move that pose: 1e-9, and where the data hardly determine the pose 1e-4 of what they leave open, 1e-3
from a condition of 1e5 on. */
double roundingBound(const Problem& problem);

/** The points in another order. */
Problem shuffled(Problem problem, cv::RNG& rng);

}  // namespace reliability

#endif  // GMLPNP_RELIABILITY_SAME_POSE_HPP
