// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_SAMPLES_IMAGES_HPP
#define GMLPNP_SAMPLES_IMAGES_HPP

#include <string>

#include <opencv2/core.hpp>

namespace samples {

/** cv::imread. @throws std::runtime_error naming the file where it cannot be read. */
cv::Mat readImage(const std::string& path, int flags);

/** In the format of the extension, as files::writeFile(). @throws std::runtime_error naming the file where it cannot be
 * written. */
void writeImage(const std::string& path, const cv::Mat& image);

}  // namespace samples

#endif  // GMLPNP_SAMPLES_IMAGES_HPP
