// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

// Four points at a time with the 32 registers of AVX-512VL. Eight points were slower where it was measured
// (doc/lab/performance.md, "Instruction sets"). The build compiles this file alone for AVX-512; dispatch.cpp asks the
// machine before it calls anything of it.

#if defined(__GNUC__) && defined(__AVX512VL__) && defined(__AVX512DQ__) && defined(__FMA__)
#define GMLPNP_LANES 4
#endif
#define GMLPNP_RAY_KERNELS RAY_KERNELS_AVX512
#define GMLPNP_RAY_KERNELS_NAME "avx512"
#include "vector.hpp"
