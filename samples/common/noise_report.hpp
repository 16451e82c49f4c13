// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_SAMPLES_NOISE_REPORT_HPP
#define GMLPNP_SAMPLES_NOISE_REPORT_HPP

#include <ostream>

#include <opencv2/gmlpnp.hpp>

#include "common/units.hpp"

namespace samples {

/** Prints the estimated noise, as matrices and as principal standard deviations with their directions, and the
standard deviations of the pose. `focalLength` (px) turns bearing noise into pixels, `meanDepth` (the file's unit) into
lengths. */
void printNoise(std::ostream& out, const cv::gmlpnp::Result& result, const LengthUnit& unit, double focalLength,
                double meanDepth);

}  // namespace samples

#endif  // GMLPNP_SAMPLES_NOISE_REPORT_HPP
