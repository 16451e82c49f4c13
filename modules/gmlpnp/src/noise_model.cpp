// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "precomp.hpp"

#include "noise_model.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

Matrix3d publishedUpdate(const Matrix3d& C, const Matrix3d& Z, int n)
{
    return symmetrised(C * Z * C) / n;
}

Matrix3d emUpdate(const Matrix3d& C, const Matrix3d& Z, const Matrix3d& G, int n)
{
    return symmetrised(C + C * (Z - G) * C / n);
}

Matrix3d mmUpdate(const Matrix3d& C, const Matrix3d& Z, const Matrix3d& G)
{
    // A narrow view does not observe the direction of the rays: G is nearly singular there.
    constexpr double OBSERVED = 1e-12;
    const Matrix3d rootG = squareRoot(floored(G, OBSERVED));
    const Matrix3d inverseRootG = rootG.inverse();
    return symmetrised(inverseRootG * squareRoot(symmetrised(rootG * C * Z * C * rootG)) * inverseRootG);
}

Matrix3d regular(const Matrix3d& C, double relative)
{
    return floored(C, relative) + NOISE_FLOOR * NOISE_FLOOR * Matrix3d::Identity();
}

Matrix3d shrunk(const Matrix3d& C, double n, double kappa)
{
    const double mean = C.trace() / 3;
    const Matrix3d drawn = (n * C + kappa * mean * Matrix3d::Identity()) / (n + kappa);
    return regular(drawn, RELATIVE_FLOOR);
}

namespace {

constexpr int SPLIT_REWEIGHTINGS = 4;
constexpr double SPLIT_FLOOR = 1e-3;  // smallest share of a noise in the split, of what it would be alone

struct Line
{
    double a, b;
};

// Weighted least squares of y on a + b x, both coefficients at least their floors: where one is not, it is set there
// and the other refitted; left alone, the sum comes out 2-3 times too large at nearly equal depths.
Line fitLine(const Eigen::ArrayXd& x, const Eigen::ArrayXd& y, const Line& before, const Line& floor)
{
    const Eigen::ArrayXd w = (before.a + before.b * x).square().inverse();
    const double W = w.sum(), Wx = (w * x).sum(), Wxx = (w * x * x).sum(), Wy = (w * y).sum(), Wxy = (w * x * y).sum();
    const double det = W * Wxx - Wx * Wx;
    const bool equalDepths = !(det > 1e-9 * W * Wxx);
    Line line = equalDepths ? Line{Wy / W, 0} : Line{(Wxx * Wy - Wx * Wxy) / det, (W * Wxy - Wx * Wy) / det};
    if (line.b < floor.b)
        line = {std::max((Wy - floor.b * Wx) / W, floor.a), floor.b};
    else if (line.a < floor.a)
        line = {floor.a, std::max((Wxy - floor.a * Wx) / Wxx, floor.b)};
    return line;
}

}  // namespace

ResidualSplit splitResiduals(const Correspondences& data, const Pose& pose)
{
    const int n = data.size();
    Eigen::ArrayXd depth2(n), residual2(n);
    for (int i = 0; i < n; ++i) {
        const Vector3d X = pose * data.pointAt(i), m = data.rayAt(i);
        const double s = m.dot(X);
        depth2(i) = std::max(s * s, NOISE_FLOOR);
        residual2(i) = 0.5 * m.cross(X).squaredNorm() + NOISE_FLOOR * NOISE_FLOOR;
    }
    const double aOnly = residual2.mean(), bOnly = (residual2 / depth2).mean();
    Line line{aOnly / 2, bOnly / 2};
    for (int k = 0; k < SPLIT_REWEIGHTINGS; ++k)
        line = fitLine(depth2, residual2, line, {SPLIT_FLOOR * aOnly, SPLIT_FLOOR * bOnly});
    const double freedom = 2. * n / std::max(2 * n - 6, 1);  // the pose took six of the 2n residual coordinates
    return {freedom * line.a, freedom * line.b, freedom * aOnly, freedom * bOnly, depth2.mean()};
}

namespace {

// Degrees of freedom tried: 32 down to 2 in steps of sqrt(2).
constexpr int TAIL_COUNT = 9;
constexpr double TAIL_FIRST = 32;

double degreesOfFreedom(double step)
{
    return TAIL_FIRST * std::pow(2, -step / 2);
}

// The parts of L that depend on nu, for each candidate; the last entry is the Gaussian's.
std::array<double, TAIL_COUNT + 1> tailCosts(const Correspondences& data, const Pose& pose, const Noise& noise)
{
    std::array<double, TAIL_COUNT> nu;
    for (int k = 0; k < TAIL_COUNT; ++k)
        nu[k] = degreesOfFreedom(k);
    std::array<double, TAIL_COUNT + 1> costs{};
    for (int i = 0; i < data.size(); ++i) {
        const double c = pointTerms(data, i, pose, noise).c;
        for (int k = 0; k < TAIL_COUNT; ++k)
            costs[k] += 0.5 * (nu[k] + 2) * std::log1p(c / nu[k]);
        costs[TAIL_COUNT] += 0.5 * c;
    }
    return costs;
}

// Score test for tails heavier than Gaussian: dL/d(1/nu) at 1/nu = 0 is  sum (c - c^2/4); with the scale fitted too its
// variance is 4 n, so this much of it promises a gain of TAIL_PENALTY.
bool mayHaveTails(const RaySums& sums, int n)
{
    return sums.c2 / 4 - 2 * sums.c + 2 * n > std::sqrt(8 * TAIL_PENALTY * n);
}

}  // namespace

double updatedTail(const Correspondences& data, const Pose& pose, const Noise& noise, const RaySums& sums)
{
    if (noise.tail == 0 && !mayHaveTails(sums, data.size()))
        return 0;
    const std::array<double, TAIL_COUNT + 1> costs = tailCosts(data, pose, noise);
    const int k = static_cast<int>(std::min_element(costs.begin(), costs.end() - 1) - costs.begin());
    if (!(costs[k] + TAIL_PENALTY < costs[TAIL_COUNT]))
        return 0;
    if (k == 0 || k == TAIL_COUNT - 1)
        return 1 / degreesOfFreedom(k);
    // The parabola through the neighbours, in log nu.
    const double left = costs[k - 1] - costs[k], right = costs[k + 1] - costs[k];
    return 1 / degreesOfFreedom(k + 0.5 * (left - right) / (left + right));
}

Noise updatedNoise(NoiseKind kind, const Noise& noise, const RaySums& sums, const Matrix3d& R, int n)
{
    Noise next = noise;
    if (isConstant(kind))
        return next;
    const auto toObject = [&R](const Matrix3d& M) { return Matrix3d(R.transpose() * M * R); };
    if (kind == NoiseKind::PUBLISHED) {
        next.Sigma = regular(publishedUpdate(noise.Sigma, toObject(sums.Zo), n), TINY_FLOOR);
        return next;
    }
    if (kind != NoiseKind::BEARING)
        next.Sigma = shrunk(mmUpdate(noise.Sigma, toObject(sums.Zo), toObject(sums.Go)), n, SHRINKAGE);
    if (kind != NoiseKind::OBJECT)
        next.Gamma = shrunk(mmUpdate(noise.Gamma, sums.Zb, sums.Gb), n, SHRINKAGE);
    return next;
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
