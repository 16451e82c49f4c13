// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_ESTIMATOR_RATING_HPP
#define OPENCV_GMLPNP_ESTIMATOR_RATING_HPP

#include "../rays/ray_pass.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

/** The cost [nat] of a minimum of the isotropic cost: the least L with object noise or with bearing noise, each fitted
to the residuals there, plus the prior cost of that kind. The pose is held, because an alternation moves it on its way,
and L where it stops depends on its start by as much as two minima differ by. Both noises at once are left out: their
gain and their penalty change no order. The cost is infinite where there is no L.
@param tails whether the noise has tails. */
CV_EXPORTS double costOfMinimum(const Correspondences& data, const Pose& minimum, bool tails);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_ESTIMATOR_RATING_HPP
