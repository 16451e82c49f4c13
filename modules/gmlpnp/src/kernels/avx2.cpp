// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

// Four points at a time. The build compiles this file alone for AVX2 and FMA; dispatch.cpp asks the machine before it
// calls anything of it.

#if defined(__GNUC__) && defined(__AVX2__) && defined(__FMA__)
#define GMLPNP_LANES 4
#endif
#define GMLPNP_RAY_KERNELS RAY_KERNELS_AVX2
#define GMLPNP_RAY_KERNELS_NAME "avx2"
#include "vector.hpp"
