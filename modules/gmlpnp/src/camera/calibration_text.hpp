// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_CAMERA_CALIBRATION_TEXT_HPP
#define OPENCV_GMLPNP_CAMERA_CALIBRATION_TEXT_HPP

#include "../precomp.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

/** Turns the text of a calibration file (YAML, XML or JSON) into a form that cv::FileStorage can read.

It repairs three things that other programs write and cv::FileStorage does not take: a byte order mark, tabs, and YAML
without its first line. It refuses a text, or cuts it to its first document, where the parsers of OpenCV 4.6 are not
safe: on 2026-11-27 a fuzzer found damaged YAML from which they do not return and damaged XML for which they read from a
null pointer. The check is stricter than these faults, so that it depends on no detail of the parsers.
@throws cv::Exception StsParseError where the text is refused; a text that passes may still be no calibration. */
CV_EXPORTS String calibrationText(String text);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_CAMERA_CALIBRATION_TEXT_HPP
