// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "kinds.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

namespace {

/** Object noise in a model of bearing noise alone, as a share of the variance at mean depth. A point at the very centre
of projection must not weigh infinitely. */
constexpr double BEARING_ONLY_SHARE = 1e-6;

constexpr int SPLIT_REWEIGHTINGS = 4;
constexpr double SPLIT_FLOOR = 1e-3;  // smallest share of a noise, relative to its value without the other one

struct Line
{
    double a, b;
};

// Weighted least squares of y on a + b x with both coefficients at least their floors. A coefficient below its floor is
// set there and the other one is fitted again: otherwise the sum comes out 2 to 3 times too large at nearly equal
// depths.
Line fitLine(const LineSums& s, const Line& floor)
{
    const double det = s.w * s.wxx - s.wx * s.wx;
    const bool equalDepths = !(det > 1e-9 * s.w * s.wxx);
    const Line line = equalDepths ? Line{s.wy / s.w, 0}
                                  : Line{(s.wxx * s.wy - s.wx * s.wxy) / det, (s.w * s.wxy - s.wx * s.wy) / det};
    if (line.b < floor.b)
        return {std::max((s.wy - floor.b * s.wx) / s.w, floor.a), floor.b};
    if (line.a < floor.a)
        return {floor.a, std::max((s.wxy - floor.a * s.wx) / s.wxx, floor.b)};
    return line;
}

// s^2 and 1/2 |v|^2 of each point.
struct Residuals
{
    Eigen::ArrayXd x, y;

    LineSums sums(double a, double b) const
    {
        LineSums out;
        const int n = static_cast<int>(x.size());
        rayKernels(n).line(x.data(), y.data(), n, a, b, out);
        return out;
    }
    // L of isotropic noises: D = (a + b s^2)^2, c = |v|^2 / (a + b s^2).
    IsotropicNoise withCost(double a, double b) const
    {
        const LineSums at = sums(a, b);
        return {a, b, logarithm(at.variance) + at.misfit};
    }
};

Residuals residualsAt(const Correspondences& data, const Pose& pose)
{
    Residuals out{Eigen::ArrayXd(data.size()), Eigen::ArrayXd(data.size())};
    rayKernels(data.size()).residuals(data.arrays(), entriesOf(pose).data(), out.x.data(), out.y.data());
    out.x = out.x.max(NOISE_FLOOR);
    out.y += NOISE_FLOOR * NOISE_FLOOR;
    return out;
}

}  // namespace

IsotropicSplit splitResiduals(const Correspondences& data, const Pose& pose)
{
    const int n = data.size();
    const Residuals of = residualsAt(data, pose);
    const double aOnly = of.y.mean(), bOnly = (of.y / of.x).mean(), meanDepth2 = of.x.mean();
    Line line{aOnly / 2, bOnly / 2};
    for (int k = 0; k < SPLIT_REWEIGHTINGS; ++k)
        line = fitLine(of.sums(line.a, line.b), {SPLIT_FLOOR * aOnly, SPLIT_FLOOR * bOnly});
    const double f = restriction(n);
    return {of.withCost(f * aOnly, 0), of.withCost(f * BEARING_ONLY_SHARE * bOnly * meanDepth2, f * bOnly),
            of.withCost(f * line.a, f * line.b), meanDepth2, of.x.square().mean() / (meanDepth2 * meanDepth2) - 1};
}

double penaltyOf(NoiseKind kind)
{
    constexpr double TWO_NOISES = 2;
    return kind == NoiseKind::BOTH ? TWO_NOISES : 0;
}

double priorCost(NoiseKind kind, const IsotropicSplit& split)
{
    // The first is in nats, the second the relative variance of s^2 at which the data begin to tell. Fitted: without
    // the prior a cube of 30 px at 100 points comes out .28 deviations too near. Held by scripts/figures.sh
    // consistency.
    constexpr double COMPACT_PRIOR = 8, COMPACT = 0.02;
    return kind == NoiseKind::OBJECT ? COMPACT_PRIOR * std::exp(-split.depth2Variance / COMPACT) : 0;
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
