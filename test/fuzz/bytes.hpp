// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_FUZZ_BYTES_HPP
#define GMLPNP_FUZZ_BYTES_HPP

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <limits>

namespace fuzz {

/** A fuzzer's input, taken from the front. Where it has ended all is zero, and zero chooses the ordinary: the empty
input is a plain problem, and every byte may spoil it. */
class Bytes
{
public:
    Bytes(const uint8_t* data, size_t size) : next_(data), left_(size) {}

    bool empty() const { return left_ == 0; }

    template <class T>
    T take()
    {
        T value{};
        const size_t count = std::min(sizeof value, left_);
        if (count > 0)
            std::memcpy(&value, next_, count);
        next_ += count;
        left_ -= count;
        return value;
    }

    //! From low to high, at most 256 of them, from one byte.
    int between(int low, int high) { return low + take<uint8_t>() % (high - low + 1); }

    bool flip() { return (take<uint8_t>() & 1) != 0; }

    //! The first of the list is the ordinary one.
    template <class T>
    T pick(std::initializer_list<T> list)
    {
        return list.begin()[take<uint8_t>() % list.size()];
    }

    //! Any double: those that break things, round ones, or eight bytes as they come.
    double number()
    {
        using Limits = std::numeric_limits<double>;
        const int kind = between(0, 31);
        if (kind < 16)
            return kind < 8 ? take<int8_t>() / 16.0 : take<int16_t>();
        if (kind >= 28)
            return take<double>();
        const double special[] = {Limits::quiet_NaN(),
                                  Limits::infinity(),
                                  -Limits::infinity(),
                                  Limits::denorm_min(),
                                  Limits::min(),
                                  Limits::max(),
                                  Limits::lowest(),
                                  -0.0,
                                  1e-160,
                                  1e160,
                                  1e9,
                                  -1e-9};
        return special[kind - 16];
    }

private:
    const uint8_t* next_;
    size_t left_;
};

}  // namespace fuzz

#endif  // GMLPNP_FUZZ_BYTES_HPP
