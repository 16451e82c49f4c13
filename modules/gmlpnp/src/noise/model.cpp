// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "model.hpp"

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
    // A narrow view does not observe the direction of the rays, few points do not observe every direction.
    constexpr double OBSERVED = 1e-12;
    const Matrix3d CZC = symmetrised(C * Z * C);
    return CZC.trace() > 0 ? geometricMean(lifted(CZC, OBSERVED), lifted(G, OBSERVED)) : Matrix3d::Zero();
}

Matrix3d acceleratedMm(const Matrix3d& C, const Matrix3d& Z, const Matrix3d& G)
{
    const Matrix3d next = mmUpdate(C, Z, G);
    return symmetrised(next * inverse(C) * next);
}

Matrix3d regular(const Matrix3d& C, double relative)
{
    return lifted(C, relative) + NOISE_FLOOR * NOISE_FLOOR * Matrix3d::Identity();
}

Matrix3d shrunk(const Matrix3d& C, double n, double kappa)
{
    const double mean = C.trace() / 3;
    return regular((n * C + kappa * mean * Matrix3d::Identity()) / (n + kappa), 0);
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
    const double f = freedom(n);
    return {of.withCost(f * aOnly, 0), of.withCost(f * BEARING_ONLY_SHARE * bOnly * meanDepth2, f * bOnly),
            of.withCost(f * line.a, f * line.b), meanDepth2, of.x.square().mean() / (meanDepth2 * meanDepth2) - 1};
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
    // A step twice as long meets twice the pull towards isotropy, so that they balance where they did.
    constexpr double PULL = 2 * SHRINKAGE;
    if (kind != NoiseKind::BEARING)
        next.Sigma = shrunk(acceleratedMm(noise.Sigma, toObject(sums.Zo), toObject(sums.Go)), n, PULL);
    if (kind != NoiseKind::OBJECT)
        next.Gamma = shrunk(acceleratedMm(noise.Gamma, sums.Zb, sums.Gb), n, PULL);
    return next;
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
