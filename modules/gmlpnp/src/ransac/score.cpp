// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "score.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

ScoredPoints::ScoredPoints(const Correspondences& data, const std::vector<Metric>& metrics, RNG& rng,
                           const RayKernels& kernels)
    : kernels_(kernels), order_(data.size()), columns_(data.size(), 12)
{
    for (int i = 0; i < size(); ++i)
        order_[i] = i;
    for (int i = size() - 1; i > 0; --i)
        std::swap(order_[i], order_[rng.uniform(0, i + 1)]);
    for (int row = 0; row < size(); ++row) {
        const int i = order_[row];
        columns_.row(row) << data.pointAt(i).transpose(), data.unitRayAt(i).transpose(), metrics[i].row(0),
            metrics[i].row(1);
    }
}

ScoredArrays ScoredPoints::arrays() const
{
    const auto column = [this](Eigen::Index k) { return columns_.col(k).data(); };
    return {{column(0), column(1), column(2)},
            {column(3), column(4), column(5)},
            {column(6), column(7), column(8), column(9), column(10), column(11)},
            size()};
}

namespace {

// Statistics: a pose as good as the best looks worse by fewer standard deviations with a probability of .999.
constexpr double LATITUDE = 3;

// Says whether a pose of this cost over the points seen so far cannot reach a mean cost as low as `mean`. Each point
// costs between 0 and 1, so the variance of a cost of mean mu is at most mu (1 - mu).
bool hopeless(double cost, double seen, double mean)
{
    return cost > seen * mean + LATITUDE * std::sqrt(seen * mean * (1 - mean));
}

}  // namespace

Score ScoredPoints::sumUntil(const Pose& pose, int count, double best) const
{
    constexpr int GROUP = 64;  // so many points lie between two decisions to give up
    const ScoredArrays data = arrays();
    const double mean = std::min(1., best / count);
    const std::array<double, 12> at = entriesOf(pose);
    double cost = 0, inliers = 0;
    for (int first = 0; first < count; first += GROUP) {
        if (first > 0 && (cost >= best || hopeless(cost, first, mean)))
            return {std::numeric_limits<double>::infinity(), 0};
        TruncatedSums sums;
        kernels_.truncated(data, at.data(), first, std::min(first + GROUP, count), sums);
        cost += sums.cost;
        inliers += sums.inliers;
    }
    return {cost, static_cast<int>(inliers)};
}

Score ScoredPoints::score(const Pose& pose) const
{
    return sumUntil(pose, size(), std::numeric_limits<double>::infinity());
}

Score ScoredPoints::scoreAgainst(const Pose& pose, double best) const
{
    return sumUntil(pose, std::min(size(), SCREENED), best);
}

std::vector<bool> ScoredPoints::inliers(const Pose& pose) const
{
    std::vector<double> isInlier(size());
    kernels_.inliers(arrays(), entriesOf(pose).data(), isInlier.data());
    std::vector<bool> found(size());
    for (int row = 0; row < size(); ++row)
        found[order_[row]] = isInlier[row] > 0;
    return found;
}

bool ScoredPoints::step(Pose& pose, double width, int count) const
{
    StepSums sums;
    kernels_.robustStep(arrays(), entriesOf(pose).data(), width, std::min(size(), count), sums);
    const UnitDiagonal scaled(symmetric6(sums.H));
    const Eigen::LDLT<Matrix6d> ldlt(scaled.matrix);
    constexpr double SMALLEST_PIVOT = 1e-12;  // rounding, at a unit diagonal
    if (!(ldlt.vectorD().minCoeff() > SMALLEST_PIVOT))
        return false;
    const Vector6d g = scaled.scale.cwiseProduct(Eigen::Map<const Vector6d>(sums.g));
    pose = perturbed(pose, -scaled.scale.cwiseProduct(ldlt.solve(g)));
    return true;
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
