// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_ARRAYS_INPUTS_HPP
#define OPENCV_GMLPNP_ARRAYS_INPUTS_HPP

#include "../precomp.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

/** Returns N points of `dim` coordinates as a continuous N x dim matrix of doubles. It takes any of OpenCV's layouts
(NxD, Nx1xD, 1xNxD, vector, UMat, not continuous), float or double. The matrix may share memory with the input, so it is
const.
@throws cv::Exception StsAssert, with `name` in the message, for anything else. */
CV_EXPORTS const Mat_<double> pointsFrom(InputArray points, int dim, const char* name);

/** Returns a rows x cols matrix of any numeric depth as doubles. It may share memory with the input too.
@throws cv::Exception StsAssert, with `name` in the message, for anything else. */
CV_EXPORTS const Mat_<double> matrixFrom(InputArray matrix, int rows, int cols, const char* name);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_ARRAYS_INPUTS_HPP
