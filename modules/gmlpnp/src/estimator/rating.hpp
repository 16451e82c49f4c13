// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_ESTIMATOR_RATING_HPP
#define OPENCV_GMLPNP_ESTIMATOR_RATING_HPP

#include "../noise/model.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

/** What speaks against a minimum of the isotropic cost [nat]: the least L with object noise or with bearing noise, each
fitted to the residuals there, and the prior against that kind. The pose is held: on its way an alternation moves it,
and L where it stops depends on its start by as much as two minima differ by. Both noises at once are left out; what
they gain and what is asked of them for it change no order. Infinite where there is no L.
@param robust whether the noise has tails. */
CV_EXPORTS double costOfMinimum(const Correspondences& data, const Pose& minimum, bool robust);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_ESTIMATOR_RATING_HPP
