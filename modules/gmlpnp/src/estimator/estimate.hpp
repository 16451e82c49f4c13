// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_ESTIMATOR_ESTIMATE_HPP
#define OPENCV_GMLPNP_ESTIMATOR_ESTIMATE_HPP

#include "alternation.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

/** A known noise in the solver's units; none: estimated. */
using KnownNoise = std::optional<Matrix3d>;

/** Fewer points leave too few degrees of freedom for a covariance: isotropic noise. */
constexpr int MIN_POINTS_COVARIANCE = 6;

/** Parts of many points (Correspondences::part), each larger than the one before it. They find the kind of noise and
most of the way to its covariance and to the pose: the alternation runs on the first, a few passes over each of the
others and over all points end it, and the sums are those of the last pass. None: the alternation runs on all. */
using Parts = std::vector<Correspondences>;

/** Algorithm 1 of the paper from a pose of isotropic noise. With a known Sigma its Proposition 1 (GMLPnP*). Gamma is
zero unless given. */
CV_EXPORTS Estimate estimatePublished(const Correspondences& data, const Pose& start, const KnownNoise& Sigma,
                                      const KnownNoise& Gamma, const Stopping& stopping, const Parts& parts = {});

/** What a kind of noise must be better than the others to be chosen [nat]: a noise more asks for evidence. */
CV_EXPORTS double evidenceAsked(NoiseKind kind);

/** What is held against a kind of noise where the data cannot tell [nat]. An object of little depth looks the same with
either noise, but not at the same distance: noise in its points makes it larger than its picture says, noise in the
picture smaller. No number of points tells; what is seen so is mostly known well (a marker, a model), and the pixels are
not. */
CV_EXPORTS double priorAgainst(NoiseKind kind, const IsotropicSplit& split);

/** Marginal likelihood over pose, Sigma and Gamma, from a pose of isotropic noise. Object noise, bearing noise and both
are fitted; the noise is that of the likeliest, the pose the mean over all three by their evidence. */
CV_EXPORTS Estimate estimateMarginal(const Correspondences& data, const Pose& start, const KnownNoise& Sigma,
                                     const KnownNoise& Gamma, const Stopping& stopping, const Parts& parts = {});

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_ESTIMATOR_ESTIMATE_HPP
