// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_RANSAC_REPEATS_HPP
#define OPENCV_GMLPNP_RANSAC_REPEATS_HPP

#include "../rays/correspondences.hpp"
#include "metric.hpp"

#include <cstring>

namespace cv {
namespace gmlpnp {
namespace detail {

/** The different ones among the points or rays of a problem, each looked up in constant time (open addressing), as
RANSAC asks for all of them. It holds their rows alone: at a hundred thousand points fresh memory is what costs. */
template <Vector3d (Correspondences::*at)(int) const>
class Distinct
{
public:
    /** @param most rows that will be added; `data` must live as long. */
    Distinct(const Correspondences& data, int most) : data_(data)
    {
        size_t size = 2;
        while (size < 2 * static_cast<size_t>(most))
            size *= 2;
        slots_.assign(size, EMPTY);
    }

    int count() const { return count_; }

    /** Whether one equal to that of row i was added. */
    bool has(int i) const { return slots_[slotOf(i)] != EMPTY; }

    /** @return the first row added that is equal to row i. */
    int add(int i)
    {
        int& slot = slots_[slotOf(i)];
        if (slot == EMPTY) {
            slot = i;
            ++count_;
        }
        return slot;
    }

private:
    static constexpr int EMPTY = -1;

    static uint64 hashOf(const Vector3d& value)
    {
        uint64 hash = 0;
        for (int k = 0; k < 3; ++k) {
            const double entry = value(k) + 0.;  // -0 is 0
            uint64 bits;
            std::memcpy(&bits, &entry, sizeof bits);
            hash = (hash ^ bits) * 0x9E3779B97F4A7C15u;  // 2^64 over the golden ratio: Fibonacci hashing
            hash ^= hash >> 32;
        }
        return hash;
    }

    // That of row i, or the empty one where it belongs.
    size_t slotOf(int i) const
    {
        const Vector3d value = (data_.*at)(i);
        const size_t mask = slots_.size() - 1;
        size_t slot = static_cast<size_t>(hashOf(value)) & mask;
        while (slots_[slot] != EMPTY && (data_.*at)(slots_[slot]) != value)
            slot = (slot + 1) & mask;
        return slot;
    }

    const Correspondences& data_;
    std::vector<int> slots_;  // a power of two of them, at most half of them taken
    int count_ = 0;
};

using DistinctPoints = Distinct<&Correspondences::pointAt>;
using DistinctRays = Distinct<&Correspondences::scaledRayAt>;

/** Rows of which none repeats another: of matches of one object point to nearly the same ray only the first. They are
inliers together, so a search among all of them takes the most repeated for the most agreed with. Object points near
each other are different ones, however near.
@param metrics one a row.
@return none where no row repeats another. */
CV_EXPORTS std::vector<int> withoutRepeats(const Correspondences& data, const std::vector<Metric>& metrics);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_RANSAC_REPEATS_HPP
