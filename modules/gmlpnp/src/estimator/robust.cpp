// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "../ransac/repeats.hpp"
#include "robust.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

// RANSAC on one page:
//
//     search    for the pose with which most correspondences agree      ransac/search
//     fit       pose and noise on its inliers                           solve
//     recount   the inliers at that pose, and fit again until they stay
//     report    once, for the last fit

namespace {

constexpr int FEWEST_INLIERS = 4;

std::vector<Metric> chosenMetrics(const std::vector<Metric>& all, const std::vector<int>& rows)
{
    std::vector<Metric> metrics;
    for (const int row : rows)
        metrics.push_back(all[row]);
    return metrics;
}

// The consensus among matches of which none repeats another.
std::optional<Consensus> search(const Correspondences& data, const Measure& measure, const RansacOptions& ransac)
{
    const std::vector<int> rows = withoutRepeats(data, measure.metrics);
    if (rows.empty())
        return findConsensus(data, measure.metrics, ransac);
    if (rows.size() < FEWEST_INLIERS)
        return std::nullopt;
    return findConsensus(data.subset(rows), chosenMetrics(measure.metrics, rows), ransac);
}

size_t countDifferent(const std::vector<int>& a, const std::vector<int>& b)
{
    std::vector<int> different;
    std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(different));
    return different.size();
}

// The fit on some inliers, and the inliers at its pose.
struct InlierFit
{
    std::vector<int> used;
    std::optional<Correspondences> data;  // the used rows
    Estimate estimate;
    Inliers inliers;
};

// Fits on the inliers at a pose of the object frame, takes those at the fitted pose, and again until they stay. A share
// of points that come and go at the threshold moves the pose by far less than its uncertainty.
Status fitOnInliers(const Correspondences& all, const Measure& measure, const Options& options, Pose pose,
                    InlierFit& fit)
{
    constexpr int ROUNDS = 10;
    constexpr size_t COME_AND_GO = 100;  // one of so many
    constexpr int FEWEST_PLACES = 3;     // the pose of the consensus chooses among those of three points
    fit.inliers = inliersOf(all, measure, all.fromObject(pose));
    for (int round = 0; round < ROUNDS; ++round) {
        fit.used = fit.inliers.rows;
        if (fit.used.size() < FEWEST_INLIERS)
            return STATUS_NO_CONSENSUS;
        fit.data = all.subset(fit.used);
        const Status status = check(*fit.data, FEWEST_PLACES);
        if (!isSuccess(status))
            return status;
        const std::optional<Estimate> found = fitNear(*fit.data, fit.data->fromObject(pose), options);
        if (!found)
            return STATUS_DEGENERATE;
        fit.estimate = *found;
        pose = fit.data->toObject(found->pose);
        fit.inliers = inliersOf(all, measure, all.fromObject(pose));
        if (countDifferent(fit.used, fit.inliers.rows) * COME_AND_GO <= fit.used.size())
            break;
    }
    if (fit.inliers.rows.size() < FEWEST_INLIERS)
        return STATUS_NO_CONSENSUS;
    return fit.estimate.converged ? STATUS_CONVERGED : STATUS_MAX_ROUNDS;
}

// A threshold that cuts into the noise leaves residuals that are smaller than the noise by varianceLeft(). And the
// points that a pose leaves behind no longer pull at it, so that the cost is as much flatter than that of as many
// points.
void undoTheCut(const Options& options, const Inliers& inliers, Solution& solution)
{
    constexpr double TAKEN = 3;  // points' worth of residuals that the pose takes: 6 of 2 n
    if (!solution.covariance)
        return;
    const double count = static_cast<double>(inliers.rows.size());
    const double left = varianceLeft(inliers.sumOfSquares / std::max(count - TAKEN, 1.));
    const bool known = options.Sigma && options.Gamma;
    *solution.covariance /= known ? left : left * left;
}

}  // namespace

Status solveRobust(const Observations& observations, const Measure& measure, const Options& options,
                   const RansacOptions& ransac, RobustSolution& out)
{
    if (observations.points.rows < FEWEST_INLIERS)
        return STATUS_TOO_FEW_POINTS;
    const Correspondences all(observations);
    const Status status = check(all, 1);
    if (!isSuccess(status))
        return status;

    const std::optional<Consensus> consensus = search(all, measure, ransac);
    if (!consensus)
        return STATUS_NO_CONSENSUS;
    Options fitting = options;
    fitting.guess.reset();
    InlierFit fit;
    const Status fitted = fitOnInliers(all, measure, fitting, consensus->pose, fit);
    if (!isSuccess(fitted))
        return fitted;

    out.solution = reported(*fit.data, fit.estimate, fitting);
    undoTheCut(options, fit.inliers, out.solution);
    out.used = std::move(fit.used);
    out.inliers = std::move(fit.inliers.rows);
    return fitted;
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
