// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_SAMPLES_RESIDUAL_PICTURE_HPP
#define GMLPNP_SAMPLES_RESIDUAL_PICTURE_HPP

#include <string>

#include "common/residuals.hpp"
#include "common/units.hpp"

namespace samples {

/** Draws the residuals with the ellipses that should hold 95 % of them: in the image, where residual and ellipse are
magnified alike, and in object space, in the x-y and the x-z plane of the camera frame. */
cv::Mat drawResiduals(const CorrespondenceSet& set, const std::vector<Residual>& residuals, const std::string& title,
                      const LengthUnit& unit);

/** Writes that picture, its title made of the set's name and the method's. @throws std::runtime_error where the file
cannot be written. */
void writeResiduals(const std::string& path, const CorrespondenceSet& set, const std::vector<Residual>& residuals,
                    const std::string& method);

}  // namespace samples

#endif  // GMLPNP_SAMPLES_RESIDUAL_PICTURE_HPP
