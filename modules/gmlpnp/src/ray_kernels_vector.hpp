// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

// Included by the source files with vectors: GMLPNP_LANES doubles in one, by the vector extension of GCC and Clang.

#include "ray_kernels.simd.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {
namespace {

using Doubles __attribute__((vector_size(8 * GMLPNP_LANES))) = double;
using Words __attribute__((vector_size(8 * GMLPNP_LANES))) = unsigned long long;

template <>
struct Lanes<Doubles>
{
    using Bits = Words;
    static constexpr int COUNT = GMLPNP_LANES;
    static GMLPNP_INLINE Doubles spread(double x) { return x - Doubles{}; }
    static GMLPNP_INLINE Words bits(Doubles x) { return reinterpret_cast<Words>(x); }
    static GMLPNP_INLINE Doubles number(Words b) { return reinterpret_cast<Doubles>(b); }
    static GMLPNP_INLINE Doubles squareRoot(Doubles x)
    {
        for (int k = 0; k < COUNT; ++k)  // one instruction, as the build says that nobody reads errno
            x[k] = std::sqrt(x[k]);
        return x;
    }
    static GMLPNP_INLINE double sum(Doubles x)
    {
        double total = 0;
        for (int k = 0; k < COUNT; ++k)
            total += x[k];
        return total;
    }
    static GMLPNP_INLINE double product(Doubles x)
    {
        double total = 1;
        for (int k = 0; k < COUNT; ++k)
            total *= x[k];
        return total;
    }
    static GMLPNP_INLINE unsigned long long sumBits(Words b)
    {
        unsigned long long total = 0;
        for (int k = 0; k < COUNT; ++k)
            total += b[k];
        return total;
    }
};

}  // namespace
}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
