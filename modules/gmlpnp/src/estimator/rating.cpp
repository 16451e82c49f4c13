// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "../noise/tails.hpp"
#include "estimate.hpp"
#include "rating.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

namespace {

double fittedCost(const Correspondences& data, const Pose& pose, NoiseKind kind, const IsotropicNoise& start,
                  bool robust)
{
    const int fewest = robust ? 2 : 1;  // tails are not looked for before
    constexpr int ROUNDS = 20;
    constexpr double TOLERANCE = 0.1;  // nat a round
    std::vector<double> c(robust ? data.size() : 0);
    TailSearch tails(data.hasKnown(), data.size());
    Noise noise = isotropic(start.a, start.b);
    double L = std::numeric_limits<double>::infinity();
    for (int round = 0;; ++round) {
        const RaySums sums =
            rayPass(data, pose, noise, {LeverArm::CORRECTED, NO_PRODUCTS, robust ? c.data() : nullptr});
        const double last = std::exchange(L, sums.L);
        if (round == ROUNDS || (round >= fewest && std::abs(last - L) < TOLERANCE))
            return L;
        noise = updatedNoise(kind, noise, sums, pose.R, data.size());
        if (robust && round > 0)  // anisotropy looks like tails
            tails.update(noise, c.data(), sums);
    }
}

}  // namespace

double costOfMinimum(const Correspondences& data, const Pose& minimum, bool robust)
{
    const IsotropicSplit split = splitResiduals(data, minimum);
    const auto cost = [&](NoiseKind kind, const IsotropicNoise& start) {
        const double against = fittedCost(data, minimum, kind, start, robust) + priorAgainst(kind, split);
        return std::isnan(against) ? std::numeric_limits<double>::infinity() : against;
    };
    return std::min(cost(NoiseKind::OBJECT, split.object), cost(NoiseKind::BEARING, split.bearing));
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
