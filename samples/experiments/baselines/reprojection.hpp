// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_BASELINES_REPROJECTION_HPP
#define GMLPNP_BASELINES_REPROJECTION_HPP

#include "baselines.hpp"

namespace baselines {

/** Where a pose sees a point on the image plane at distance 1, and what that depends on. */
struct Reprojection
{
    Vector2d residual;                    //!< seen minus predicted
    Eigen::Matrix<double, 2, 3> toPoint;  //!< derivative of the prediction by the point in the camera frame
    Eigen::Matrix<double, 2, 6> toPose;   //!< by xi = (phi, delta), left perturbation
};
Reprojection reproject(const Data& data, int i, const Pose& pose);

/** Covariance of the residual: the pixel's, and the point's turned into the camera and projected. */
Matrix2d residualCovariance(const Reprojection& at, const Pose& pose, const Uncertainty& uncertainty, int i);

/** Inverse covariances of the algebraic errors  (X, Y) - Z (x, y),  depth and rotation from a hypothesis. */
std::vector<Matrix2d> algebraicWeights(const Data& data, const Pose& hypothesis, const Uncertainty& uncertainty);

/** Gauss-Newton on the weighted reprojection errors, weights renewed at each step; no uncertainty: all alike. Stops
when a step is negligible. */
Pose refined(const Data& data, const Pose& start, int maxSteps, const Uncertainty* uncertainty = nullptr);

/** Whether more than half of the points are in front of the camera and the pose is finite. */
bool plausible(const Data& data, const Pose& pose);

}  // namespace baselines

#endif  // GMLPNP_BASELINES_REPROJECTION_HPP
