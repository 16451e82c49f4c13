// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_SAMPLES_COMPARISON_PICTURE_HPP
#define GMLPNP_SAMPLES_COMPARISON_PICTURE_HPP

#include "common/comparison.hpp"

namespace samples {

/** For each quantity the share of all pairs, failed ones among them, whose error is below the abscissa: one curve a
method, the higher the better. */
cv::Mat drawComparison(const Comparison& comparison, const std::string& title);

}  // namespace samples

#endif  // GMLPNP_SAMPLES_COMPARISON_PICTURE_HPP
