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

/** The set of different points, or of different rays, of a problem. A lookup takes constant time (open addressing),
because RANSAC looks up all of them. The set holds rows alone, because at a hundred thousand points fresh memory takes
most of the time. */
template <Vector3d (Correspondences::*at)(int) const>
class Distinct
{
public:
    /** @param data the problem; it must live as long as the set.
    @param most the most rows that will be added. */
    Distinct(const Correspondences& data, int most) : data_(data)
    {
        size_t size = 2;
        while (size < 2 * static_cast<size_t>(most))
            size *= 2;
        slots_.assign(size, EMPTY);
    }

    /** Returns the number of different ones that were added. */
    int count() const { return count_; }

    /** Says whether a row equal to row i was added. */
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
            const double entry = value(k) + 0.;  // adding zero makes -0 equal to 0
            uint64 bits;
            std::memcpy(&bits, &entry, sizeof bits);
            hash = (hash ^ bits) * 0x9E3779B97F4A7C15u;  // mathematics: 2^64 over the golden ratio (Fibonacci hashing)
            hash ^= hash >> 32;
        }
        return hash;
    }

    // Returns the slot of row i, or the empty slot where it belongs.
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
    std::vector<int> slots_;  // their number is a power of two; at most half of them are taken
    int count_ = 0;
};

using DistinctPoints = Distinct<&Correspondences::pointAt>;
using DistinctRays = Distinct<&Correspondences::scaledRayAt>;

/** Returns the rows without repeats: of rows that repeat each other only the first. A row repeats another if it matches
the same object point to nearly the same ray. Such rows are inliers together, so a search among all rows would prefer
the pose of the most repeated one. Object points that differ at all are different ones, however near they are.
@param data correspondences.
@param metrics the metric of each row.
@return rows in ascending order; empty where no row repeats another. */
CV_EXPORTS std::vector<int> withoutRepeats(const Correspondences& data, const std::vector<Metric>& metrics);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_RANSAC_REPEATS_HPP
