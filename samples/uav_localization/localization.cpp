// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "uav_localization/localization.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <opencv2/imgproc.hpp>

#include "common/axes.hpp"
#include "common/exterior_orientation.hpp"
#include "common/output_file.hpp"
#include "common/table.hpp"

namespace samples {

namespace {

const cv::Size kPicture(1300, 760);
const cv::Rect2d kMap(80, 80, 600, 600), kZoom(780, 80, 400, 400), kHeight(1225, 80, 40, 400);
constexpr double kLegend = 545.0, kLegendRow = 26.0;
constexpr double kNormalReach = 1.96;  // of 95 % in one dimension

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

cv::Point2d onMap(const cv::Vec3d& place)
{
    return {place[0], place[1]};
}

//! The terrain lit from the north-west.
cv::Mat hillshade(const Terrain& terrain, const Map& map, const cv::Rect2d& area)
{
    cv::Mat shade(cv::Size(cvRound(area.width), cvRound(area.height)), CV_8UC3, colour::kWhite);
    const double h = 1.0 / map.scale.x;
    for (int y = 0; y < shade.rows; ++y)
        for (int x = 0; x < shade.cols; ++x) {
            const cv::Point2d place(map.centre.x + (area.x + x - map.origin.x) / map.scale.x,
                                    map.centre.y + (area.y + y - map.origin.y) / map.scale.y);
            const double dx = terrain.elevation({place.x + h, place.y}) - terrain.elevation({place.x - h, place.y});
            const double dy = terrain.elevation({place.x, place.y + h}) - terrain.elevation({place.x, place.y - h});
            const cv::Vec3d normal = cv::normalize(cv::Vec3d(-dx, -dy, 2.0 * h));
            const double light = normal.dot(cv::normalize(cv::Vec3d(-1.0, 1.0, 1.5)));
            if (std::isfinite(light))
                shade.at<cv::Vec3b>(y, x) = cv::Vec3b::all(cv::saturate_cast<uchar>(120.0 + 130.0 * light));
        }
    return shade;
}

void cross(Canvas& canvas, cv::Point2d at, double size, const cv::Scalar& colour, double width)
{
    canvas.line(at - cv::Point2d(size, size), at + cv::Point2d(size, size), colour, width);
    canvas.line(at - cv::Point2d(size, -size), at + cv::Point2d(size, -size), colour, width);
}

void drawMap(Canvas& canvas, const Localization& found, const CorrespondenceSet& set, const Terrain& terrain)
{
    std::vector<cv::Point2d> places = {onMap(found.centre)};
    for (const cv::Point3d& p : set.objectPoints)
        places.emplace_back(p.x, p.y);
    const Map map = fitUpward(around(places, 1.0), kMap);
    canvas.image(kMap, hillshade(terrain, map, kMap));
    drawAxes(canvas, map, kMap, "easting [m]", "northing [m]");
    canvas.clip(kMap);
    for (const cv::Point3d& p : set.objectPoints)
        canvas.disc(map({p.x, p.y}), 2.0, colour::kBlue);
    canvas.disc(map(onMap(found.centre)), 6.0, colour::kOrange);
    canvas.clip();
}

//! What is drawn enlarged: every position, relative to the estimate's.
struct Offsets
{
    std::vector<cv::Vec3d> methods;  // of those that solved nearby, NaN for the others
    cv::Matx22d ellipse;
    cv::Rect2d frame;
};

Offsets offsetsOf(const Localization& found, const std::vector<Outcome>& outcomes)
{
    const cv::Matx33d& C = found.covariance;
    Offsets offsets;
    offsets.ellipse = kReach2 * cv::Matx22d(C(0, 0), C(0, 1), C(1, 0), C(1, 1));
    double reach = std::sqrt(std::max({offsets.ellipse(0, 0), offsets.ellipse(1, 1), C(2, 2) * kReach2}));
    if (found.hasTruth)
        reach = std::max(reach, 1.1 * cv::norm(found.truth - found.centre, cv::NORM_INF));
    for (const Outcome& outcome : outcomes)
        offsets.methods.push_back(outcome.estimate.solved ? cv::Vec3d(outcome.estimate.pose().centre() - found.centre)
                                                          : cv::Vec3d::all(NAN));
    offsets.frame = {-1.4 * reach, -1.4 * reach, 2.8 * reach, 2.8 * reach};
    return offsets;
}

void drawZoom(Canvas& canvas, const Localization& found, const Offsets& offsets, const std::vector<Method>& methods)
{
    const Map map = fitUpward(offsets.frame, kZoom);
    drawAxes(canvas, map, kZoom, "east of the estimate [m]", "north [m]");
    canvas.clip(kZoom);
    const cv::Matx22d scale(map.scale.x, 0.0, 0.0, map.scale.y);
    canvas.ellipse(map({}), scale * offsets.ellipse * scale, colour::kOrange, 2.0);
    for (size_t m = 0; m < methods.size(); ++m)
        if (std::isfinite(offsets.methods[m][0]))
            canvas.disc(map(onMap(offsets.methods[m])), isOwn(methods[m]) ? 5.0 : 4.0, colour::ofCurve(m));
    if (found.hasTruth)
        cross(canvas, map(onMap(found.truth - found.centre)), 7.0, colour::kBlack, 2.5);
    canvas.clip();
}

void drawHeight(Canvas& canvas, const Localization& found, const Offsets& offsets, const std::vector<Method>& methods)
{
    const Map map = fill({0.0, offsets.frame.y, 1.0, offsets.frame.height}, kHeight);
    const double reach = kNormalReach * std::sqrt(found.covariance(2, 2));
    canvas.rectangle(kHeight, colour::kGrey);
    canvas.clip(kHeight);
    canvas.fill(cv::Rect2d(map({0.0, reach}), map({1.0, -reach})), colour::kLightOrange);
    for (size_t m = 0; m < methods.size(); ++m)
        if (std::isfinite(offsets.methods[m][2]))
            canvas.line(map({0.0, offsets.methods[m][2]}), map({1.0, offsets.methods[m][2]}), colour::ofCurve(m), 2.0);
    if (found.hasTruth)
        cross(canvas, map({0.5, found.truth[2] - found.centre[2]}), 7.0, colour::kBlack, 2.5);
    canvas.clip();
    canvas.text("up", {kHeight.x, kHeight.y - 16.0}, colour::kBlack);
}

void drawLegend(Canvas& canvas, const Localization& found, const std::vector<Method>& methods)
{
    for (size_t m = 0; m < methods.size(); ++m) {
        const size_t row = m / 2, column = m % 2;
        const cv::Point2d at(kZoom.x + 230.0 * static_cast<double>(column),
                             kLegend + kLegendRow * static_cast<double>(row));
        canvas.disc(at, 4.0, colour::ofCurve(m));
        canvas.text(methods[m].name, at + cv::Point2d(14.0, 0.0), colour::kBlack);
    }
    const size_t rows = (methods.size() + 1) / 2;
    const double y = kLegend + kLegendRow * static_cast<double>(rows);
    if (found.hasTruth) {
        cross(canvas, {kZoom.x, y}, 5.0, colour::kBlack, 2.0);
        canvas.text("truth", {kZoom.x + 14.0, y}, colour::kBlack);
    }
    canvas.line({kZoom.x + 220.0, y}, {kZoom.x + 238.0, y}, colour::kOrange, 2.0);
    canvas.text("95 % of GMLPNP_MARGINAL", {kZoom.x + 244.0, y}, colour::kBlack);
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

cv::Mat drawLocalization(const Localization& found, const CorrespondenceSet& set, const Terrain& terrain,
                         const std::vector<Method>& methods, const std::vector<Outcome>& outcomes)
{
    Canvas canvas(kPicture);
    canvas.text(cv::format("%s: %zu points", found.name.c_str(), found.points), {kMap.x, 32.0}, colour::kBlack,
                Align::kLeft, 0.6);
    drawMap(canvas, found, set, terrain);
    const Offsets offsets = offsetsOf(found, outcomes);
    drawZoom(canvas, found, offsets, methods);
    drawHeight(canvas, found, offsets, methods);
    drawLegend(canvas, found, methods);
    return canvas.picture();
}

}  // namespace samples
