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

// Whether the ray of row i is within NEAR thresholds of that of row j.
bool nearRay(const Correspondences& data, const std::vector<Metric>& metrics, int i, int j)
{
    constexpr double NEAR = 0.25;  // orientations of one keypoint are up to a pixel or two apart, thresholds several
    const Vector3d ray = data.unitRayAt(i);
    const double s = ray.dot(data.unitRayAt(j));
    return s > 0 && (metrics[j] * ray).squaredNorm() <= NEAR * NEAR * s * s;
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
    constexpr int LOOKED_AT = 16;  // matches of a point: a bound on the time where one has thousands
    DistinctPoints points(data, data.size());
    // Of each point the row that was kept last, of each row the one of its point that was kept before it.
    std::vector<int> last(data.size(), NONE), before(data.size(), NONE), kept;
    const auto repeats = [&](int row, int other) {
        for (int k = 0; k < LOOKED_AT && other != NONE; ++k, other = before[other])
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
