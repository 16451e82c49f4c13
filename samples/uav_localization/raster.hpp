// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_SAMPLES_RASTER_HPP
#define GMLPNP_SAMPLES_RASTER_HPP

#include <string>

#include <opencv2/core.hpp>

namespace samples {

/** An affine map from pixels (OpenCV's: the centre of the top-left pixel is (0, 0)) to easting and northing. */
struct GeoTransform
{
    cv::Matx23d mapFromPixel;

    cv::Point2d map(const cv::Point2d& pixel) const;
    cv::Point2d pixel(const cv::Point2d& map) const;
    //! The side of a pixel, the mean of both directions, in the map's unit.
    double resolution() const;
};

/** A raster of the map. */
struct Raster
{
    cv::Mat values;  //!< elevations: CV_32F, NaN where unknown; pictures: CV_8U or CV_8UC3
    cv::Mat mask;    //!< of pictures: 255 where they show something
    GeoTransform geo;
};

/** The coordinate system of a map, as WKT; empty where the raster `dem` has none.

`wanted` (anything GDAL understands, such as EPSG:32651) where it is given, else the one of the raster where that is a
projection, else the UTM zone of its middle. @throws std::runtime_error where it is none in metres. */
std::string mapSystem(const std::string& wanted, const std::string& dem);

/** The first band of an elevation model in the map's system, metres, warped where it has another.
@throws std::runtime_error naming the file where it cannot be read, has no geotransform or is not in metres. */
Raster readElevation(const std::string& path, const std::string& system);

/** An orthophoto in the map's system, grey, warped where it has another.
@throws std::runtime_error naming the file where it cannot be read or has no geotransform. */
Raster readOrthophoto(const std::string& path, const std::string& system);

/** Writes a picture of 1 or 3 channels (OpenCV's order) and its mask, as alpha, as GeoTIFF.
@throws std::runtime_error naming the file where it cannot be written. */
void writeOrthophoto(const std::string& path, const Raster& raster, const std::string& system);

}  // namespace samples

#endif  // GMLPNP_SAMPLES_RASTER_HPP
