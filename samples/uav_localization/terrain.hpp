// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_SAMPLES_TERRAIN_HPP
#define GMLPNP_SAMPLES_TERRAIN_HPP

#include "uav_localization/raster.hpp"

namespace samples {

/** An elevation model: the height of each place, and where a ray meets the ground. Metres, easting, northing, up. */
class Terrain
{
public:
    //! @throws std::runtime_error where no elevation is known or its cells have no size.
    explicit Terrain(const Raster& elevations);

    //! Bilinear between the centres of the cells; NaN outside and beside unknown cells.
    double elevation(const cv::Point2d& place) const;

    /** The first place where a ray that comes from above goes through the ground.
    @param direction any length; downward.
    @return false where it does not, or leaves the known ground before. */
    bool meet(const cv::Vec3d& origin, const cv::Vec3d& direction, cv::Vec3d& ground) const;

    //! The side of a cell, m.
    double resolution() const { return raster_.geo.resolution(); }

private:
    Raster raster_;
    double low_, high_;

    //! The part of a ray above the map and between its lowest and highest ground, and how far to go at once, m.
    //! @return false where there is none.
    bool steps(const cv::Vec3d& origin, const cv::Vec3d& d, double& first, double& last, double& step) const;

    double heightAbove(const cv::Vec3d& point) const { return point[2] - elevation({point[0], point[1]}); }
};

}  // namespace samples

#endif  // GMLPNP_SAMPLES_TERRAIN_HPP
