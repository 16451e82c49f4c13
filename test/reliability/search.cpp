// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "search.hpp"

#include "src/estimator/alternation.hpp"
#include "src/estimator/pose_covariance.hpp"
#include "src/noise/fit.hpp"
#include "trials.hpp"

namespace reliability {

namespace {

using namespace cv::gmlpnp::detail;

// The translation of least isotropic cost for a rotation.
Pose withTranslation(const Correspondences& data, const Matrix3d& R)
{
    Matrix3d A = Matrix3d::Zero();
    Vector3d b = Vector3d::Zero();
    for (int i = 0; i < data.size(); ++i) {
        const Matrix3d Q = Matrix3d::Identity() - data.scaledRayAt(i) * data.scaledRayAt(i).transpose();
        A += Q;
        b -= Q * (R * data.pointAt(i));
    }
    return {R, A.ldlt().solve(b)};
}

constexpr double SAME = 1e-4;  // rad, and share of the distance

bool near(const Pose& a, const Pose& b)
{
    return (a.R - b.R).norm() < SAME;
}

const Noise UNIT = isotropic(1, 0);

// The next step of Gauss-Newton would not move it.
bool atRest(const Pose& pose, const RaySums& sums)
{
    const Vector6d step = sums.H.ldlt().solve(sums.g);
    return step.head<3>().norm() < SAME && step.tail<3>().norm() < SAME * pose.t.norm();
}

struct Descent
{
    Pose pose;
    bool ended;  // at a minimum; along an edge-on view it creeps
};

Descent descend(const Correspondences& data, Pose pose)
{
    constexpr int DESCENTS = 20;
    for (int k = 0; k < DESCENTS; ++k) {
        pose = isotropicPose(data, pose);
        if (atRest(pose, rayPass(data, pose, UNIT)))
            return {pose, true};
    }
    return {pose, false};
}

}  // namespace

bool searchable(const Problem& problem)
{
    constexpr int FEWEST = 6;
    // A pose is R and t, which are rounded: far from the origin by so much that L tells [sizes].
    const double rounding = std::numeric_limits<double>::epsilon() * (problem.offset + problem.distance);
    constexpr double ABOVE_ROUNDING = 1e3, SMALLEST = 1e-9;
    const double noise = problem.objectNoise + problem.distance * problem.rayNoise;
    return problem.n >= FEWEST && !problem.hasGuess() && problem.outliers == 0 && !problem.corrupt &&
           problem.shape != Shape::BEHIND && problem.shape != Shape::UNRELATED &&
           noise > std::max(SMALLEST, ABOVE_ROUNDING * rounding);
}

namespace {

// The least L with noise of one kind at a pose that is held. It runs to the end, where costWithNoiseFitted() stops
// early: the search shows by how much that matters.
double fittedCost(const Correspondences& data, const Pose& pose, NoiseKind kind, const IsotropicNoise& start)
{
    constexpr int ROUNDS = 100;  // MM moves L by less than a hundredth of a nat then
    // The end is not the least: in a narrow view a variance along the rays that nothing holds grows, and what the prior
    // of the shape draws from it raises those that are seen, and with them L by nats.
    double least = std::numeric_limits<double>::infinity();
    Noise noise = isotropic(start.a, start.b);
    NoiseFit fit(data, {noise, kind}, true);
    for (int k = 0; k < ROUNDS; ++k) {
        const RaySums sums = rayPass(data, pose, noise, {LeverArm::CORRECTED, NO_PRODUCTS, fit.residuals()});
        least = std::min(least, sums.L);
        noise = fit.next(noise, sums, pose.R, NoiseStep::MM);
    }
    return least;
}

// What speaks against a minimum of isotropic noise, and nothing but the minimum decides; infinite where it is no pose.
double costOf(const Correspondences& data, const Pose& minimum)
{
    const RaySums sums = rayPass(data, minimum, UNIT);
    if (!minimum.t.allFinite() || !determined(sums.H) || 2 * sums.inFront <= data.size())
        return std::numeric_limits<double>::infinity();
    const IsotropicSplit split = splitResiduals(data, minimum);
    const auto cost = [&](NoiseKind kind, const IsotropicNoise& start) {
        return fittedCost(data, minimum, kind, start) + penaltyOf(kind) + priorCost(kind, split);
    };
    return std::min({cost(NoiseKind::OBJECT, split.object), cost(NoiseKind::BEARING, split.bearing),
                     cost(NoiseKind::BOTH, split.both)});
}

}  // namespace

double aboveSearch(const Problem& problem, const Pose& pose, int starts)
{
    const Correspondences data(problem.points, problem.rays);
    if (data.degenerate())
        return 0;
    const Pose found = data.fromObject(pose);
    const Descent own = descend(data, found);
    const Pose ours = own.ended ? own.pose : found;
    const double cost = costOf(data, ours);
    double best = cost;
    cv::RNG rng = experiments::trialRng("search", problem.n, 0);
    std::vector<Pose> minima = {ours};
    for (int k = 0; k < starts; ++k) {
        const Descent other = descend(data, withTranslation(data, synthetic::randomRotation(rng)));
        const auto isThat = [&](const Pose& known) { return near(known, other.pose); };
        if (!other.ended || std::any_of(minima.begin(), minima.end(), isThat))
            continue;
        minima.push_back(other.pose);
        best = std::min(best, costOf(data, other.pose));
    }
    return cost - best;
}

}  // namespace reliability
