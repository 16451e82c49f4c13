// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_SAMPLES_LOCALIZATION_HPP
#define GMLPNP_SAMPLES_LOCALIZATION_HPP

#include <opencv2/gmlpnp.hpp>

#include "common/comparison.hpp"
#include "uav_localization/terrain.hpp"

namespace samples {

/** Where a picture was taken, and how surely. */
struct Localization
{
    std::string name;  //!< of the pair
    size_t points = 0;
    cv::Vec3d centre;        //!< easting, northing, elevation, m
    cv::Matx33d covariance;  //!< of the centre, m^2
    cv::Vec3d attitude;      //!< roll, pitch, yaw, degrees
    bool hasTruth = false;
    cv::Vec3d truth;  //!< of the centre

    //! Squared Mahalanobis distance of the true centre.
    double squaredDistance() const;
};

//! Squared radii that hold 95 % in two and three dimensions (chi-squared).
constexpr double kReach2 = 5.991, kReach3 = 7.815;

/** This module's marginal estimate of a set in map coordinates. @return false where it finds no pose or no covariance.
 */
bool localize(const CorrespondenceSet& set, const std::string& name, Localization& found);

/** One row each: position, standard deviations, the axes of the 95 % ellipse on the map, attitude, truth.
@throws std::runtime_error where the file cannot be written. */
void writeLocalizations(const std::string& path, const std::vector<Localization>& all);

/** What the map of a picture shows, for samples/python/draw.py: the points that were used, the camera with the
covariance of its position, the truth and what each method finds. The ground is written beside it as `.asc`, first.
@throws std::runtime_error where a file cannot be written. */
void writeMap(const std::string& path, const Localization& found, const CorrespondenceSet& set, const Terrain& terrain,
              const std::vector<Method>& methods, const std::vector<Outcome>& outcomes);

}  // namespace samples

#endif  // GMLPNP_SAMPLES_LOCALIZATION_HPP
