// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_DRAW_DRAW_HPP
#define OPENCV_GMLPNP_DRAW_DRAW_HPP

#include "../precomp.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

/** Where an object point is seen, and the covariance of that pixel [px^2] from the covariance of the pose, to first
order (zero without one). Whether the lens sees it. */
CV_EXPORTS bool pixelUncertainty(const CameraModel& camera, const Result& result, const Vec3d& point, Point2d& pixel,
                                 Matx22d& covariance);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_DRAW_DRAW_HPP
