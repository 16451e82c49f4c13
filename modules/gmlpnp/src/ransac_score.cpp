// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "precomp.hpp"

#include "ransac_score.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

ScoredPoints::ScoredPoints(const Correspondences& data, const std::vector<Metric>& metrics, RNG& rng)
    : n_(data.size()), order_(data.size()), blocks_((data.size() + LANES - 1) / LANES)
{
    for (int i = 0; i < n_; ++i)
        order_[i] = i;
    for (int i = n_ - 1; i > 0; --i)
        std::swap(order_[i], order_[rng.uniform(0, i + 1)]);
    for (int lane = 0; lane < static_cast<int>(blocks_.size()) * LANES; ++lane) {
        Block& block = blocks_[lane / LANES];
        const int k = lane % LANES;
        // What fills the last block has no ray, so it is never in front.
        const bool real = lane < n_;
        const Vector3d p = real ? data.pointAt(order_[lane]) : Vector3d::Zero();
        const Vector3d m = real ? data.rayAt(order_[lane]) : Vector3d::Zero();
        const Metric B = real ? metrics[order_[lane]] : Metric::Zero();
        for (int axis = 0; axis < 3; ++axis) {
            block.p[axis](k) = p(axis);
            block.m[axis](k) = m(axis);
            block.B[0][axis](k) = B(0, axis);
            block.B[1][axis](k) = B(1, axis);
        }
    }
}

ScoredPoints::Lane ScoredPoints::costs(const Block& block, const Pose& pose)
{
    const auto& [p, m, B] = block;
    Lane X[3];
    for (int axis = 0; axis < 3; ++axis)
        X[axis] = pose.R(axis, 0) * p[0] + pose.R(axis, 1) * p[1] + pose.R(axis, 2) * p[2] + pose.t(axis);
    const Lane s = m[0] * X[0] + m[1] * X[1] + m[2] * X[2];
    const Lane u = B[0][0] * X[0] + B[0][1] * X[1] + B[0][2] * X[2];
    const Lane v = B[1][0] * X[0] + B[1][1] * X[1] + B[1][2] * X[2];
    const Lane cost = (u * u + v * v) / (s * s);
    return (s > 0 && cost < 1).select(cost, 1.);
}

namespace {

// Standard deviations that a pose as good as the best may look worse by, on the points seen so far.
constexpr double LATITUDE = 3;

// Each point costs between 0 and 1, so the variance of a mean cost mu is at most mu (1 - mu).
bool hopeless(double cost, double seen, double mean)
{
    return cost > seen * mean + LATITUDE * std::sqrt(seen * mean * (1 - mean));
}

}  // namespace

Score ScoredPoints::sumUntil(const Pose& pose, double best) const
{
    constexpr size_t GROUP = 8;  // blocks between two looks
    const double mean = std::min(1., best / n_);
    Lane cost = Lane::Zero(), inliers = Lane::Zero();
    for (size_t b = 0; b < blocks_.size(); ++b) {
        if (b % GROUP == 0 && b > 0) {
            const double sum = cost.sum();
            if (sum >= best || hopeless(sum, static_cast<double>(b * LANES), mean))
                return {std::numeric_limits<double>::infinity(), 0};
        }
        const Lane here = costs(blocks_[b], pose);
        cost += here;
        inliers += (here < 1).select(Lane::Ones(), Lane::Zero());
    }
    const double filling = static_cast<double>(blocks_.size()) * LANES - n_;
    return {cost.sum() - filling, static_cast<int>(inliers.sum())};
}

Score ScoredPoints::score(const Pose& pose) const
{
    return sumUntil(pose, std::numeric_limits<double>::infinity());
}

Score ScoredPoints::scoreAgainst(const Pose& pose, double best) const
{
    return sumUntil(pose, best);
}

std::vector<bool> ScoredPoints::inliers(const Pose& pose) const
{
    std::vector<bool> found(n_);
    for (int lane = 0; lane < n_; ++lane)
        found[order_[lane]] = costs(blocks_[lane / LANES], pose)(lane % LANES) < 1;
    return found;
}

bool ScoredPoints::step(Pose& pose, double width, int count) const
{
    const double width2 = width * width;
    Matrix6d H = Matrix6d::Zero();
    Vector6d g = Vector6d::Zero();
    for (int lane = 0; lane < std::min(count, n_); ++lane) {
        const Block& block = blocks_[lane / LANES];
        const int k = lane % LANES;
        const Vector3d m(block.m[0](k), block.m[1](k), block.m[2](k));
        const Vector3d X = pose * Vector3d(block.p[0](k), block.p[1](k), block.p[2](k));
        const double s = m.dot(X);
        Metric B;
        B << block.B[0][0](k), block.B[0][1](k), block.B[0][2](k), block.B[1][0](k), block.B[1][1](k), block.B[1][2](k);
        const Eigen::Vector2d e = B * X / s;
        const double share = e.squaredNorm() / width2;
        if (!(s > 0 && share < 1))
            continue;
        const double w = (1 - share) * (1 - share);
        for (int row = 0; row < 2; ++row) {
            const Vector3d slope = (B.row(row).transpose() - e(row) * m) / s;  // of e by X
            Vector6d J;
            J << X.cross(slope), slope;
            H += w * J * J.transpose();
            g += w * e(row) * J;
        }
    }
    const UnitDiagonal scaled(H);
    const Eigen::LDLT<Matrix6d> ldlt(scaled.matrix);
    constexpr double SINGULAR = 1e-12;
    if (!(ldlt.vectorD().minCoeff() > SINGULAR))
        return false;
    pose = perturbed(pose, -scaled.scale.cwiseProduct(ldlt.solve(scaled.scale.cwiseProduct(g))));
    return true;
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
