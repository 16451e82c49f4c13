// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_RAYS_OBSERVATIONS_HPP
#define OPENCV_GMLPNP_RAYS_OBSERVATIONS_HPP

#include "../precomp.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

/** What a caller has observed, as matrices of doubles: a row per correspondence. */
struct Observations
{
    Mat_<double> points;             //!< N x 3, object frame, the caller's length
    Mat_<double> rays;               //!< N x 3, camera frame
    Mat_<double> objectCovariances;  //!< N x 9 known covariances of the points, length^2; or empty
    Mat_<double> rayCovariances;     //!< N x 9 known covariances of the rays, rad^2; or empty
    //! Whether the rays are as long as their angular scales (CameraModel::angularScales). Otherwise their lengths mean
    //! nothing.
    bool scaled = false;
};

/** The chosen rows of a matrix. All rows in their order are returned without a copy, and so is an empty matrix. */
Mat_<double> chosenRows(const Mat_<double>& all, const std::vector<int>& rows);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_RAYS_OBSERVATIONS_HPP
