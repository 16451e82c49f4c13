// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_API_OPTIONS_HPP
#define OPENCV_GMLPNP_API_OPTIONS_HPP

#include "../estimator/options.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

// Params of a call as the solver takes them.

/** Checked options; StsBadArg, with the name of the field, for a value out of its range. */
Options optionsFrom(const Params& params);

/** Whether the guess, if there is one, consists of numbers of a size that a pose can have. */
bool finiteGuess(const Params& params);

/** Params of a call with one of our flags; StsBadArg for every other flag. */
Params paramsOf(int flags, bool useExtrinsicGuess, InputArray rvec, InputArray tvec);

/** Whether all numbers of a matrix, if it has any, are zero. */
bool isZero(const Mat& m);

/** Whether a matrix is symmetric positive semidefinite, and of a size that leaves the covariance of the pose in the
range of doubles. */
bool isCovariance(const Matrix3d& given);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_API_OPTIONS_HPP
