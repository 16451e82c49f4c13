// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_RELIABILITY_SEARCH_HPP
#define GMLPNP_RELIABILITY_SEARCH_HPP

#include "problem.hpp"

namespace reliability {

/** Whether a result can be compared with that of a search: n >= 6, no guess, no wrong correspondences (also none behind
the camera), no corrupt number, and noise well above the rounding of a pose: below it L is that of rounding. */
bool searchable(const Problem& problem);

/** By how much [nat] the best minimum of isotropic noise that is found from `starts` random rotations is better than
the one that `pose` belongs to. A minimum is rated by L with the noise that is fitted to it, of the kind that has the
least with what is asked of each kind (penaltyOf, priorCost); only minima with most points in front count, and
poses from which a descent comes to an end. Each start has the translation that goes with its rotation. */
double aboveSearch(const Problem& problem, const Pose& pose, int starts);

}  // namespace reliability

#endif  // GMLPNP_RELIABILITY_SEARCH_HPP
