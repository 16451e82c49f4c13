// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_DRAW_DRAW_HPP
#define OPENCV_GMLPNP_DRAW_DRAW_HPP

#include "../precomp.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

/** Finds the pixel of an object point, and its covariance [px^2], 2x2, to first order from the covariance of the pose.
@param camera the lens.
@param result a pose; without Result::poseCovariance the covariance of the pixel is zero.
@param point object point, object frame, the caller's length.
@param pixel px.
@param covariance px^2.
@return whether the lens sees the point. */
CV_EXPORTS bool pixelUncertainty(const CameraModel& camera, const Result& result, const Vec3d& point, Point2d& pixel,
                                 Matx22d& covariance);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_DRAW_DRAW_HPP
