// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

// Four points at a time. The build compiles this file alone for AVX2 and FMA; ray_pass.cpp asks the machine first.

#if defined(__GNUC__) && defined(__AVX2__) && defined(__FMA__)
#define GMLPNP_LANES 4
#include "vector.hpp"
#else
#include "kernels.hpp"
#endif

namespace cv {
namespace gmlpnp {
namespace detail {

#ifdef GMLPNP_LANES
const RayKernels RAY_KERNELS_AVX2 = kernelsOf<Doubles>("avx2");
#else
const RayKernels RAY_KERNELS_AVX2 = {};  // not available
#endif

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
