// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "fuzzed_file.hpp"
#include "outcome.hpp"

#include "uav_localization/terrain.hpp"

// GeoTIFF and whatever else GDAL takes for a raster: elevation models and orthophotos.

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    return fuzz::read<std::runtime_error>(data, size, "raster.tif", [](const std::string& path) {
        const std::string system = samples::mapSystem("", path);
        const samples::Raster picture = samples::readOrthophoto(path, system);
        fuzz::require(picture.values.size() == picture.mask.size(), "a mask of the picture's size");
        const samples::Terrain terrain(samples::readElevation(path, system));
        const cv::Point2d middle = picture.geo.map({0.5 * picture.values.cols, 0.5 * picture.values.rows});
        cv::Vec3d ground;
        terrain.meet({middle.x, middle.y, 1e4}, {0.1, 0.2, -1}, ground);
        terrain.meet({middle.x, middle.y, 1e4}, {1, 0, -1e-9}, ground);
    });
}
