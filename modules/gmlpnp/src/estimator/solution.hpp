// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_ESTIMATOR_SOLUTION_HPP
#define OPENCV_GMLPNP_ESTIMATOR_SOLUTION_HPP

#include "options.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

/** What is returned about a pose, in the object frame and the caller's units. */
struct Solution
{
    Pose pose;
    Noise noise;
    NoiseKind kind = NoiseKind::FIXED;
    double evidence = 0, poseEvidence = 0;  //!< nat
    int rounds = 0;
    bool converged = false;
    double cost = 0;                                    //!< L [nat]
    std::optional<Matrix6d> covariance;                 //!< of xi; none without degrees of freedom to judge it by
    std::vector<double> weights;                        //!< of the points, by the tails
    std::optional<Matrix3d> objectError, bearingError;  //!< standard errors of the entries of an estimated noise
};

/** The estimate in the caller's units and, where Options::report asks for it, the noise for its own sake, the
covariance of the pose and the weights. */
Solution reported(const Correspondences& data, const Estimate& estimate, const Options& options);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_ESTIMATOR_SOLUTION_HPP
