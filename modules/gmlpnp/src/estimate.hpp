// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_ESTIMATE_HPP
#define OPENCV_GMLPNP_ESTIMATE_HPP

#include "noise_model.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

/** When the alternation ends. */
struct Stopping
{
    int maxRounds;
    double tolerance;      //!< change of L [nat]; published: relative change of Sigma (Frobenius). 0: never
    bool robust = false;   //!< whether the tails are estimated too
    bool evaluate = true;  //!< sums at the pose that comes out; false: they may be those one small step before
    double tail = 0;       //!< 1/nu at the start; it stays where the tails are not estimated
};

/** Change of L [nat] that no longer matters: a tenth of a nat moves the pose by a fraction of its standard deviation.
 */
constexpr double DEFAULT_TOLERANCE = 0.1;

/** The published algorithm needs its few rounds: its covariance only collapses further. */
inline Stopping defaultStopping(bool published)
{
    return published ? Stopping{5, 1e-5, false} : Stopping{20, DEFAULT_TOLERANCE, false};
}

struct Estimate
{
    Pose pose;
    Noise noise;
    NoiseKind kind = NoiseKind::FIXED;
    RaySums sums;  //!< at pose and noise, or just before (Stopping::evaluate)
    int rounds = 0;
    bool converged = false;
    double evidence = std::numeric_limits<double>::infinity();  //!< by how much the kind of noise beats the next, nat
    Matrix6d spread = Matrix6d::Zero();                         //!< covariance of xi between the kinds of noise
};

/** The alternation: one Gauss-Newton step for the pose and one update of the noise from the sums of one pass. */
CV_EXPORTS Estimate alternate(const Correspondences& data, const Pose& start, const Noise& noise, NoiseKind kind,
                              const Stopping& stopping);

/** The pose of least  sum |v_i|^2  near `start`. */
CV_EXPORTS Pose isotropicPose(const Correspondences& data, const Pose& start);

/** A known noise in the solver's units; none: estimated. */
using KnownNoise = std::optional<Matrix3d>;

// Of many points a part finds the kind of noise and most of the way to its covariance and to the pose: with a `part`
// (Correspondences::part) the alternation runs on that, one or two passes over all points end it, and the sums are
// those before the last step unless Stopping::evaluate asks for others.

/** Algorithm 1 of the paper from a pose of isotropic noise. With a known Sigma its Proposition 1 (GMLPnP*). Gamma is
zero unless given. */
CV_EXPORTS Estimate estimatePublished(const Correspondences& data, const Pose& start, const KnownNoise& Sigma,
                                      const KnownNoise& Gamma, const Stopping& stopping,
                                      const Correspondences* part = nullptr);

/** Marginal likelihood over pose, Sigma and Gamma, from a pose of isotropic noise. Object noise, bearing noise and both
are fitted; the noise is that of the likeliest, the pose the mean over all three by their evidence. */
CV_EXPORTS Estimate estimateMarginal(const Correspondences& data, const Pose& start, const KnownNoise& Sigma,
                                     const KnownNoise& Gamma, const Stopping& stopping,
                                     const Correspondences* part = nullptr);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_ESTIMATE_HPP
