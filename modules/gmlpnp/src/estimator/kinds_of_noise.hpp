// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_ESTIMATOR_KINDS_OF_NOISE_HPP
#define OPENCV_GMLPNP_ESTIMATOR_KINDS_OF_NOISE_HPP

#include "subsets.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

// Which noise: the second of the three questions of solve.cpp.

/** Fewer points leave too few degrees of freedom for a covariance; their noise is isotropic. */
constexpr int MIN_POINTS_COVARIANCE = 6;

/** Algorithm 1 of the paper from a pose of isotropic noise. With a known Sigma it is its Proposition 1 (GMLPnP*). Gamma
is zero unless it is given. */
CV_EXPORTS Estimate fitPublished(const Subsets& data, const Pose& start, const KnownNoise& Sigma,
                                 const KnownNoise& Gamma, const FitOptions& options);

/** The marginal likelihood over pose, Sigma and Gamma, from a pose of isotropic noise. Object noise, bearing noise and
both are fitted. The noise is that of the likeliest kind, the pose the mean over all three by their evidence.
@param tails of the first round; they stay where FitOptions::tails does not estimate them. */
CV_EXPORTS Estimate fitMarginal(const Subsets& data, const Pose& start, const KnownNoise& Sigma,
                                const KnownNoise& Gamma, const FitOptions& options, const Tails& tails = {});

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_ESTIMATOR_KINDS_OF_NOISE_HPP
