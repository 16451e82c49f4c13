// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_BASELINES_CONTROL_POINTS_HPP
#define GMLPNP_BASELINES_CONTROL_POINTS_HPP

#include "baselines.hpp"

namespace baselines {

/** The parametrisation of EPnP (V. Lepetit, F. Moreno-Noguer, P. Fua: EPnP: An Accurate O(n) Solution to the PnP
Problem, IJCV 81, 2009): every point is an affine combination of four control points, or three where all are coplanar;
unknown are the control points in the camera frame, one below the other in a vector x with  M x = 0. */
struct ControlPoints
{
    explicit ControlPoints(const Matrix3Xd& points);

    Matrix3Xd object;        //!< 3 x 4 or 3 x 3, object frame
    Eigen::MatrixXd alphas;  //!< a column of combination coefficients per point

    int count() const { return static_cast<int>(object.cols()); }
};

using Rows = Eigen::Matrix<double, 2, Eigen::Dynamic>;

/** Both rows of M of a point (Eqs. (5), (6)); its product with x is the algebraic error, image error times depth. */
Rows rowsOf(const ControlPoints& control, const Data& data, int i);

/** The last columns are the eigenvectors of the four (three) smallest eigenvalues of  sum_i M_i^T W_i M_i,  the
smallest first. No weights: all alike. */
Eigen::MatrixXd kernel(const ControlPoints& control, const Data& data, const std::vector<Matrix2d>& weights);

/** The control points in the camera frame as combinations of 1, 2, 3 kernel vectors, from their mutual distances, each
improved by Gauss-Newton over all kernel vectors (sections 3.3, 3.4): one pose for each. */
std::vector<Pose> posesByDistances(const ControlPoints& control, const Eigen::MatrixXd& kernel, const Data& data);

/** The same by orthogonal Procrustes analysis, alternating between the kernel and the rigid motions (section 3.2 of
the EPPnP paper, see reppnp.cpp). */
Pose poseByProcrustes(const ControlPoints& control, const Eigen::MatrixXd& kernel, const Data& data);

}  // namespace baselines

#endif  // GMLPNP_BASELINES_CONTROL_POINTS_HPP
