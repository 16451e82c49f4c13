// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_DRAW_HPP
#define OPENCV_GMLPNP_DRAW_HPP

#include "opencv2/gmlpnp.hpp"

// opencv2/gmlpnp.hpp does not include this header, because drawing needs opencv_imgproc and the solver does not.
// Outside OpenCV's tree it is a library of its own, gmlpnp::draw.

namespace cv {
namespace gmlpnp {

//! @addtogroup gmlpnp
//! @{

/** @brief Draws the axes of the object frame, and ellipses in which its origin and other points lie in the picture.

The axes are those of cv::drawFrameAxes, x red, y green, z blue, for any lens, and bend where the lens bends them. An
ellipse holds the image of its point with a probability of 95 %. It shows the covariance of the pose, carried to the
pixel to first order. Points that the lens does not see are left out. Without Result::poseCovariance there are no
ellipses.

@param image picture, 8 bits, 1, 3 (blue, green, red) or 4 channels, which is drawn on, in white on one channel. A call
that throws leaves it untouched.
@param camera the lens of the picture.
@param result a pose with its covariance, of solve() and its kin.
@param length length of the axes, in the length unit of the object.
@param points further object points to draw ellipses around, in any layout of solve(); without them only the origin has
one.
@param thickness thickness of the axes, px; ellipses are half as thick.
@throws cv::Exception StsAssert or StsBadArg for misuse; the message names the argument. */
CV_EXPORTS_W void drawPoseUncertainty(InputOutputArray image, const Ptr<CameraModel>& camera, const Result& result,
                                      double length, InputArray points = noArray(), int thickness = 3);

//! @}

}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_DRAW_HPP
