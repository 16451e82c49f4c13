// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_ARRAYS_INPUTS_HPP
#define OPENCV_GMLPNP_ARRAYS_INPUTS_HPP

#include "../precomp.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

/** N points of `dim` coordinates in any of OpenCV's layouts (NxD, Nx1xD, 1xNxD, vector, UMat, not continuous) as a
continuous N x dim matrix of doubles; it may share memory with the input, so it is const. Anything else: StsAssert
with `name` in the message. */
CV_EXPORTS const Mat_<double> pointsFrom(InputArray points, int dim, const char* name);

/** A rows x cols matrix of any numeric depth as doubles; anything else: StsAssert with `name` in the message. */
CV_EXPORTS const Mat_<double> matrixFrom(InputArray matrix, int rows, int cols, const char* name);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_ARRAYS_INPUTS_HPP
