// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "common/residual_picture.hpp"

#include <algorithm>
#include <cmath>

#include "common/axes.hpp"
#include "common/images.hpp"
#include "common/statistics.hpp"

namespace samples {

namespace {

const cv::Size kPicture(1400, 800);
const cv::Rect2d kImageArea(60, 90, 860, 620), kUpperPlot(1000, 90, 380, 260), kLowerPlot(1000, 450, 380, 260);
//! In the image an ellipse of median size is drawn with at most this radius, px of the picture.
constexpr double kEllipseRadius = 24.0;
//! The plots reach this many times as far as the ellipse, so that outliers are seen too.
constexpr double kPlotReach = 1.6;

const cv::Scalar& colourOf(const Residual& residual)
{
    return residual.inside ? colour::kBlue : colour::kOrange;
}

//! Paler: where points are dense the ellipses must not hide the arrows.
const cv::Scalar& tintOf(const Residual& residual)
{
    return residual.inside ? colour::kLightBlue : colour::kLightOrange;
}

//! The image, or where its size is not known the part of it that holds the pixels.
cv::Rect2d imageBounds(const CorrespondenceSet& set)
{
    if (!set.imageSize.empty())
        return {-0.5, -0.5, static_cast<double>(set.imageSize.width), static_cast<double>(set.imageSize.height)};
    cv::Point2d low = set.imagePoints[0], high = low;
    for (const cv::Point2d& p : set.imagePoints) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const double margin = 0.05 * std::max({high.x - low.x, high.y - low.y, 1.0});
    return {low - cv::Point2d(margin, margin), high + cv::Point2d(margin, margin)};
}

//! Residuals and ellipses are drawn this many times too large, so that they can be seen.
double magnification(const std::vector<Residual>& residuals, double scale)
{
    std::vector<double> radii;
    for (const Residual& r : residuals)
        radii.push_back(scale * std::sqrt(r.reach * std::sqrt(cv::determinant(r.pixelCovariance))));
    const double radius = median(radii);
    return radius > 0.0 ? std::max(1.0, roundStep(kEllipseRadius / radius)) : 1.0;
}

void drawImagePlane(Canvas& canvas, const CorrespondenceSet& set, const std::vector<Residual>& residuals)
{
    const Map map = fit(imageBounds(set), kImageArea);
    const cv::Rect2d bounds = imageBounds(set), frame(map(bounds.tl()), map(bounds.br()));
    const double magnified = magnification(residuals, map.scale.x), scale = magnified * map.scale.x;
    drawAxes(canvas, map, frame, "u [px]", "v [px]");
    canvas.clip(frame);
    for (const Residual& r : residuals)
        canvas.ellipse(map(r.observed), scale * scale * r.reach * r.pixelCovariance, tintOf(r));
    for (const Residual& r : residuals) {
        const cv::Point2d at = map(r.observed);
        canvas.arrow(at, at + scale * cv::Point2d(r.pixels[0], r.pixels[1]), colourOf(r));
        canvas.disc(at, 1.5, colour::kBlack);
    }
    canvas.clip();
    canvas.rectangle(frame, colour::kGrey);
    canvas.text(cv::format("Image plane, residuals and 95%% ellipses enlarged %g times", magnified),
                {frame.x + 40.0, frame.y - 16.0}, colour::kBlack);
}

//! Two of the three coordinates of the camera frame.
struct Plane
{
    int across, down;
    const char *title, *xName, *yName;
};

void drawObjectSpace(Canvas& canvas, const std::vector<Residual>& residuals, const Plane& plane,
                     const cv::Rect2d& frame, const LengthUnit& unit)
{
    const double perUnit = unit.perFileUnit;
    cv::Matx33d S;
    for (const Residual& r : residuals)
        S += r.objectCovariance * (perUnit * perUnit / static_cast<double>(residuals.size()));
    const int a = plane.across, d = plane.down;
    const cv::Matx22d ellipse = residuals[0].reach * cv::Matx22d(S(a, a), S(a, d), S(d, a), S(d, d));
    const double x = kPlotReach * std::sqrt(ellipse(0, 0)), y = kPlotReach * std::sqrt(ellipse(1, 1));
    if (!(x + y > 0.0))
        return;  // exact data have no residuals to show
    const Map map = fit({-x, -y, 2.0 * x, 2.0 * y}, frame);
    drawAxes(canvas, map, frame, std::string(plane.xName) + " [" + unit.name + "]",
             std::string(plane.yName) + " [" + unit.name + "]");
    canvas.clip(frame);
    canvas.ellipse(map({}), map.scale.x * map.scale.x * ellipse, colour::kBlack, 1.2);
    for (const Residual& r : residuals)
        canvas.disc(map({perUnit * r.object[a], perUnit * r.object[d]}), 1.8, colourOf(r));
    canvas.clip();
    canvas.text(plane.title, {frame.x + 30.0, frame.y - 16.0}, colour::kBlack);
}

void drawLegend(Canvas& canvas, const std::vector<Residual>& residuals)
{
    const auto inside = std::count_if(residuals.begin(), residuals.end(), [](const Residual& r) { return r.inside; });
    const double share = 100.0 * static_cast<double>(inside) / static_cast<double>(residuals.size());
    const double y = kPicture.height - 25.0, left = kImageArea.x + 20.0, right = kUpperPlot.x;
    canvas.disc({left, y}, 1.5, colour::kBlack);
    canvas.text("observed pixel", {left + 10.0, y}, colour::kBlack);
    canvas.arrow({left + 140.0, y}, {left + 168.0, y}, colour::kBlack);
    canvas.text("predicted to observed", {left + 176.0, y}, colour::kBlack);
    canvas.text(cv::format("inside the ellipse: %.1f%%", share), {left + 370.0, y}, colour::kBlue);
    canvas.text(cv::format("outside: %.1f%% (5%% expected)", 100.0 - share), {left + 570.0, y}, colour::kOrange);
    canvas.disc({right, y}, 1.8, colour::kBlue);
    canvas.text("ray to object point", {right + 10.0, y}, colour::kBlack);
    canvas.line({right + 190.0, y}, {right + 218.0, y}, colour::kBlack, 1.2);
    canvas.text("mean 95% ellipse", {right + 226.0, y}, colour::kBlack);
}

}  // namespace

cv::Mat drawResiduals(const CorrespondenceSet& set, const std::vector<Residual>& residuals, const std::string& title,
                      const LengthUnit& unit)
{
    Canvas canvas(kPicture);
    canvas.text(title, {kImageArea.x, 32.0}, colour::kBlack, Align::kLeft, 0.6);
    if (residuals.empty())
        return canvas.picture();
    drawImagePlane(canvas, set, residuals);
    drawObjectSpace(canvas, residuals, {0, 1, "Object space, camera x-y", "x", "y"}, kUpperPlot, unit);
    drawObjectSpace(canvas, residuals, {0, 2, "Object space, camera x-z (the depth is free)", "x", "z"}, kLowerPlot,
                    unit);
    drawLegend(canvas, residuals);
    return canvas.picture();
}

void writeResiduals(const std::string& path, const CorrespondenceSet& set, const std::vector<Residual>& residuals,
                    const std::string& method)
{
    const std::string title = set.name() + ": " + std::to_string(set.objectPoints.size()) + " points, " + method;
    writeImage(path, drawResiduals(set, residuals, title, shownUnit(set.unit)));
}

}  // namespace samples
