// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "reprojection.hpp"

// V. Garro, F. Crosilla, A. Fusiello: Solving the PnP Problem with Anisotropic Orthogonal Procrustes Analysis, 3DIMPVT
// 2012. With image points P (rows), object points S and depths Z = diag(zeta):  S = Z P R + 1 c^T; rotation, camera
// centre c and depths are improved in turn (their Algorithm 1). Each turn lowers the sum of squared distances of the
// object points from their rays, slowly in a narrow view: hence many, cheap turns.

namespace baselines {

namespace {

struct State
{
    Pose pose;
    Eigen::VectorXd depths;  // of the points of the image plane
};

State nextState(const Data& data, const Matrix3Xd& image, const State& now)
{
    const Matrix3Xd Y = image.array().rowwise() * now.depths.transpose().array();  // back-projected
    const Vector3d meanY = Y.rowwise().mean(), meanP = data.points.rowwise().mean();
    const Matrix3d M = (Y.colwise() - meanY) * data.points.transpose();
    State next;
    next.pose.R = cv::gmlpnp::detail::nearestRotation(M);
    next.pose.t = meanY - next.pose.R * meanP;
    const Matrix3Xd X = (next.pose.R * data.points).colwise() + next.pose.t;
    next.depths = (image.cwiseProduct(X).colwise().sum().array() / image.colwise().squaredNorm().array())
                      .max(0)  // depths are not negative
                      .transpose();
    return next;
}

}  // namespace

std::optional<Pose> ppnp(const Data& data, const PpnpOptions& options)
{
    const Matrix3Xd image = data.image.colwise().homogeneous();
    State now{{}, Eigen::VectorXd::Ones(data.size())};
    for (int k = 0; k < options.maxIterations; ++k) {
        const State next = nextState(data, image, now);
        const double turn = (next.pose.R - now.pose.R).norm(), shift = (next.pose.t - now.pose.t).norm();
        now = next;
        if (turn < options.tolerance && shift < options.tolerance * now.pose.t.norm())
            break;
    }
    return plausible(data, now.pose) ? std::optional<Pose>(now.pose) : std::nullopt;
}

}  // namespace baselines
