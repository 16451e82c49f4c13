// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_SAMPLES_AXES_HPP
#define GMLPNP_SAMPLES_AXES_HPP

#include <string>

#include "common/canvas.hpp"

namespace samples {

/** An affine map, per axis, from what is drawn to the picture. */
struct Map
{
    cv::Point2d origin, centre;  //!< `centre` is drawn at `origin`
    cv::Point2d scale;           //!< px of the picture per unit

    cv::Point2d operator()(cv::Point2d p) const
    {
        return {origin.x + scale.x * (p.x - centre.x), origin.y + scale.y * (p.y - centre.y)};
    }
};

/** Fits what is drawn into an area of the picture: centred, equal scale on both axes, y downward as in an image. */
Map fit(const cv::Rect2d& what, const cv::Rect2d& area);

//! As fit() with y upward, as on a map.
Map fitUpward(const cv::Rect2d& what, const cv::Rect2d& area);

/** Fills an area of the picture: each axis has its own scale, y upward as in a graph. */
Map fill(const cv::Rect2d& what, const cv::Rect2d& area);

/** The largest of 1, 2, 5 times a power of ten that is not above the value. */
double roundStep(double value);

/** Ticks at round numbers along the lower and the left edge of a frame, with faint lines across. */
void drawAxes(Canvas& canvas, const Map& map, const cv::Rect2d& frame, const std::string& xLabel,
              const std::string& yLabel);

}  // namespace samples

#endif  // GMLPNP_SAMPLES_AXES_HPP
