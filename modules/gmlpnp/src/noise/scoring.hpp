// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_NOISE_SCORING_HPP
#define OPENCV_GMLPNP_NOISE_SCORING_HPP

#include "kinds.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

/** Sums of products of Q that scoring needs for this kind. There are none for both noises at once: their expected
curvature is far from the true one where depths hardly differ. */
Products productsFor(NoiseKind kind);

/** The noise of the next round by Fisher scoring. The kind is OBJECT or BEARING, and `sums` hold its products. */
CV_EXPORTS Noise scoredNoise(NoiseKind kind, const Noise& noise, const RaySums& sums, const Matrix3d& R);

/** tr(A E) of the six symmetric unit matrices E (xx xy xz yy yz zz), whose two entries are 1. */
Vector6d againstUnits(const Matrix3d& A);

/** sum 1/2 tr(Q E Q E') over all pairs of units, from RaySums::QQ. This is the expected curvature of L. */
Matrix6d curvature(const Matrix6d& QQ);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_NOISE_SCORING_HPP
