// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

// Two points at a time: SSE2 and NEON have these instructions on every machine of their kind.

#if defined(__GNUC__)
#define GMLPNP_LANES 2
#endif
#define GMLPNP_RAY_KERNELS RAY_KERNELS_VECTOR
#define GMLPNP_RAY_KERNELS_NAME "vector"
#include "vector.hpp"
