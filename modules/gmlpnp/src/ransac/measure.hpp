// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_RANSAC_MEASURE_HPP
#define OPENCV_GMLPNP_RANSAC_MEASURE_HPP

#include "../rays/correspondences.hpp"
#include "metric.hpp"

#include <functional>

namespace cv {
namespace gmlpnp {
namespace detail {

/** The measure of residuals. The search uses it to first order; the inliers that are returned are measured exactly. */
struct Measure
{
    std::vector<Metric> metrics;  //!< one a row of the observations
    double chance;                //!< probability that a wrong correspondence is an inlier
    //! (row, X, e2): the squared residual over the squared threshold of a row at X, where it is e2 to first order.
    std::function<double(int, const Vector3d&, double)> exact;
};

/** Angles between points and rays; threshold below pi/2 [rad]. */
Measure angularMeasure(const Mat_<double>& rays, double threshold);

/** Reprojection errors; `pixels` and `rayByPixel` (Nx6) of the rows, threshold [px]. */
Measure pixelMeasure(const Ptr<CameraModel>& camera, const Mat_<double>& pixels, const Mat_<double>& rayByPixel,
                     double threshold);

struct Inliers
{
    std::vector<int> rows;  //!< within the threshold, ascending
    double sumOfSquares;    //!< of their residuals, thresholds^2
};

/** The correspondences within the threshold at a pose in their own units. */
Inliers inliersOf(const Correspondences& data, const Measure& measure, const Pose& pose);

/** The share of the variance of Gaussian noise in the picture that a threshold leaves (residuals of two dimensions):

    E(|e|^2, |e| < 1) / (2 sigma^2) = 1 - x / (e^x - 1),   x = 1 / (2 sigma^2),   sigma in thresholds,

from the mean square  1/x - 1/(e^x - 1)  of the residuals below it. The mean square tells sigma where the threshold is
above about 1.5 sigma. Below, the residuals are as good as uniform with a mean square of 1/2, and a bound is returned.
*/
CV_EXPORTS double varianceLeft(double meanSquare);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_RANSAC_MEASURE_HPP
