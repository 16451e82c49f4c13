// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_DRAW_HPP
#define OPENCV_GMLPNP_DRAW_HPP

#include "opencv2/gmlpnp.hpp"

// Not included by opencv2/gmlpnp.hpp: it needs opencv_imgproc, the solver does not. Outside OpenCV's tree it is a
// library of its own, gmlpnp::draw.

namespace cv {
namespace gmlpnp {

//! @addtogroup gmlpnp
//! @{

/** @brief Draws the axes of the object frame, and where its origin and other points may lie in the picture.

The axes are those of cv::drawFrameAxes, x red, y green, z blue, for any lens: bent where the lens bends them. The
ellipses hold the image of a point with a probability of 95 %: the covariance of the pose, carried to the pixel to first
order. What the lens does not see is left out; without Result::poseCovariance there are no ellipses.

@param image picture, 8 bits, 1, 3 (blue, green, red) or 4 channels; drawn on, white on one channel; untouched
by a call that throws.
@param camera the lens of the picture.
@param result a pose with its covariance, of solve() and its kin.
@param length of the axes, the length unit of the object.
@param points further object points to draw ellipses around, in any layout of solve(); none: only the origin.
@param thickness of the axes, px; ellipses are half as thick.
@throws cv::Exception StsAssert or StsBadArg for misuse, naming the argument. */
CV_EXPORTS_W void drawPoseUncertainty(InputOutputArray image, const Ptr<CameraModel>& camera, const Result& result,
                                      double length, InputArray points = noArray(), int thickness = 3);

//! @}

}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_DRAW_HPP
