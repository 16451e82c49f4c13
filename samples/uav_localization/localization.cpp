// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "uav_localization/localization.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "common/exterior_orientation.hpp"
#include "common/output_file.hpp"
#include "common/table.hpp"

namespace samples {

namespace {

constexpr double kMostCells = 240.0;  // of the written terrain along each side; more are not seen in a picture
constexpr double kUnknown = -9999.0;

//! A frame around places, with a margin.
cv::Rect2d around(const std::vector<cv::Point2d>& places, double least)
{
    cv::Point2d low = places[0], high = places[0];
    for (const cv::Point2d& p : places) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const double side = 1.2 * std::max({high.x - low.x, high.y - low.y, least});
    const cv::Point2d middle = 0.5 * (low + high);
    return {middle.x - 0.5 * side, middle.y - 0.5 * side, side, side};
}

/** The ground as an ESRI ASCII grid, which geographic programs read: its rows from north to south, in cells no smaller
than the terrain's. */
void writeGround(std::ostream& out, const Terrain& terrain, const cv::Rect2d& area)
{
    const int cells = cvRound(std::clamp(area.width / terrain.resolution(), 2.0, kMostCells));
    const double cell = area.width / cells;
    out << "ncols " << cells << "\nnrows " << cells
        << cv::format("\nxllcorner %.4f\nyllcorner %.4f\ncellsize %.6f\nNODATA_value %g\n", area.x, area.y, cell,
                      kUnknown);
    for (int row = cells - 1; row >= 0; --row)
        for (int column = 0; column < cells; ++column) {
            const double z = terrain.elevation({area.x + (column + 0.5) * cell, area.y + (row + 0.5) * cell});
            out << cv::format("%.2f", std::isfinite(z) ? z : kUnknown) << (column + 1 < cells ? ' ' : '\n');
        }
}

void writePlace(std::ostream& out, const std::string& what, const std::string& name, const cv::Vec3d& place)
{
    out << what << "," << name << cv::format(",%.4f,%.4f,%.4f\n", place[0], place[1], place[2]);
}

}  // namespace

double Localization::squaredDistance() const
{
    cv::Vec3d weighted;
    const cv::Vec3d difference = truth - centre;
    cv::solve(covariance, difference, weighted, cv::DECOMP_CHOLESKY);
    return difference.dot(weighted);
}

bool localize(const CorrespondenceSet& set, const std::string& name, Localization& found)
{
    cv::gmlpnp::Result result;
    if (!cv::gmlpnp::solve(set.objectPoints, set.imagePoints, set.camera(), result) ||
        result.cameraCenterCovariance.empty())
        return false;
    found.name = name;
    found.points = set.objectPoints.size();
    found.centre = result.cameraCenter;
    found.covariance = cv::Matx33d(result.cameraCenterCovariance);
    found.attitude = rollPitchYaw(poseFromRotationVector(result.rvec, result.tvec));
    found.hasTruth = set.hasTruth;
    found.truth = set.truth.centre();
    return true;
}

void writeLocalizations(const std::string& path, const std::vector<Localization>& all)
{
    files::writeFile(path, [&](std::ostream& out) {
        out << "pair,points,easting,northing,elevation,sd_easting,sd_northing,sd_elevation,ellipse95_a,ellipse95_b,"
               "ellipse95_azimuth_deg,roll_deg,pitch_deg,yaw_deg,true_easting,true_northing,true_elevation,"
               "squared_distance\n";
        for (const Localization& l : all) {
            const cv::Matx33d& C = l.covariance;
            cv::Mat values, vectors;
            cv::eigen(kReach2 * cv::Matx22d(C(0, 0), C(0, 1), C(1, 0), C(1, 1)), values, vectors);
            const double azimuth = degrees(std::atan2(vectors.at<double>(0, 0), vectors.at<double>(0, 1)));
            out << l.name << "," << l.points
                << cv::format(",%.4f,%.4f,%.4f,%.4f,%.4f,%.4f", l.centre[0], l.centre[1], l.centre[2],
                              std::sqrt(C(0, 0)), std::sqrt(C(1, 1)), std::sqrt(C(2, 2)))
                << cv::format(",%.4f,%.4f,%.2f", std::sqrt(values.at<double>(0)), std::sqrt(values.at<double>(1)),
                              azimuth < 0.0 ? azimuth + 180.0 : azimuth)
                << cv::format(",%.5f,%.5f,%.5f", l.attitude[0], l.attitude[1], l.attitude[2]);
            if (l.hasTruth)
                out << cv::format(",%.4f,%.4f,%.4f,%.3f\n", l.truth[0], l.truth[1], l.truth[2], l.squaredDistance());
            else
                out << ",,,,\n";
        }
    });
}

void writeMap(const std::string& path, const Localization& found, const CorrespondenceSet& set, const Terrain& terrain,
              const std::vector<Method>& methods, const std::vector<Outcome>& outcomes)
{
    std::vector<cv::Point2d> places = {{found.centre[0], found.centre[1]}};
    for (const cv::Point3d& p : set.objectPoints)
        places.emplace_back(p.x, p.y);
    const std::filesystem::path ground = std::filesystem::path(path).replace_extension(".asc");
    files::writeFile(ground.string(), [&](std::ostream& out) { writeGround(out, terrain, around(places, 1.0)); });
    files::writeFile(path, [&](std::ostream& out) {
        out << "# kind map\n# title " << found.name << ": " << found.points << " points\n# unit m\n# terrain "
            << ground.filename().string() << "\n# covariance";
        for (const double value : found.covariance.val)
            out << cv::format(" %.9g", value);
        out << "\nwhat,name,easting,northing,elevation\n";
        writePlace(out, "centre", "GMLPNP_MARGINAL", found.centre);
        if (found.hasTruth)
            writePlace(out, "truth", "", found.truth);
        for (size_t m = 0; m < methods.size(); ++m)
            if (outcomes[m].estimate.solved)
                writePlace(out, "method", methods[m].name, outcomes[m].estimate.pose().centre());
        for (const cv::Point3d& p : set.objectPoints)
            writePlace(out, "point", "", {p.x, p.y, p.z});
    });
}

}  // namespace samples
