// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

// An orthophoto from an oriented aerial photograph and an elevation model: a reference picture for uav_localization.

#include <iostream>

#include <opencv2/gmlpnp/camera.hpp>
#include <opencv2/imgcodecs.hpp>

#include "common/images.hpp"
#include "uav_localization/photographs.hpp"
#include "uav_localization/reference.hpp"

namespace {

using namespace samples;

const char* const kKeys =
    "{help h usage ? |    | print this help}"
    "{@photograph    |    | aerial photograph; --poses knows it by its name}"
    "{@output        |    | GeoTIFF to be written}"
    "{resolution     | 0  | side of its pixels, m; 0: the photograph's own on the ground}";

int run(const Arguments& arguments)
{
    const std::string &photograph = arguments.files[0], &output = arguments.files[1];
    const std::string dem = required(arguments, "dem");
    const Pose cameraFromMap = poseOf(photograph, orientationsOf(arguments));
    const auto camera = cv::gmlpnp::CameraModel::pinhole(cameraMatrixOf(arguments), arguments.numbers("distortion"));
    const std::string system = mapSystem(arguments.get<std::string>("crs"), dem);
    const Terrain terrain(readElevation(dem, system));
    const Raster raster = makeOrthophoto(readImage(photograph, cv::IMREAD_COLOR), *camera, cameraFromMap, terrain,
                                         arguments.get<double>("resolution"));
    writeOrthophoto(output, raster, system);
    std::cout << output << ": " << raster.mask.cols << " x " << raster.mask.rows << " pixels of "
              << cv::format("%.3f m, %.1f %% of them seen\n", raster.geo.resolution(),
                            100.0 * cv::countNonZero(raster.mask) / static_cast<double>(raster.mask.total()));
    return 0;
}

}  // namespace

int main(int argc, char** argv)
{
    return runProgram(argc, argv, std::string(kKeys) + kPhotographKeys,
                      "An orthophoto from an aerial photograph and an elevation model.\n", 2, run);
}
