// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_MATH_LIMITS_HPP
#define OPENCV_GMLPNP_MATH_LIMITS_HPP

namespace cv {
namespace gmlpnp {
namespace detail {

// Limits that the range of doubles sets to input, whatever its unit. A double ends at 1.8e308 and, with all its digits,
// begins at 2.2e-308; the mathematics behind a limit squares and multiplies, and must stay within that range.

/** Largest entry of a covariance [length^2, rad^2 or px^2]. Its fourth power and determinants stay finite. */
constexpr double LARGEST_COVARIANCE = 1e60;

/** Largest extent of an object and largest coordinate of a guess [length, rad]. Sums of squares would be finite up to
1e150; covariances in the caller's unit need room as well. */
constexpr double LARGEST_LENGTH = 1e100;

/** Smallest extent of an object [length]. Nothing would be left of the covariances of a smaller one. */
constexpr double SMALLEST_LENGTH = 1e-100;

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_MATH_LIMITS_HPP
