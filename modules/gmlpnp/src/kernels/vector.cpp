// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

// Two points at a time: what SSE2 and NEON have on every machine of their kind.

#if defined(__GNUC__)
#define GMLPNP_LANES 2
#include "vector.hpp"
#else
#include "kernels.hpp"
#endif

namespace cv {
namespace gmlpnp {
namespace detail {

#ifdef GMLPNP_LANES
const RayKernels RAY_KERNELS_VECTOR = kernelsOf<Doubles>("vector");
#else
const RayKernels RAY_KERNELS_VECTOR = {};  // not available
#endif

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
