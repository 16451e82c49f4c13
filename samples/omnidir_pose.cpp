// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

// The pose of any camera, fisheye and omnidirectional too, from its calibration file and a file of 2D-3D
// correspondences; with the noise of the data, also in pixels, and the uncertainty of the pose.

#include <algorithm>
#include <cmath>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/command_line.hpp"
#include "common/methods.hpp"
#include "common/noise_report.hpp"
#include "common/residuals.hpp"
#include "common/table.hpp"

namespace {

using namespace samples;
using cv::gmlpnp::CameraModel;

const char* const kKeys =
    "{help h usage ? |                 | print this help}"
    "{@calibration   |                 | calibration file, YAML, XML or JSON (kinds: doc/cameras.md)}"
    "{@points        |                 | correspondence file (format: samples/common/correspondences.hpp)}"
    "{model          |                 | pinhole or fisheye, where the calibration file does not tell}"
    "{method         | GMLPNP_MARGINAL | GMLPNP or GMLPNP_MARGINAL}"
    "{residuals      |                 | write the residuals to this CSV file, which samples/python/draw.py draws}";

const Method& ownMethod(const std::string& name)
{
    for (const Method& method : allMethods())
        if (method.name == name && method.flag >= cv::gmlpnp::SOLVEPNP_GMLPNP)
            return method;
    throw std::runtime_error("--method: '" + name + "' is neither GMLPNP nor GMLPNP_MARGINAL");
}

cv::Ptr<CameraModel> loadCamera(const std::string& path, const std::string& model)
{
    try {
        return CameraModel::load(path, model);
    } catch (const cv::Exception& error) {
        throw std::runtime_error(error.err);  // it starts with the file's name
    }
}

cv::gmlpnp::Result solvePose(const cv::Ptr<CameraModel>& camera, const CorrespondenceSet& set, const Method& method)
{
    cv::gmlpnp::Params params;
    params.method = method.flag;
    cv::gmlpnp::Result result;
    if (!cv::gmlpnp::solve(set.objectPoints, set.imagePoints, camera, result, params))
        throw std::runtime_error(set.path + ": no pose by " + method.name + ", status " +
                                 std::to_string(result.status));
    return result;
}

//! What the lens makes of the pixels: how many have no ray, how far from the axis the others are.
void printView(const CameraModel& camera, const CorrespondenceSet& set)
{
    cv::Mat rays, hasRay;
    camera.unproject(set.imagePoints, rays, hasRay);
    double least = 1.0;  // cosine
    int behind = 0;
    for (int i = 0; i < rays.rows; ++i)
        if (hasRay.at<uchar>(i)) {
            least = std::min(least, rays.at<double>(i, 2));
            behind += rays.at<double>(i, 2) < 0.0;
        }
    const int without = rays.rows - cv::countNonZero(hasRay);
    std::cout << set.name() << ": " << rays.rows << " points, " << without << " without a ray; up to "
              << fixed(degrees(std::acos(least)), 1) << " degrees off the axis, " << behind << " beyond 90\n";
    for (const std::string& line : set.source)
        std::cout << "  " << line << "\n";
    std::cout << "\n";
}

double rmsPixels(const std::vector<Residual>& residuals)
{
    double squares = 0.0;
    for (const Residual& r : residuals)
        squares += r.pixels.dot(r.pixels);
    return residuals.empty() ? 0.0 : std::sqrt(squares / static_cast<double>(residuals.size()));
}

void printPose(const cv::gmlpnp::Result& result, const CorrespondenceSet& set, double rms)
{
    const LengthUnit unit = shownUnit(set.unit);
    const cv::Vec3d r = result.rvec * degrees(1.0), t = result.tvec * unit.perFileUnit;
    const cv::Vec3d centre = result.cameraCenter * unit.perFileUnit;
    const std::string length = " [" + unit.name + "]";
    Table table({"", "x", "y", "z"});
    const auto row = [&](const std::string& name, const cv::Vec3d& v) {
        table.add({name, fixed(v[0], 4), fixed(v[1], 4), fixed(v[2], 4)});
    };
    row("rvec [deg]", r);
    row("tvec" + length, t);
    row("camera in the object frame" + length, centre);
    table.print(std::cout);
    std::cout << "  Reprojection error, root mean square: " << fixed(rms, 3) << " px\n";
    if (!set.hasTruth)
        return;
    const Pose pose = poseFromRotationVector(result.rvec, result.tvec);
    std::cout << "  Against the truth: " << fixed(rotationErrorDegrees(pose, set.truth), 4) << " deg, "
              << fixed(positionError(pose, set.truth) * unit.perFileUnit, 4) << " " << unit.name << "\n";
}

void printBearingNoise(const PixelScale& scale)
{
    const double u = std::sqrt(scale.bearingNoise(0, 0)), v = std::sqrt(scale.bearingNoise(1, 1));
    std::cout << "  Gamma in the picture, mean over the pixels: standard deviations " << fixed(u, 3) << " px along u, "
              << fixed(v, 3) << " px along v";
    if (u * v > 0.0)
        std::cout << ", correlation " << fixed(scale.bearingNoise(0, 1) / (u * v), 2);
    std::cout << "\n  Here 1 mrad is " << fixed(1e-3 * scale.pixelsPerRadian, 3) << " px\n";
}

int run(const Arguments& arguments)
{
    if (arguments.files.size() != 2)
        throw std::runtime_error("one calibration file and one correspondence file are expected, not " +
                                 std::to_string(arguments.files.size()) + " files");
    const Method& method = ownMethod(arguments.get<std::string>("method"));
    const auto camera = loadCamera(arguments.files[0], arguments.get<std::string>("model"));
    const CorrespondenceSet set = readCorrespondences(arguments.files[1], CameraIn::kElsewhere);
    printView(*camera, set);
    const cv::gmlpnp::Result result = solvePose(camera, set, method);
    const std::vector<Residual> residuals = residualsOf(*camera, set, result);
    const PixelScale scale = meanPixelScale(*camera, set.imagePoints, cv::Matx33d(result.bearingNoise));
    printPose(result, set, rmsPixels(residuals));
    std::cout << "\n" << method.name << " also gives\n";
    printNoise(std::cout, result, shownUnit(set.unit), scale.pixelsPerRadian, meanDepth(residuals));
    printBearingNoise(scale);
    const std::string file = arguments.get<std::string>("residuals");
    if (!file.empty())
        writeResiduals(file, set, residuals, method.name);
    return 0;
}

}  // namespace

int main(int argc, char** argv)
{
    return runProgram(argc, argv, kKeys,
                      "The pose of any camera from its calibration file and 2D-3D correspondences.\n", 2, run);
}
