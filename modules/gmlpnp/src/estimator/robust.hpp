// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_ESTIMATOR_ROBUST_HPP
#define OPENCV_GMLPNP_ESTIMATOR_ROBUST_HPP

#include "../ransac/measure.hpp"
#include "../ransac/search.hpp"
#include "solve.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

/** A pose from correspondences of which some are wrong. Rows are those of the observations. */
struct RobustSolution
{
    Solution solution;
    std::vector<int> used;     //!< rows that it was solved from, ascending
    std::vector<int> inliers;  //!< rows within the threshold at its pose, ascending
};

/** The search for a consensus, the fit on its inliers, their recount, and the report.
@param measure of the residuals, a metric per row.
@param options of the fit; the search gets its guess by `ransac`.
@param out untouched where the status is no success. */
CV_EXPORTS Status solveRobust(const Observations& observations, const Measure& measure, const Options& options,
                              const RansacOptions& ransac, RobustSolution& out);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_ESTIMATOR_ROBUST_HPP
