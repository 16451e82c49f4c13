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

/** Every pose that puts three points on three rays with positive depths:  R p_i + t = s_i m_i,  s_i > 0.

The depths are where two conics of the pencil  D1 + gamma D2  meet; a member that is a pair of lines turns them into
two quadratic equations (Persson and Nordberg, "Lambda Twist", ECCV 2018; Ding et al., "Revisiting the P3P problem",
CVPR 2023). Newton's method on the three distances ends it.
@param points object points, not on one line.
@param rays unit rays of any direction.
@param poses the first entries are written.
@return how many poses: 0 to 4. */
CV_EXPORTS int p3p(const Triple& points, const Triple& rays, std::array<Pose, 4>& poses);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_RANSAC_P3P_HPP
