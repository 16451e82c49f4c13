// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_ESTIMATOR_ALTERNATION_HPP
#define OPENCV_GMLPNP_ESTIMATOR_ALTERNATION_HPP

#include "../noise/model.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

/** What the sums that come out are good for. Each saves a pass over the one before it, where the last step is small. */
enum class LastSums
{
    AT_POSE,  //!< everything: they are those at the pose that comes out
    COMPARE,  //!< comparing L: it is off by less than DEFAULT_TOLERANCE
    NOTHING   //!< knowing that the pose is determined
};

/** When the alternation ends. */
struct Stopping
{
    int maxRounds;
    double tolerance;     //!< change of L [nat]; published: relative change of Sigma (Frobenius). 0: never
    bool robust = false;  //!< whether the tails are estimated too
    LastSums last = LastSums::AT_POSE;
    bool sampled = false;     //!< scoring by a quarter of the points: the estimate then depends a little on their order
    bool otherKnown = false;  //!< the noise that is not estimated is known, not absent
    bool near = false;  //!< the start is near the end: scoring at once, by the products of the first pass; no last pass
    Tails tails{};      //!< at the start; they stay where they are not estimated
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
    RaySums sums;  //!< at pose and noise, or just before (Stopping::last)
    int rounds = 0;
    bool converged = false;
    double evidence = std::numeric_limits<double>::infinity();  //!< by how much the kind of noise beats the next, nat
    double poseEvidence = std::numeric_limits<double>::infinity();  //!< by how much the minimum beats the others, nat
    Matrix6d spread = Matrix6d::Zero();                             //!< covariance of xi between the kinds of noise
};

/** The alternation: one Gauss-Newton step for the pose and one update of the noise from the sums of one pass. */
CV_EXPORTS Estimate alternate(const Correspondences& data, const Pose& start, const Noise& noise, NoiseKind kind,
                              const Stopping& stopping);

/** The pose of least  sum |v_i|^2  near `start`. */
CV_EXPORTS Pose isotropicPose(const Correspondences& data, const Pose& start);

/** The estimate over more points from what `size` of them gave, in two or three passes: so near the end scoring squares
what is left of the noise's error. Where that does not settle it, or the pose moves further than chance can explain,
the alternation goes on. */
Estimate overAll(const Correspondences& data, const Estimate& ofPart, int size, const Stopping& stopping);

/** A rise of L that a step may cost where the noise is estimated [nat]; more for many points (accepted()). */
constexpr double RISE = 3;

/** Whether a step has not gone wrong. */
bool accepted(bool noiseChanged, const RaySums& before, const RaySums& after, int n);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_ESTIMATOR_ALTERNATION_HPP
