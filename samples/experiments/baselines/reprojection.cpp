// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "reprojection.hpp"

namespace baselines {

using cv::gmlpnp::detail::hat;

Reprojection reproject(const Data& data, int i, const Pose& pose)
{
    const Vector3d X = pose * data.points.col(i);
    Reprojection at;
    at.residual = data.image.col(i) - X.head<2>() / X.z();
    at.toPoint << 1 / X.z(), 0, -X.x() / (X.z() * X.z()), 0, 1 / X.z(), -X.y() / (X.z() * X.z());
    at.toPose << -at.toPoint * hat(X), at.toPoint;
    return at;
}

Matrix2d residualCovariance(const Reprojection& at, const Pose& pose, const Uncertainty& uncertainty, int i)
{
    return uncertainty.image[i] +
           at.toPoint * pose.R * uncertainty.object[i] * pose.R.transpose() * at.toPoint.transpose();
}

std::vector<Matrix2d> algebraicWeights(const Data& data, const Pose& hypothesis, const Uncertainty& uncertainty)
{
    std::vector<Matrix2d> weights;
    for (int i = 0; i < data.size(); ++i) {
        const double depth = (hypothesis * data.points.col(i)).z();
        const Reprojection at = reproject(data, i, hypothesis);
        weights.emplace_back((depth * depth * residualCovariance(at, hypothesis, uncertainty, i)).inverse());
    }
    return weights;
}

Pose refined(const Data& data, const Pose& start, int maxSteps, const Uncertainty* uncertainty)
{
    constexpr double NEGLIGIBLE = 1e-12;
    Pose pose = start;
    for (int step = 0; step < maxSteps; ++step) {
        Matrix6d H = Matrix6d::Zero();
        Vector6d g = Vector6d::Zero();
        for (int i = 0; i < data.size(); ++i) {
            const Reprojection at = reproject(data, i, pose);
            const Matrix2d W = uncertainty ? Matrix2d(residualCovariance(at, pose, *uncertainty, i).inverse())
                                           : Matrix2d(Matrix2d::Identity());
            H += at.toPose.transpose() * W * at.toPose;
            g += at.toPose.transpose() * W * at.residual;
        }
        const Vector6d xi = H.ldlt().solve(g);
        const Pose next = perturbed(pose, xi);
        if (!plausible(data, next))
            return pose;
        pose = next;
        if (xi.head<3>().norm() < NEGLIGIBLE && xi.tail<3>().norm() < NEGLIGIBLE * pose.t.norm())
            break;
    }
    return pose;
}

bool plausible(const Data& data, const Pose& pose)
{
    if (!pose.R.allFinite() || !pose.t.allFinite())
        return false;
    int inFront = 0;
    for (int i = 0; i < data.size(); ++i)
        inFront += data.rays.col(i).dot(pose * data.points.col(i)) > 0;
    return 2 * inFront > data.size();
}

}  // namespace baselines
