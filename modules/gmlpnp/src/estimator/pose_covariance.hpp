// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_ESTIMATOR_POSE_COVARIANCE_HPP
#define OPENCV_GMLPNP_ESTIMATOR_POSE_COVARIANCE_HPP

#include "estimate.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

/** Whether the points determine the pose: H is positive definite beyond rounding. */
CV_EXPORTS bool determined(const Matrix6d& H);

/** Covariance of xi = (phi, delta) at an estimate, in the solver's units (doc/theory.md, section 5): H^-1 plus the
spread between kinds of noise. Where the noise was estimated from the same residuals, H^-1 is enlarged so that the 95 %
ellipsoid holds the truth in 95 % of cases.
@param n points; with tails the effectiveNumber() of them.
@param directions the observedDirections() of the points. */
CV_EXPORTS Matrix6d poseCovariance(const Estimate& estimate, double n, double directions);

/** The number of points of equal weight that tell as much about their mean: (sum w)^2 / sum w^2. */
double effectiveNumber(const std::vector<double>& weights);

/** The number of directions in which the rays see object noise: 2 across a narrow view, 3 from all around. */
double observedDirections(const Correspondences& data);

/** From the solver's units to the caller's: delta = scale delta'. */
CV_EXPORTS Matrix6d rescaled(const Matrix6d& covariance, double scale);

/** Covariance of (rvec, tvec) from that of xi. */
CV_EXPORTS Matrix6d toRvecTvec(const Matrix6d& covariance, const Pose& pose);

/** Covariance of the camera centre -R^T t, object frame, from that of xi. */
CV_EXPORTS Matrix3d toCameraCenter(const Matrix6d& covariance, const Pose& pose);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_ESTIMATOR_POSE_COVARIANCE_HPP
