// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

// Four points at a time with the 32 registers of AVX-512VL; eight were slower where it was measured
// (doc/performance.md). The build compiles this file alone for AVX-512; ray_pass.cpp asks the machine first.

#if defined(__GNUC__) && defined(__AVX512VL__) && defined(__AVX512DQ__) && defined(__FMA__)
#define GMLPNP_LANES 4
#include "vector.hpp"
#else
#include "kernels.hpp"
#endif

namespace cv {
namespace gmlpnp {
namespace detail {

#ifdef GMLPNP_LANES
const RayKernels RAY_KERNELS_AVX512 = kernelsOf<Doubles>("avx512");
#else
const RayKernels RAY_KERNELS_AVX512 = {};  // not available
#endif

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
