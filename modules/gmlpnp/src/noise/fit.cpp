// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "fit.hpp"
#include "model.hpp"
#include "scoring.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

namespace {

bool isIsotropic(const Noise& noise)
{
    const auto isScalar = [](const Matrix3d& C) { return (C - C(0, 0) * Matrix3d::Identity()).isZero(0); };
    return isScalar(noise.Sigma) && isScalar(noise.Gamma);
}

}  // namespace

NoiseFit::NoiseFit(const Correspondences& data, const NoiseStart& start, bool tails)
    : kind_(start.kind),
      n_(data.size()),
      tailsFitted_(tails),
      shaped_(!isIsotropic(start.noise)),
      c_(tails ? data.size() : 0),
      tails_(data.hasKnown() || isConstant(start.kind) || start.otherKnown, data.size())
{}

bool NoiseFit::addWildTails(Noise& noise, const RaySums& sums)
{
    if (!tailsFitted_ || shaped_ || !tails_.areWild(sums))
        return false;
    tails_.update(noise, c_.data(), sums);
    return true;
}

Noise NoiseFit::next(const Noise& now, const RaySums& sums, const Matrix3d& R, NoiseStep step)
{
    Noise next = step == NoiseStep::MM ? updatedNoise(kind_, now, sums, R, n_) : scoredNoise(kind_, now, sums, R);
    if (tailsFitted_ && std::exchange(shaped_, true))
        tails_.update(next, c_.data(), sums);
    return next;
}

double costWithNoiseFitted(const Correspondences& data, const Pose& pose, const NoiseStart& start, bool tails)
{
    constexpr int ROUNDS = 20;
    constexpr double TOLERANCE = 0.1;  // nat a round
    const int fewest = tails ? 2 : 1;  // tails are not looked for before
    NoiseFit fit(data, start, tails);
    Noise noise = start.noise;
    double L = std::numeric_limits<double>::infinity();
    for (int round = 0;; ++round) {
        const RaySums sums = rayPass(data, pose, noise, {LeverArm::CORRECTED, NO_PRODUCTS, fit.residuals()});
        const double last = std::exchange(L, sums.L);
        if (round == ROUNDS || (round >= fewest && std::abs(last - L) < TOLERANCE))
            return L;
        noise = fit.next(noise, sums, pose.R, NoiseStep::MM);
    }
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
