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

ScoredPoints::Residuals ScoredPoints::residuals(const Block& block, const Pose& pose)
{
    const auto& [p, m, B] = block;
    Residuals r;
    auto& X = r.X;
    for (int axis = 0; axis < 3; ++axis)
        X[axis] = pose.R(axis, 0) * p[0] + pose.R(axis, 1) * p[1] + pose.R(axis, 2) * p[2] + pose.t(axis);
    r.s = m[0] * X[0] + m[1] * X[1] + m[2] * X[2];
    const Lane inverse = (r.s > 0).select(1 / r.s, 0.);
    for (int row = 0; row < 2; ++row)
        r.e[row] = (B[row][0] * X[0] + B[row][1] * X[1] + B[row][2] * X[2]) * inverse;
    return r;
}

ScoredPoints::Lane ScoredPoints::costs(const Block& block, const Pose& pose)
{
    const auto [X, s, e] = residuals(block, pose);
    const Lane cost = e[0] * e[0] + e[1] * e[1];
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

Score ScoredPoints::sumUntil(const Pose& pose, size_t blocks, double best) const
{
    constexpr size_t GROUP = 8;  // blocks between two looks
    const double points = std::min(static_cast<double>(blocks) * LANES, static_cast<double>(n_));
    const double mean = std::min(1., best / points);
    Lane cost = Lane::Zero(), inliers = Lane::Zero();
    for (size_t b = 0; b < blocks; ++b) {
        if (b % GROUP == 0 && b > 0) {
            const double sum = cost.sum();
            if (sum >= best || hopeless(sum, static_cast<double>(b * LANES), mean))
                return {std::numeric_limits<double>::infinity(), 0};
        }
        const Lane here = costs(blocks_[b], pose);
        cost += here;
        inliers += (here < 1).select(Lane::Ones(), Lane::Zero());
    }
    const double filling = static_cast<double>(blocks) * LANES - points;
    return {cost.sum() - filling, static_cast<int>(inliers.sum())};
}

Score ScoredPoints::score(const Pose& pose) const
{
    return sumUntil(pose, blocks_.size(), std::numeric_limits<double>::infinity());
}

Score ScoredPoints::scoreAgainst(const Pose& pose, double best) const
{
    return sumUntil(pose, std::min<size_t>(blocks_.size(), SCREENED / LANES), best);
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
    Lane sumH[21], sumG[6];
    for (Lane& sum : sumH)
        sum.setZero();
    for (Lane& sum : sumG)
        sum.setZero();
    const size_t blocks = std::min<size_t>(blocks_.size(), (static_cast<size_t>(count) + LANES - 1) / LANES);
    for (size_t b = 0; b < blocks; ++b) {
        const Block& block = blocks_[b];
        const auto [X, s, e] = residuals(block, pose);
        const Lane left = 1 - (e[0] * e[0] + e[1] * e[1]) / (width * width);
        const Lane w = (s > 0 && left > 0).select(left * left, 0.), inverse = (s > 0).select(1 / s, 0.);
        for (int row = 0; row < 2; ++row) {
            Lane J[6];
            for (int axis = 0; axis < 3; ++axis)
                J[3 + axis] = (block.B[row][axis] - e[row] * block.m[axis]) * inverse;  // of e by X
            for (int axis = 0; axis < 3; ++axis) {
                const int next = (axis + 1) % 3, last = (axis + 2) % 3;
                J[axis] = X[next] * J[3 + last] - X[last] * J[3 + next];
            }
            for (int i = 0, k = 0; i < 6; ++i) {
                const Lane wJ = w * J[i];
                sumG[i] += wJ * e[row];
                for (int j = i; j < 6; ++j, ++k)
                    sumH[k] += wJ * J[j];
            }
        }
    }
    Matrix6d H;
    Vector6d g;
    for (int i = 0, k = 0; i < 6; ++i) {
        g(i) = sumG[i].sum();
        for (int j = i; j < 6; ++j, ++k)
            H(i, j) = H(j, i) = sumH[k].sum();
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
