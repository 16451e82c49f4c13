// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_SAMPLES_ISOTROPY_HPP
#define GMLPNP_SAMPLES_ISOTROPY_HPP

#include <cstdint>
#include <vector>

#include "common/correspondences.hpp"

namespace samples {

/** How far an object point is from the ray of its pixel under the true motion. */
struct TrueResidual
{
    size_t pair = 0;   //!< of pictures
    cv::Vec3d point;   //!< the object point, object frame
    cv::Vec3d object;  //!< from the nearest point of the ray to the object point, object frame, length
    cv::Vec3d ray;     //!< unit direction, object frame; `object` is across it
    double depth = 0;  //!< along the ray, length
};

/** Adds the residuals of a set under its truth; points without a ray, or behind the camera, have none. */
void addTrueResiduals(const CorrespondenceSet& set, size_t pair, std::vector<TrueResidual>& residuals);

/** Whether the residuals have a direction.

A residual lies across its ray, so the second moments of residuals are never isotropic, whatever the noise. What
isotropic noise of points and of bearings does imply is that a residual may be turned about its ray: its direction
across the ray is uniform, whatever its length. `isotropic` is the mean of e e^T over all such turns, and the distance
of `moments` from it (Frobenius) is the statistic. Its distribution comes from random turns, so no length or tail is
assumed: p = (1 + turns with a larger distance) / (1 + turns).

Residuals of one pair share the errors of their truth and calibration, and are then not independent. `pointsP` turns
each residual by itself; `pairsP` turns all residuals of a pair together, and holds whatever they share. */
struct Isotropy
{
    size_t residuals = 0, pairs = 0;
    cv::Vec3d mean;         //!< object frame, length
    cv::Matx33d moments;    //!< mean of e e^T, object frame, length^2
    cv::Matx33d isotropic;  //!< what isotropic noise would make of the same lengths and rays
    double distance = 0.0;  //!< of the two, relative to the trace of `moments`
    double pointsP = 1.0, pairsP = 1.0;
};

/** @throws std::runtime_error without residuals. */
Isotropy testIsotropy(const std::vector<TrueResidual>& residuals, uint64_t seed);

}  // namespace samples

#endif  // GMLPNP_SAMPLES_ISOTROPY_HPP
