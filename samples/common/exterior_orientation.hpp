// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_SAMPLES_EXTERIOR_ORIENTATION_HPP
#define GMLPNP_SAMPLES_EXTERIOR_ORIENTATION_HPP

#include <map>
#include <string>

#include "common/pose.hpp"

namespace samples {

/** The pose of an aerial photograph from photogrammetry's angles, map (easting, northing, up) to camera (x right, y
down, z forward): R_map_from_camera = Rx(omega) Ry(phi) Rz(kappa) diag(1, -1, -1).
@param centre of the camera, map, m.
@param angles omega, phi, kappa, degrees. */
Pose poseFromOmegaPhiKappa(const cv::Vec3d& centre, const cv::Vec3d& angles);

/** Exterior orientations by the pictures' names without extension.

The file is a table: its first line names the columns filename, x, y, z, omega, phi, kappa (degrees), in any order and
with others between; then a line per picture. Columns are separated by commas or blanks; quotes hold a word together.
@throws std::runtime_error with "file:line: what is wrong". */
std::map<std::string, Pose> readOrientations(const std::string& path);

/** Roll, pitch and yaw [deg] of an aircraft with the camera in its floor: image top to the nose, axis downward. Yaw is
the heading, clockwise from grid north; then pitch, nose up; then roll, right wing down. A camera that looks straight
down has neither roll nor pitch; one that looks at the horizon has no yaw of its own. */
cv::Vec3d rollPitchYaw(const Pose& cameraFromMap);

/** The difference of two angles, in (-180, 180]. */
double angleDifference(double a, double b);

}  // namespace samples

#endif  // GMLPNP_SAMPLES_EXTERIOR_ORIENTATION_HPP
