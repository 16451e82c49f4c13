// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_SAMPLES_PHOTOGRAPHS_HPP
#define GMLPNP_SAMPLES_PHOTOGRAPHS_HPP

#include <map>

#include "common/command_line.hpp"
#include "common/correspondences.hpp"
#include "common/exterior_orientation.hpp"

namespace samples {

//! The options of every program that knows the camera and the poses of aerial photographs.
constexpr char kPhotographKeys[] =
    "{dem            |    | elevation model, m: any raster of GDAL with a geotransform}"
    "{poses          |    | exterior orientations: a table with filename x y z omega phi kappa (degrees)}"
    "{camera         |    | fx fy cx cy of the photographs, px}"
    "{distortion     |    | k1 k2 p1 p2 k3 of the photographs}"
    "{crs            |    | coordinate system of the map, in metres, as GDAL understands it; default: the elevation "
    "model's, or UTM where that is in degrees}";

//! An option that must be there. @throws std::runtime_error where it is not.
std::string required(const Arguments& arguments, const std::string& name);

//! --poses, or none without it.
std::map<std::string, Pose> orientationsOf(const Arguments& arguments);

/** The pose of a picture. @throws std::runtime_error where the table does not have it. */
const Pose& poseOf(const std::string& picture, const std::map<std::string, Pose>& poses);

//! The name under which the table of poses has a picture: without folder and extension.
std::string pictureName(const std::string& path);

}  // namespace samples

#endif  // GMLPNP_SAMPLES_PHOTOGRAPHS_HPP
