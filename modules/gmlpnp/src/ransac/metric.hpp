// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_RANSAC_METRIC_HPP
#define OPENCV_GMLPNP_RANSAC_METRIC_HPP

#include "../math/lie.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

/** How far a point is from its ray, in any unit, to first order: with X = R p + t the residual of point i is

    e_i = B_i X / (m_i . X),   B_i m_i = 0,   m_i . X > 0

where the 2x3 matrix B_i turns a change of the ray into thresholds. Inliers have |e_i| <= 1. */
using Metric = Eigen::Matrix<double, 2, 3>;

/** Metric of a lens: the pseudo-inverse of the derivative of the unit ray by the pixel, over the threshold [px]. */
CV_EXPORTS Metric pixelMetric(const Eigen::Matrix<double, 3, 2>& rayByPixel, double threshold);

/** Metric of an angle: |e_i| = tan(angle) / tan(threshold) holds exactly. The threshold is below pi/2 [rad]. */
CV_EXPORTS Metric angularMetric(const Vector3d& ray, double threshold);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_RANSAC_METRIC_HPP
