// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_ESTIMATOR_NOISE_ESTIMATE_HPP
#define OPENCV_GMLPNP_ESTIMATOR_NOISE_ESTIMATE_HPP

#include "estimate.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

using Vector12d = Eigen::Matrix<double, 12, 1>;
using Matrix12d = Eigen::Matrix<double, 12, 12>;

/** The noise for its own sake, in the solver's units. For the pose it only has to weigh the points. */
struct NoiseEstimate
{
    Noise noise;
    /** Standard errors of the entries of Sigma (object frame) and of Gamma. Both are taken for unknown unless they were
    given. The errors are orders of magnitude above the entries where the data do not tell, and zero for a given
    noise. */
    Matrix3d objectError, bearingError;
};

/** Expected curvature of L by the entries xx xy xz yy yz zz of R Sigma R^T and then of Gamma, camera frame. */
CV_EXPORTS Matrix12d noiseInformation(const Correspondences& data, const Pose& pose, const Noise& noise);

/** The noises that were not given, by a few damped steps of Fisher scoring for both at once at the pose that was found.
So they are free from the pull towards isotropy and from the early end, which help the pose and bias the noise. Both are
estimated even where one of them weighed the pose, unless the depths are too much alike to tell them apart
(doc/theory.md, section 6).
@param givenObject, givenBearing whether that noise was known. */
CV_EXPORTS NoiseEstimate estimatedNoise(const Correspondences& data, const Estimate& found, bool givenObject,
                                        bool givenBearing);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_ESTIMATOR_NOISE_ESTIMATE_HPP
