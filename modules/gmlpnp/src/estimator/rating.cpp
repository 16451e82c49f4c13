// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "../noise/fit.hpp"
#include "rating.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

double costOfMinimum(const Correspondences& data, const Pose& minimum, bool tails)
{
    const IsotropicSplit split = splitResiduals(data, minimum);
    const auto costWith = [&](NoiseKind kind, const IsotropicNoise& start) {
        const double cost =
            costWithNoiseFitted(data, minimum, {isotropic(start.a, start.b), kind}, tails) + priorCost(kind, split);
        return std::isnan(cost) ? std::numeric_limits<double>::infinity() : cost;
    };
    return std::min(costWith(NoiseKind::OBJECT, split.object), costWith(NoiseKind::BEARING, split.bearing));
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
