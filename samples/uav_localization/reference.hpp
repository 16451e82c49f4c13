// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_SAMPLES_REFERENCE_HPP
#define GMLPNP_SAMPLES_REFERENCE_HPP

#include <functional>
#include <string>

#include <opencv2/gmlpnp/camera.hpp>

#include "common/pose.hpp"
#include "uav_localization/terrain.hpp"

namespace samples {

/** A picture of which every pixel has a place on the map. */
struct Reference
{
    std::string path;
    cv::Mat grey;
    cv::Mat mask;  //!< 255 where it shows something; empty: everywhere
    //! Easting, northing and elevation of a pixel; false where the elevation model does not reach.
    std::function<bool(const cv::Point2d& pixel, cv::Vec3d& ground)> lift;
};

/** An orthophoto: its geotransform tells easting and northing, the terrain the elevation. */
Reference orthophotoReference(const std::string& path, const std::string& system, const Terrain& terrain);

/** An oriented photograph: the ray of a pixel meets the terrain. `terrain` must outlive the reference. */
Reference orientedReference(const std::string& path, const cv::Ptr<cv::gmlpnp::CameraModel>& camera,
                            const Pose& cameraFromMap, const Terrain& terrain);

/** An orthophoto made of a photograph: each pixel is a place of the map, with the colour of the photograph where that
shows it, masked where something hides it.
@param resolution side of its pixels, m; 0: that of the photograph on the ground in its middle.
@throws std::runtime_error where the photograph shows nothing of the terrain. */
Raster makeOrthophoto(const cv::Mat& photograph, const cv::gmlpnp::CameraModel& camera, const Pose& cameraFromMap,
                      const Terrain& terrain, double resolution);

}  // namespace samples

#endif  // GMLPNP_SAMPLES_REFERENCE_HPP
