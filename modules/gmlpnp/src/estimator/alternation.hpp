// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_ESTIMATOR_ALTERNATION_HPP
#define OPENCV_GMLPNP_ESTIMATOR_ALTERNATION_HPP

#include "../noise/fit.hpp"
#include "estimate.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

/** Where the rounds of an alternation end. */
struct Limits
{
    int rounds;        //!< at most
    double tolerance;  //!< change of L [nat]; published: relative change of Sigma (Frobenius norm). 0: never
};

/** Change of L [nat] that no longer matters. A tenth of a nat moves the pose by a fraction of its deviation. */
constexpr double DEFAULT_TOLERANCE = 0.1;

/** The limits of a caller who sets none. The published algorithm needs its few rounds: its covariance only collapses
further. */
inline Limits defaultLimits(bool published)
{
    return published ? Limits{5, 1e-5} : Limits{20, DEFAULT_TOLERANCE};
}

/** How accurate the returned sums must be. A weaker demand can save the last pass, where the last step is small. */
enum class SumsNeeded
{
    EXACT,       //!< they are those at the returned pose and noise
    COMPARABLE,  //!< L is off by less than DEFAULT_TOLERANCE
    ROUGH,       //!< they still tell whether the pose is determined
    ANY          //!< no pass is made for them
};

/** How poses and noises are fitted. */
struct FitOptions
{
    Limits limits;
    bool tails = false;  //!< whether the tails are estimated, too
    SumsNeeded sums = SumsNeeded::EXACT;
    //! The step that is taken where scoring pays: from 200 points on, after one round of MM. SCORING_FROZEN is taken at
    //! once, whatever the number of points.
    NoiseStep step = NoiseStep::SCORING;
};

/** The alternation from a start: in each round one Gauss-Newton step for the pose and one update of the noise, both
from the sums of one pass (Algorithm 1 of the paper; doc/theory.md, section 3). */
CV_EXPORTS Estimate alternate(const Correspondences& data, const Pose& start, const NoiseStart& noise,
                              const FitOptions& options);

/** The pose of least  sum |v_i|^2  near `start`. */
CV_EXPORTS Pose isotropicPose(const Correspondences& data, const Pose& start);

/** The Gauss-Newton step  xi = -H^-1 g. */
Vector6d gaussNewtonStep(const RaySums& sums);

/** A rise of L that a step may cost where the noise is estimated [nat]; more for many points (accepted()). */
constexpr double RISE = 3;

/** Whether a step has not gone wrong. With a fixed noise the cost must fall. With an estimated one L may rise a little,
because shrinkage and the corrected gradient do not follow it exactly. */
bool accepted(bool noiseChanged, const RaySums& before, const RaySums& after, int n);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_ESTIMATOR_ALTERNATION_HPP
