// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_ESTIMATOR_SOLVE_HPP
#define OPENCV_GMLPNP_ESTIMATOR_SOLVE_HPP

#include "../rays/observations.hpp"
#include "solution.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

/** Whether a status comes with a pose. */
inline bool isSuccess(int status)
{
    return status == STATUS_CONVERGED || status == STATUS_MAX_ROUNDS;
}

/** STATUS_CONVERGED where a pose may follow, or why none can.
@param fewest places that the points must be at. */
Status check(const Correspondences& data, int fewest);

/** The pose to which the method leads from a start, in the units of `data`; none where it leads to no pose. */
std::optional<Estimate> fitNear(const Correspondences& data, const Pose& start, const Options& options);

/** The poses that the observations give, best first, each with its noise; the best alone unless Options::everyMinimum.
@param solutions untouched where the status is no success. */
CV_EXPORTS Status solveMinima(const Observations& observations, const Options& options,
                              std::vector<Solution>& solutions);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_ESTIMATOR_SOLVE_HPP
