// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "common/noise_report.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "common/pose.hpp"
#include "common/table.hpp"

namespace samples {

namespace {

using Describe = std::function<std::string(double)>;  // a standard deviation with its unit

//! Below this a component's standard deviation is nothing beside the other's.
constexpr double kNegligible = 0.01;

//! Rows of a covariance, readable whatever their size.
std::string rowOf(const cv::Matx33d& covariance, int row, double largest)
{
    const char* const format = largest >= 1e-3 ? "%+11.4f %+11.4f %+11.4f" : "%+11.3e %+11.3e %+11.3e";
    return cv::format(format, covariance(row, 0), covariance(row, 1), covariance(row, 2));
}

//! The matrix row by row, beside it the standard deviations along its principal axes, the largest first.
void printCovariance(std::ostream& out, const cv::Matx33d& covariance, const Describe& describe)
{
    cv::Mat values, vectors;
    cv::eigen(covariance, values, vectors);
    for (int i = 0; i < 3; ++i) {
        const double deviation = std::sqrt(std::max(0.0, values.at<double>(i)));
        const cv::Vec3d axis = vectors.row(i);
        // An axis has no sign: its largest component is shown positive.
        const auto [low, high] = std::minmax_element(axis.val, axis.val + 3);
        const double sign = -*low > *high ? -1.0 : 1.0;
        out << "    " << rowOf(covariance, i, cv::norm(covariance, cv::NORM_INF)) << "     " << describe(deviation)
            << "  along (" << triple(sign * axis[0], sign * axis[1], sign * axis[2], 2, 5) << ")\n";
    }
}

//! Which of the two matters where the points are: their root mean square deviations at the mean depth.
void printShares(std::ostream& out, const cv::gmlpnp::Result& result, const LengthUnit& unit, double meanDepth)
{
    const double points = std::sqrt(cv::trace(result.objectNoise)[0] / 3.0) * unit.perFileUnit;
    const double bearings = std::sqrt(cv::trace(result.bearingNoise)[0] / 3.0) * meanDepth * unit.perFileUnit;
    const std::string name = unit.name;
    out << "  At the mean depth, " << fixed(meanDepth * unit.perFileUnit, 1) << " " << name << ": points "
        << fixed(points, 4) << " " << name << ", bearings " << fixed(bearings, 4) << " " << name;
    if (points < kNegligible * bearings)
        out << "; the points show no noise of their own";
    if (bearings < kNegligible * points)
        out << "; the bearings show no noise of their own";
    out << "\n";
}

cv::Vec3d standardDeviations(const cv::Mat& covariance)
{
    cv::Vec3d deviations;
    for (int i = 0; i < 3; ++i)
        deviations[i] = std::sqrt(std::max(0.0, covariance.at<double>(i, i)));
    return deviations;
}

void printPoseDeviations(std::ostream& out, const cv::gmlpnp::Result& result, const LengthUnit& unit)
{
    out << "  Standard deviations of the pose\n";
    if (result.poseCovariance.empty()) {
        out << "    unknown: no residuals are left to judge it by\n";
        return;
    }
    const cv::Vec3d rotation = standardDeviations(result.poseCovariance) * degrees(1.0);
    const cv::Vec3d position = standardDeviations(result.cameraCenterCovariance) * unit.perFileUnit;
    const std::string format = "    %-44s %9.4f %9.4f %9.4f\n";
    out << cv::format(format.c_str(), "rotation about the camera's x, y, z [deg]", rotation[0], rotation[1],
                      rotation[2])
        << cv::format(format.c_str(), ("position along the object's x, y, z [" + unit.name + "]").c_str(), position[0],
                      position[1], position[2]);
}

}  // namespace

void printNoise(std::ostream& out, const cv::gmlpnp::Result& result, const LengthUnit& unit, double focalLength,
                double meanDepth)
{
    const std::string beside = ", and its principal standard deviations\n";
    const double square = unit.perFileUnit * unit.perFileUnit;
    out << "  Sigma, noise of the points, object frame [" << unit.name << "^2]" << beside;
    printCovariance(out, cv::Matx33d(result.objectNoise) * square,
                    [&](double deviation) { return cv::format("%9.4f %s", deviation, unit.name.c_str()); });
    if (result.objectNoiseRank < 3)
        out << "    (rank " << result.objectNoiseRank << ": along the other axes it is no estimate of the noise)\n";
    out << "  Gamma, noise of the bearings, camera frame [mrad^2]" << beside;
    printCovariance(out, cv::Matx33d(result.bearingNoise) * 1e6, [&](double deviation) {
        return cv::format("%9.4f mrad = %.3f px", deviation, 1e-3 * deviation * focalLength);
    });
    if (result.tailShare > 0)
        out << "  Tails: " << fixed(100 * result.tailShare, 0)
            << " % of the points are noisier than that (about a Student-t of " << fixed(result.tailDof, 1)
            << " degrees of freedom)\n";
    printShares(out, result, unit, meanDepth);
    printPoseDeviations(out, result, unit);
}

}  // namespace samples
