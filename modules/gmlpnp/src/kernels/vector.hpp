// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

// The kernels of an instruction set with vectors, by the vector extension of GCC and Clang. The source file of each
// instruction set includes this header once and defines for it
//
//   GMLPNP_RAY_KERNELS       the name of its RayKernels
//   GMLPNP_RAY_KERNELS_NAME  the same for people, a string
//   GMLPNP_LANES             how many doubles a vector has; undefined where the compiler lacks the instructions

#ifdef GMLPNP_LANES

#include "loops.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {
namespace {

template <int COUNT>
struct Vector
{
    using Doubles __attribute__((vector_size(8 * COUNT))) = double;
    using Integers __attribute__((vector_size(8 * COUNT))) = long long;
    using Words __attribute__((vector_size(8 * COUNT))) = unsigned long long;
};

template <int N>
struct VectorLanes
{
    using Doubles = typename Vector<N>::Doubles;
    using Integers = typename Vector<N>::Integers;
    using Bits = typename Vector<N>::Words;
    static constexpr int COUNT = N;

    // Returns a mask of all ones from this lane on.
    static GMLPNP_INLINE Bits from(int lane)
    {
        Integers number{};
        for (int k = 0; k < N; ++k)
            number[k] = k;
        return reinterpret_cast<Bits>(number >= lane);
    }
    static GMLPNP_INLINE Doubles spread(double x) { return x - Doubles{}; }
    static GMLPNP_INLINE Bits bits(Doubles x) { return reinterpret_cast<Bits>(x); }
    static GMLPNP_INLINE Doubles number(Bits b) { return reinterpret_cast<Doubles>(b); }
    static GMLPNP_INLINE Doubles squareRoot(Doubles x)
    {
        for (int k = 0; k < COUNT; ++k)  // becomes one instruction, because the build says that nobody reads errno
            x[k] = std::sqrt(x[k]);
        return x;
    }
    static GMLPNP_INLINE double sum(Doubles x)
    {
        if constexpr (N > 2)
            return VectorLanes<N / 2>::sum(half<typename Vector<N / 2>::Doubles>(x, 0) +
                                           half<typename Vector<N / 2>::Doubles>(x, 1));
        else
            return x[0] + x[1];
    }
    static GMLPNP_INLINE double product(Doubles x)
    {
        double total = 1;
        for (int k = 0; k < COUNT; ++k)
            total *= x[k];
        return total;
    }
    static GMLPNP_INLINE unsigned long long sumBits(Bits b)
    {
        unsigned long long total = 0;
        for (int k = 0; k < COUNT; ++k)
            total += b[k];
        return total;
    }

private:
    template <class Half>
    static GMLPNP_INLINE Half half(Doubles x, size_t which)
    {
        Half out;
        std::memcpy(&out, reinterpret_cast<const char*>(&x) + which * sizeof out, sizeof out);
        return out;
    }
};

using Doubles = Vector<GMLPNP_LANES>::Doubles;

template <>
struct Lanes<Doubles> : VectorLanes<GMLPNP_LANES>
{};

}  // namespace

const RayKernels GMLPNP_RAY_KERNELS = kernelsOf<Doubles>(GMLPNP_RAY_KERNELS_NAME);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#else

#include "kernels.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

const RayKernels GMLPNP_RAY_KERNELS = {};  // not available

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif
