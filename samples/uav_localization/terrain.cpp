// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "uav_localization/terrain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace samples {

namespace {

constexpr double kCellsPerStep = 0.5;  // along the map, of a ray's steps
constexpr double kEdge = 1e-6;         // of a cell: rounding at the edge of the map
constexpr int kBisections = 40;        // of a step: far below a millimetre

//! Keeps of [first, last] where from + s speed is in [low, high].
void clip(double from, double speed, double low, double high, double& first, double& last)
{
    if (speed == 0.0)
        return;
    const double a = (low - from) / speed, b = (high - from) / speed;
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
}

}  // namespace

Terrain::Terrain(const Raster& elevations) : raster_(elevations)
{
    const cv::Mat known = raster_.values == raster_.values;  // not NaN
    if (cv::countNonZero(known) == 0 || known.rows < 2 || known.cols < 2)
        throw std::runtime_error("the elevation model knows no elevation");
    if (!(resolution() > 0.0 && std::isfinite(resolution())))
        throw std::runtime_error("the elevation model's cells have no size");
    cv::minMaxLoc(raster_.values, &low_, &high_, nullptr, nullptr, known);
}

double Terrain::elevation(const cv::Point2d& place) const
{
    const cv::Point2d pixel = raster_.geo.pixel(place);
    const cv::Size size = raster_.values.size();
    if (!(pixel.x >= -kEdge && pixel.y >= -kEdge && pixel.x <= size.width - 1 + kEdge &&
          pixel.y <= size.height - 1 + kEdge))
        return std::numeric_limits<double>::quiet_NaN();
    const int x0 = std::clamp(cvFloor(pixel.x), 0, size.width - 2),
              y0 = std::clamp(cvFloor(pixel.y), 0, size.height - 2);
    const double a = pixel.x - x0, b = pixel.y - y0;
    const auto at = [&](int row, int column) { return static_cast<double>(raster_.values.at<float>(row, column)); };
    return (1.0 - b) * ((1.0 - a) * at(y0, x0) + a * at(y0, x0 + 1)) +
           b * ((1.0 - a) * at(y0 + 1, x0) + a * at(y0 + 1, x0 + 1));
}

bool Terrain::steps(const cv::Vec3d& origin, const cv::Vec3d& d, double& first, double& last, double& step) const
{
    const cv::Point2d from = raster_.geo.pixel({origin[0], origin[1]});
    const cv::Point2d speed = raster_.geo.pixel(raster_.geo.map({}) + cv::Point2d(d[0], d[1]));
    step = std::min(kCellsPerStep / std::hypot(speed.x, speed.y), (high_ - low_) / -d[2] + resolution());
    first = std::max(0.0, (origin[2] - high_) / -d[2] - step);
    last = (origin[2] - low_) / -d[2] + step;
    // Beside the map there is no ground to look for; a ray near the horizon would be long there.
    clip(from.x, speed.x, 0.0, raster_.values.cols - 1.0, first, last);
    clip(from.y, speed.y, 0.0, raster_.values.rows - 1.0, first, last);
    return first <= last;
}

bool Terrain::meet(const cv::Vec3d& origin, const cv::Vec3d& direction, cv::Vec3d& ground) const
{
    const cv::Vec3d d = cv::normalize(direction);
    if (!(d[2] < 0.0))
        return false;
    double first = 0.0, last = 0.0, step = 0.0;
    if (!steps(origin, d, first, last, step))
        return false;
    // As many steps as the map is wide and high, and three over its relief; more where the coordinates have no digits
    // left.
    const double count = std::ceil((last - first) / step),
                 most = 3 + (raster_.values.cols + raster_.values.rows) / kCellsPerStep;
    if (!(count <= most))
        return false;
    double before = first, height = heightAbove(origin + first * d);
    for (int i = 1; i <= count; ++i) {
        const double s = first + i * step, next = heightAbove(origin + s * d);
        if (height > 0.0 && next <= 0.0) {
            double after = s;
            for (int halving = 0; halving < kBisections; ++halving) {
                const double middle = 0.5 * (before + after);
                (heightAbove(origin + middle * d) > 0.0 ? before : after) = middle;
            }
            ground = origin + after * d;
            return true;
        }
        if (height > 0.0 && std::isnan(next))
            return false;  // what stands there may hide what lies behind
        before = s;
        height = next;
    }
    return false;
}

}  // namespace samples
