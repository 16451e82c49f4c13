// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_API_RANSAC_HPP
#define OPENCV_GMLPNP_API_RANSAC_HPP

#include "../precomp.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

/** What cv::solvePnPRansac takes one by one; StsBadArg, named as there, for what is out of range. */
RansacParams ransacParamsOf(int iterationsCount, double reprojectionError, double confidence);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_API_RANSAC_HPP
