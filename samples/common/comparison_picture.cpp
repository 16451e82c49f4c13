// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "common/comparison_picture.hpp"

#include <algorithm>

#include "common/axes.hpp"

namespace samples {

namespace {

constexpr double kPanelWidth = 380.0, kPanelHeight = 280.0, kLeft = 60.0, kTop = 90.0;
constexpr double kColumn = 440.0, kRow = 370.0, kLegendRow = 24.0;
constexpr size_t kPanelsPerRow = 3, kLegendsPerRow = 4;
//! The abscissa ends where the method with the fewest errors that far has this share of the pairs.
constexpr double kShownShare = 0.95;

//! The errors of each method, ascending, and where the abscissa ends.
struct Curves
{
    std::vector<std::vector<double>> errors;
    double end = 0.0;
};

Curves curvesOf(const Comparison& comparison, size_t quantity)
{
    Curves curves;
    std::vector<double> ends;
    for (size_t m = 0; m < comparison.methods.size(); ++m) {
        std::vector<double> errors = absoluteErrors(comparison, m, quantity);
        std::sort(errors.begin(), errors.end());
        if (!errors.empty())
            ends.push_back(errors[static_cast<size_t>(kShownShare * static_cast<double>(errors.size() - 1))]);
        curves.errors.push_back(errors);
    }
    if (!ends.empty())
        curves.end = *std::min_element(ends.begin(), ends.end());
    return curves;
}

double widthOf(const Method& method)
{
    return isOwn(method) ? 2.4 : 1.2;
}

void drawCurve(Canvas& canvas, const Map& map, const std::vector<double>& errors, double end, double pairs,
               const Method& method, const cv::Scalar& colour)
{
    cv::Point2d last(0.0, 0.0);
    for (size_t i = 0; i < errors.size(); ++i) {
        const cv::Point2d corner(errors[i], last.y), top(errors[i], 100.0 * static_cast<double>(i + 1) / pairs);
        canvas.line(map(last), map(corner), colour, widthOf(method));
        canvas.line(map(corner), map(top), colour, widthOf(method));
        last = top;
    }
    canvas.line(map(last), map({std::max(last.x, end), last.y}), colour, widthOf(method));
}

void drawPanel(Canvas& canvas, const Comparison& comparison, size_t quantity)
{
    const Curves curves = curvesOf(comparison, quantity);
    if (!(curves.end > 0.0))
        return;  // nothing solved, or exact data
    const size_t row = quantity / kPanelsPerRow, column = quantity % kPanelsPerRow;
    const cv::Rect2d frame(kLeft + kColumn * static_cast<double>(column), kTop + kRow * static_cast<double>(row),
                           kPanelWidth, kPanelHeight);
    const Map map = fill({0.0, 0.0, curves.end, 100.0}, frame);
    const Quantity& q = comparison.quantities[quantity];
    drawAxes(canvas, map, frame, q.name + " error [" + q.unit + "]", "pairs [%]");
    canvas.clip(frame);
    for (size_t m = 0; m < comparison.methods.size(); ++m)
        drawCurve(canvas, map, curves.errors[m], curves.end, static_cast<double>(comparison.trials.size()),
                  comparison.methods[m], colour::ofCurve(m));
    canvas.clip();
}

}  // namespace

cv::Mat drawComparison(const Comparison& comparison, const std::string& title)
{
    const auto rowsOf = [](size_t count, size_t perRow) { return (count + perRow - 1) / perRow; };
    const size_t panels = comparison.quantities.size(), legends = rowsOf(comparison.methods.size(), kLegendsPerRow);
    const double bottom = kTop + kRow * static_cast<double>(rowsOf(panels, kPanelsPerRow));
    Canvas canvas(cv::Size(cvRound(kLeft + kColumn * static_cast<double>(std::min(panels, kPanelsPerRow))),
                           cvRound(bottom + kLegendRow * static_cast<double>(legends))));
    canvas.text(title, {kLeft, 32.0}, colour::kBlack, Align::kLeft, 0.6);
    for (size_t quantity = 0; quantity < panels; ++quantity)
        drawPanel(canvas, comparison, quantity);
    for (size_t m = 0; m < comparison.methods.size(); ++m) {
        const size_t row = m / kLegendsPerRow, column = m % kLegendsPerRow;
        const cv::Point2d at(kLeft + 200.0 * static_cast<double>(column),
                             bottom - 10.0 + kLegendRow * static_cast<double>(row));
        canvas.line(at, at + cv::Point2d(24.0, 0.0), colour::ofCurve(m), widthOf(comparison.methods[m]));
        canvas.text(comparison.methods[m].name, at + cv::Point2d(32.0, 0.0), colour::kBlack);
    }
    return canvas.picture();
}

}  // namespace samples
