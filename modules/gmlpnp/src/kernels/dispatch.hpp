// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_KERNELS_DISPATCH_HPP
#define OPENCV_GMLPNP_KERNELS_DISPATCH_HPP

#include "../precomp.hpp"
#include "kernels.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

/** Returns the loops of each instruction set that this machine has. The fastest come first, the scalar ones last. */
CV_EXPORTS const std::vector<const RayKernels*>& availableKernels();

/** Returns the fastest loops that have at most `points` lanes, because their blocks must be full. */
CV_EXPORTS const RayKernels& rayKernels(int points);

/** Returns the logarithm of a product that a kernel has multiplied up. */
CV_EXPORTS double logarithm(const ScaledProduct& product);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_KERNELS_DISPATCH_HPP
