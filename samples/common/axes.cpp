// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "common/axes.hpp"

#include <algorithm>
#include <cmath>

#include "common/table.hpp"

namespace samples {

namespace {

//! The tick labels must not run into each other, px of the picture.
constexpr double kLabelWidth = 56.0;

cv::Point2d middle(const cv::Rect2d& r)
{
    return 0.5 * (r.tl() + r.br());
}

//! Round numbers at a readable distance, along one axis.
struct Ticks
{
    double step;
    int decimals;

    explicit Ticks(double pixelsPerUnit) : step(roundStep(90.0 / pixelsPerUnit))
    {
        if (step * pixelsPerUnit < kLabelWidth)
            step = roundStep(2.5 * step);  // the next one
        decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
    }

    //! Counted in whole steps; adding zero turns a negative zero into zero.
    template <typename Draw>
    void forEach(double a, double b, Draw draw) const
    {
        for (double i = std::ceil(std::min(a, b) / step); i * step <= std::max(a, b); ++i)
            draw(i * step, fixed(i * step + 0.0, decimals));
    }
};

}  // namespace

Map fit(const cv::Rect2d& what, const cv::Rect2d& area)
{
    const double scale = std::min(area.width / what.width, area.height / what.height);
    return {middle(area), middle(what), {scale, scale}};
}

Map fitUpward(const cv::Rect2d& what, const cv::Rect2d& area)
{
    Map map = fit(what, area);
    map.scale.y *= -1.0;
    return map;
}

Map fill(const cv::Rect2d& what, const cv::Rect2d& area)
{
    return {middle(area), middle(what), {area.width / what.width, -area.height / what.height}};
}

double roundStep(double value)
{
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    return power * (value >= 5.0 * power ? 5.0 : value >= 2.0 * power ? 2.0 : 1.0);
}

void drawAxes(Canvas& canvas, const Map& map, const cv::Rect2d& frame, const std::string& xLabel,
              const std::string& yLabel)
{
    const cv::Point2d a = frame.tl() - map.origin, b = frame.br() - map.origin;
    const auto unitsX = [&](double pixels) { return map.centre.x + pixels / map.scale.x; };
    const auto unitsY = [&](double pixels) { return map.centre.y + pixels / map.scale.y; };
    Ticks(std::abs(map.scale.x)).forEach(unitsX(a.x), unitsX(b.x), [&](double value, const std::string& label) {
        const double at = map({value, 0.0}).x;
        canvas.line({at, frame.y}, {at, frame.br().y}, colour::kLightGrey);
        canvas.text(label, {at, frame.br().y + 13.0}, colour::kBlack, Align::kCentre, 0.38);
    });
    Ticks(std::abs(map.scale.y)).forEach(unitsY(a.y), unitsY(b.y), [&](double value, const std::string& label) {
        const double at = map({0.0, value}).y;
        canvas.line({frame.x, at}, {frame.br().x, at}, colour::kLightGrey);
        canvas.text(label, {frame.x - 7.0, at}, colour::kBlack, Align::kRight, 0.38);
    });
    canvas.rectangle(frame, colour::kGrey);
    canvas.text(xLabel, {0.5 * (frame.x + frame.br().x), frame.br().y + 31.0}, colour::kBlack, Align::kCentre);
    canvas.text(yLabel, {frame.x - 10.0, frame.y - 16.0}, colour::kBlack, Align::kCentre);
}

}  // namespace samples
