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
    // A narrow view does not observe the direction of the rays. Few points do not observe every direction.
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
    // A step twice as long needs twice the pull towards isotropy: the two then balance where they did.
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
