// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_ESTIMATOR_OPTIONS_HPP
#define OPENCV_GMLPNP_ESTIMATOR_OPTIONS_HPP

#include "alternation.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

/** Checked options of a solve, in the object frame and the caller's units. */
struct Options
{
    Method method = SOLVEPNP_GMLPNP_MARGINAL;
    Limits limits{};
    bool tails = false;  //!< whether the tails are estimated
    std::optional<Pose> guess;
    KnownNoise Sigma, Gamma;
    bool everyMinimum = false;  //!< return every local minimum, not only the best
    bool report = true;         //!< whether noise, covariances and weights are wanted beside the pose
    bool bySubsets = true;      //!< whether the pose of many points may be found by way of a few of them

    /** Whether the marginal likelihood judges poses and noises. Algorithm 1 as published has no likelihood to judge by:
    its noise collapses. */
    bool marginal() const { return method == SOLVEPNP_GMLPNP_MARGINAL; }
    /** The fewest points at distinct places. Three have up to four poses, of which a guess chooses one. */
    int fewestPoints() const { return guess ? 3 : 4; }
};

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_ESTIMATOR_OPTIONS_HPP
