// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_ESTIMATOR_ESTIMATE_HPP
#define OPENCV_GMLPNP_ESTIMATOR_ESTIMATE_HPP

#include "../noise/kinds.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

/** A pose with the noise that weighed the points, in the solver's units. */
struct Estimate
{
    Pose pose;
    Noise noise;
    NoiseKind kind = NoiseKind::FIXED;
    RaySums sums;  //!< at pose and noise, as accurate as was asked for (SumsNeeded)
    int rounds = 0;
    bool converged = false;
    //! By how much the kind of noise is likelier than the next [nat].
    double evidence = std::numeric_limits<double>::infinity();
    //! By how much the minimum is likelier than the best other one [nat].
    double poseEvidence = std::numeric_limits<double>::infinity();
    //! Covariance of xi between the kinds of noise.
    Matrix6d spread = Matrix6d::Zero();
};

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_ESTIMATOR_ESTIMATE_HPP
