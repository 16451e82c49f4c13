// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "loops.hpp"

// One point at a time. Every compiler can do this, and the tests compare the other kernels with it.

namespace cv {
namespace gmlpnp {
namespace detail {

const RayKernels RAY_KERNELS_SCALAR = kernelsOf<double>("scalar");

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
