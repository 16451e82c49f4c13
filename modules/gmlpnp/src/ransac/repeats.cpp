// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "repeats.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

namespace {

constexpr int NONE = -1;

// Says whether the ray of row i is within SAME_RAY thresholds of the ray of row j.
bool nearRay(const Correspondences& data, const std::vector<Metric>& metrics, int i, int j)
{
    // Statistics of detectors: the orientations of one keypoint are up to a pixel or two apart, a threshold is several.
    // Held by Gmlpnp_SolveRansac.oneWrongMatchManyTimesDoesNotOutvoteTheTrueOnes.
    constexpr double SAME_RAY = 0.25;
    const Vector3d ray = data.unitRayAt(i);
    const double s = ray.dot(data.unitRayAt(j));
    return s > 0 && (metrics[j] * ray).squaredNorm() <= SAME_RAY * SAME_RAY * s * s;
}

bool allDistinct(const Correspondences& data)
{
    DistinctPoints points(data, data.size());
    for (int i = 0; i < data.size(); ++i)
        if (points.add(i) != i)
            return false;
    return true;
}

}  // namespace

std::vector<int> withoutRepeats(const Correspondences& data, const std::vector<Metric>& metrics)
{
    if (allDistinct(data))
        return {};
    constexpr int MOST_COMPARED = 16;  // kept matches of a point: bounds the time where a point has thousands
    DistinctPoints points(data, data.size());
    // `last` holds the row that was kept last of each point. `before` holds, for each kept row, the row of the same
    // point that was kept before it.
    std::vector<int> last(data.size(), NONE), before(data.size(), NONE), kept;
    const auto repeats = [&](int row, int other) {
        for (int k = 0; k < MOST_COMPARED && other != NONE; ++k, other = before[other])
            if (nearRay(data, metrics, row, other))
                return true;
        return false;
    };
    for (int i = 0; i < data.size(); ++i) {
        int& newest = last[points.add(i)];
        if (repeats(i, newest))
            continue;
        before[i] = std::exchange(newest, i);
        kept.push_back(i);
    }
    return kept;
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
