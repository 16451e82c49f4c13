// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_RANSAC_P3P_HPP
#define OPENCV_GMLPNP_RANSAC_P3P_HPP

#include "../math/lie.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

using Triple = std::array<Vector3d, 3>;

/** Finds every pose that puts three points on three rays with positive depths:  R p_i + t = s_i m_i,  s_i > 0.

The depths lie where two conics of the pencil  D1 + gamma D2  meet. One member of the pencil is a pair of lines, which
leaves two quadratic equations (Persson and Nordberg, "Lambda Twist", ECCV 2018; Ding et al., "Revisiting the P3P
problem", CVPR 2023). Newton's method on the three distances ends the search.
@param points object points, object frame, not on one line; any length.
@param rays unit rays of any direction, camera frame.
@param poses poses in the length of the points; only the first entries, as many as are returned, are written.
@return the number of poses, 0 to 4. */
CV_EXPORTS int p3p(const Triple& points, const Triple& rays, std::array<Pose, 4>& poses);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_RANSAC_P3P_HPP
