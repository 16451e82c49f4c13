// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "common/isotropy_report.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "common/output_file.hpp"
#include "common/table.hpp"

namespace samples {

namespace {

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

void writeTrueResiduals(const std::string& path, const std::vector<TrueResidual>& residuals, const Isotropy& isotropy,
                        const ResidualsAbout& about)
{
    const auto matrix = [](const cv::Matx33d& C) {
        std::string text;
        for (const double value : C.val)
            text += cv::format(" %.9g", value);
        return text;
    };
    files::writeFile(path, [&](std::ostream& out) {
        const auto& axes = about.frame.axes;
        out << "# kind isotropy\n# title " << about.title << "\n# frame " << about.frame.name << "\n# axes " << axes[0]
            << " " << axes[1] << " " << axes[2] << "\n# unit " << about.unit << "\n# moments"
            << matrix(isotropy.moments) << "\n# isotropic" << matrix(isotropy.isotropic)
            << cv::format("\n# distance %.9g\n# p_residuals %.9g\n# p_pairs %.9g\n", isotropy.distance,
                          isotropy.pointsP, isotropy.pairsP)
            << "# Object frame; e leads from the ray to the object point.\n"
            << "pair,X,Y,Z,ex,ey,ez,depth,ray_x,ray_y,ray_z\n";
        for (const TrueResidual& r : residuals) {
            out << about.pairNames[r.pair];
            for (const cv::Vec3d& v : {r.point, r.object})
                out << cv::format(",%.10g,%.10g,%.10g", v[0], v[1], v[2]);
            out << cv::format(",%.10g,%.9f,%.9f,%.9f\n", r.depth, r.ray[0], r.ray[1], r.ray[2]);
        }
    });
}

}  // namespace samples
