// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_RELIABILITY_SEARCH_HPP
#define GMLPNP_RELIABILITY_SEARCH_HPP

#include "problem.hpp"

namespace reliability {

/** Whether the cost of a result can be compared with that of a search: n >= 6, no guess, no wrong correspondences (also
none behind the camera), no corrupt number, and noise of at least 1e-9: below it L is that of rounding. */
bool searchable(const Problem& problem);

/** By how much [nat] the best that the marginal method comes to from `starts` random rotations is better than what it
comes to from `pose`, by the criterion it chooses by: L with the penalties of the kinds of noise. Each start has the
translation that goes with its rotation and is first descended to its isotropic minimum; only poses with most points in
front count. */
double aboveSearch(const Problem& problem, const cv::gmlpnp::detail::Pose& pose, int starts);

}  // namespace reliability

#endif  // GMLPNP_RELIABILITY_SEARCH_HPP
