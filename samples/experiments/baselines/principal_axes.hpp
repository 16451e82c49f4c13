// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_BASELINES_PRINCIPAL_AXES_HPP
#define GMLPNP_BASELINES_PRINCIPAL_AXES_HPP

#include "baselines.hpp"

namespace baselines {

/** Flatter points than this are coplanar to rounding. */
constexpr double SURELY_FLAT = 1e-6;

/** Where the points lie and how they spread. */
struct PrincipalAxes
{
    Vector3d centroid;
    Matrix3d axes;        //!< columns, widest first, right-handed
    Vector3d deviations;  //!< along them, length

    explicit PrincipalAxes(const Matrix3Xd& points) : centroid(points.rowwise().mean())
    {
        const Matrix3Xd centred = points.colwise() - centroid;
        const cv::gmlpnp::detail::Eigen3d eigen(centred * centred.transpose() / static_cast<double>(points.cols()));
        axes = eigen.eigenvectors().rowwise().reverse();
        axes.col(2) *= axes.determinant();
        deviations = eigen.eigenvalues().reverse().cwiseMax(0).cwiseSqrt();
    }

    double flatness() const { return deviations(2) / deviations(1); }
};

}  // namespace baselines

#endif  // GMLPNP_BASELINES_PRINCIPAL_AXES_HPP
