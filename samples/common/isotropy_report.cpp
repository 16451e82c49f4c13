// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "common/isotropy_report.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "common/axes.hpp"
#include "common/output_file.hpp"
#include "common/residuals.hpp"
#include "common/table.hpp"

namespace samples {

namespace {

const cv::Size kPicture(1240, 880);
constexpr double kPanel = 330.0, kPlotReach = 1.6;  // times the larger ellipse
const std::array<cv::Point2d, 4> kPanels = {cv::Point2d(70, 90), cv::Point2d(490, 90), cv::Point2d(70, 490),
                                            cv::Point2d(490, 490)};
constexpr double kNotes = 880.0;       // where the text on the right begins
constexpr size_t kMostPoints = 20000;  // drawn; more only fill the paper

//! Square roots of the eigenvalues, the largest first.
cv::Vec3d deviations(const cv::Matx33d& covariance)
{
    cv::Vec3d values;
    cv::eigen(covariance, values);
    for (int i = 0; i < 3; ++i)
        values[i] = std::sqrt(std::max(0.0, values[i]));
    return values;
}

std::string threeOf(const cv::Vec3d& v, int decimals)
{
    return fixed(v[0], decimals) + ", " + fixed(v[1], decimals) + ", " + fixed(v[2], decimals);
}

//! Enough decimals for three digits.
int decimalsFor(double value)
{
    return value > 0.0 ? std::clamp(2 - static_cast<int>(std::floor(std::log10(value))), 0, 9) : 3;
}

cv::Matx22d part(const cv::Matx33d& C, int a, int b)
{
    return {C(a, a), C(a, b), C(b, a), C(b, b)};
}

void drawPlane(Canvas& canvas, const std::vector<TrueResidual>& residuals, const Isotropy& isotropy, int a, int b,
               cv::Point2d corner, const ObjectFrame& frame, const LengthUnit& unit)
{
    const double square = squaredRadiusOf95Percent(INFINITY) * unit.perFileUnit * unit.perFileUnit;
    const cv::Matx22d found = square * part(isotropy.moments, a, b), even = square * part(isotropy.isotropic, a, b);
    const double reach = kPlotReach * std::sqrt(std::max({found(0, 0), found(1, 1), even(0, 0), even(1, 1)}));
    if (!(reach > 0.0))
        return;  // exact data have no residuals to show
    const cv::Rect2d area(corner, cv::Size2d(kPanel, kPanel));
    const Map map = fitUpward({-reach, -reach, 2.0 * reach, 2.0 * reach}, area);
    const auto& names = frame.axes;
    drawAxes(canvas, map, area, names[static_cast<size_t>(a)] + " [" + unit.name + "]",
             names[static_cast<size_t>(b)] + " [" + unit.name + "]");
    canvas.clip(area);
    const size_t step = residuals.size() / kMostPoints + 1;
    for (size_t i = 0; i < residuals.size(); i += step) {
        const cv::Vec3d e = unit.perFileUnit * residuals[i].object;
        canvas.disc(map({e[a], e[b]}), residuals.size() > 2000 ? 0.7 : 1.6, colour::kBlue);
    }
    const cv::Matx22d upward(map.scale.x, 0.0, 0.0, map.scale.y);
    canvas.ellipse(map({}), upward * even * upward, colour::kBlack, 1.6);
    canvas.ellipse(map({}), upward * found * upward, colour::kOrange, 2.2);
    canvas.clip();
}

//! The larger an entry, the darker its square: blue where positive, orange where negative.
void drawMatrix(Canvas& canvas, const Isotropy& isotropy, cv::Point2d corner, const ObjectFrame& frame,
                const LengthUnit& unit)
{
    const cv::Matx33d C = isotropy.moments * (unit.perFileUnit * unit.perFileUnit);
    const double largest = cv::norm(C, cv::NORM_INF), side = kPanel / 3.0;
    canvas.text("mean of e e^T [" + unit.name + "^2]", corner + cv::Point2d(0.0, -16.0), colour::kBlack);
    for (int i = 0; i < 3; ++i) {
        canvas.text(frame.axes[static_cast<size_t>(i)], corner + cv::Point2d(-14.0, (i + 0.5) * side), colour::kBlack,
                    Align::kRight);
        canvas.text(frame.axes[static_cast<size_t>(i)], corner + cv::Point2d((i + 0.5) * side, kPanel + 14.0),
                    colour::kBlack, Align::kCentre);
        for (int j = 0; j < 3; ++j) {
            const double share = largest > 0.0 ? std::abs(C(i, j)) / largest : 0.0;
            const cv::Scalar tint = C(i, j) < 0.0 ? colour::kOrange : colour::kBlue;
            const cv::Rect2d cell(corner + cv::Point2d(j * side, i * side), cv::Size2d(side, side));
            canvas.fill(cell, share * tint + (1.0 - share) * colour::kWhite);
            canvas.text(fixed(C(i, j), decimalsFor(largest)), 0.5 * (cell.tl() + cell.br()),
                        share > 0.6 ? colour::kWhite : colour::kBlack, Align::kCentre);
        }
    }
}

void drawNotes(Canvas& canvas, const Isotropy& isotropy, const ObjectFrame& frame, const LengthUnit& unit)
{
    const cv::Vec3d found = deviations(isotropy.moments) * unit.perFileUnit;
    const cv::Vec3d even = deviations(isotropy.isotropic) * unit.perFileUnit;
    const int decimals = decimalsFor(found[0]);
    double y = 110.0;
    const auto line = [&](const std::string& text, const cv::Scalar& colour) {
        canvas.text(text, {kNotes, y}, colour);
        y += 26.0;
    };
    line(frame.name, colour::kBlack);
    line(std::to_string(isotropy.residuals) + " residuals, " + std::to_string(isotropy.pairs) + " pairs",
         colour::kBlue);
    y += 16.0;
    line("Standard deviations along the axes:", colour::kBlack);
    line(threeOf(found, decimals) + " " + unit.name, colour::kOrange);
    line("the same lengths, isotropic:", colour::kBlack);
    line(threeOf(even, decimals) + " " + unit.name, colour::kBlack);
    y += 16.0;
    line("Test of isotropy", colour::kBlack);
    line(cv::format("distance %.3f of the trace", isotropy.distance), colour::kBlack);
    line(cv::format("p = %.4f, residuals independent", isotropy.pointsP), colour::kBlack);
    line(cv::format("p = %.4f, pairs independent", isotropy.pairsP), colour::kBlack);
}

}  // namespace

void printIsotropy(std::ostream& out, const Isotropy& isotropy, const ObjectFrame& frame, const LengthUnit& unit)
{
    const double square = unit.perFileUnit * unit.perFileUnit;
    const cv::Matx33d found = square * isotropy.moments, even = square * isotropy.isotropic;
    const cv::Vec3d mean = unit.perFileUnit * isotropy.mean;
    const int decimals = decimalsFor(cv::norm(found, cv::NORM_INF));
    out << "Residuals under the true motion, " << frame.name << ": " << isotropy.residuals << " of " << isotropy.pairs
        << " pairs; mean (" << threeOf(mean, decimals) << ") " << unit.name << "\n\n";
    const auto& axes = frame.axes;
    Table table(
        {"mean of e e^T [" + unit.name + "^2]", axes[0], axes[1], axes[2], "isotropic: " + axes[0], axes[1], axes[2]});
    for (int i = 0; i < 3; ++i)
        table.add({axes[static_cast<size_t>(i)], fixed(found(i, 0), decimals), fixed(found(i, 1), decimals),
                   fixed(found(i, 2), decimals), fixed(even(i, 0), decimals), fixed(even(i, 1), decimals),
                   fixed(even(i, 2), decimals)});
    const cv::Vec3d a = deviations(found), b = deviations(even);
    table.add({"deviations along the principal axes [" + unit.name + "]", fixed(a[0], decimals), fixed(a[1], decimals),
               fixed(a[2], decimals), fixed(b[0], decimals), fixed(b[1], decimals), fixed(b[2], decimals)});
    table.printMarkdown(out);
    out << cv::format(
        "\nTest of isotropy: distance %.3f of the trace; p = %.4f with residuals, %.4f with pairs taken "
        "as independent\n",
        isotropy.distance, isotropy.pointsP, isotropy.pairsP);
}

cv::Mat drawIsotropy(const std::vector<TrueResidual>& residuals, const Isotropy& isotropy, const std::string& title,
                     const ObjectFrame& frame, const LengthUnit& unit)
{
    Canvas canvas(kPicture);
    canvas.text(title, {kPanels[0].x, 32.0}, colour::kBlack, Align::kLeft, 0.6);
    drawPlane(canvas, residuals, isotropy, 0, 1, kPanels[0], frame, unit);
    drawPlane(canvas, residuals, isotropy, 0, 2, kPanels[2], frame, unit);
    drawPlane(canvas, residuals, isotropy, 1, 2, kPanels[3], frame, unit);
    drawMatrix(canvas, isotropy, kPanels[1], frame, unit);
    drawNotes(canvas, isotropy, frame, unit);
    return canvas.picture();
}

void writeTrueResiduals(const std::string& path, const std::vector<TrueResidual>& residuals,
                        const std::vector<std::string>& pairNames, const std::string& unit)
{
    files::writeFile(path, [&](std::ostream& out) {
        out << "# lengths in " << unit << ", object frame; e leads from the ray to the object point\n"
            << "pair,X,Y,Z,ex,ey,ez,depth,ray_x,ray_y,ray_z\n";
        for (const TrueResidual& r : residuals) {
            out << pairNames[r.pair];
            for (const cv::Vec3d& v : {r.point, r.object})
                out << cv::format(",%.10g,%.10g,%.10g", v[0], v[1], v[2]);
            out << cv::format(",%.10g,%.9f,%.9f,%.9f\n", r.depth, r.ray[0], r.ray[1], r.ray[2]);
        }
    });
}

}  // namespace samples
