// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "control_points.hpp"
#include "reprojection.hpp"

// L. Ferraz, X. Binefa, F. Moreno-Noguer: Very Fast Solution to the PnP Problem with Algebraic Outlier Rejection, CVPR
// 2014. The null vector of EPnP's M and the points that it explains are found in turn: a point's weight is one where
// its algebraic error is at most max(25 % quantile, largest error of an inlier), else zero (Eqs. (5)-(7)). The control
// points then follow by orthogonal Procrustes analysis in the kernel of the points that are left (EPPnP).

namespace baselines {

namespace {

constexpr double QUANTILE = 0.25;

// In units of the image plane: the algebraic errors of a null vector divided by the mean depth it gives.
std::vector<double> algebraicErrors(const ControlPoints& control, const Data& data, const Eigen::VectorXd& x)
{
    const Eigen::Map<const Matrix3Xd> points(x.data(), 3, control.count());
    const double depth = (points.row(2) * control.alphas).cwiseAbs().mean();
    std::vector<double> errors;
    for (int i = 0; i < data.size(); ++i)
        errors.push_back((rowsOf(control, data, i) * x).norm() / depth);
    return errors;
}

double quantile(std::vector<double> values, double share)
{
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

}  // namespace

std::optional<Pose> reppnp(const Data& data, double largestInlierError)
{
    constexpr int MAX_TURNS = 100;
    const ControlPoints control(data.points);
    std::vector<Matrix2d> weights(data.size(), Matrix2d::Identity());
    Eigen::MatrixXd K = kernel(control, data, weights);
    for (int turn = 0; turn < MAX_TURNS; ++turn) {
        const std::vector<double> errors = algebraicErrors(control, data, K.col(0));
        const double bound = std::max(quantile(errors, QUANTILE), largestInlierError);
        bool changed = false;
        for (int i = 0; i < data.size(); ++i) {
            const Matrix2d weight = (errors[i] <= bound ? 1. : 0.) * Matrix2d::Identity();
            changed = changed || weight != weights[i];
            weights[i] = weight;
        }
        if (!changed)
            break;
        K = kernel(control, data, weights);
    }
    const Pose pose = poseByProcrustes(control, K, data);
    return plausible(data, pose) ? std::optional<Pose>(pose) : std::nullopt;
}

}  // namespace baselines
