// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_SAMPLES_METHODS_HPP
#define GMLPNP_SAMPLES_METHODS_HPP

#include <string>
#include <vector>

#include "common/correspondences.hpp"

namespace samples {

/** How a solver that is compared is called. */
enum class Variant
{
    kPlain,            //!< as it is
    kRefineLM,         //!< then cv::solvePnPRefineLM
    kIsotropicObject,  //!< this module's, told that all noise is of the points and isotropic
    kIsotropicBearing  //!< this module's, told that all noise is of the bearings and isotropic
};

/** A solver that is compared: its name, its flag for cv::gmlpnp::solvePnP and its variant. */
struct Method
{
    std::string name;
    int flag;
    Variant variant = Variant::kPlain;
};

/** OpenCV's EPNP, ITERATIVE and SQPNP, and both of this module. */
const std::vector<Method>& allMethods();

/** For comparisons on many pairs: those, SQPNP + LM (the best that OpenCV offers), and two that estimate no noise and
serve any lens as this module does: ISOTROPIC (distances of points from rays) and BEARING (angles between rays, bundle
adjustment on the sphere). This module's stand last. */
const std::vector<Method>& comparedMethods();

//! Whether a method is one of this module's two estimators.
bool isOwn(const Method& method);

/** One method's answer to one set. */
struct Estimate
{
    bool solved = false;
    cv::Vec3d rvec, tvec;
    double microseconds = 0.0;  //!< median thread time of one call

    Pose pose() const { return poseFromRotationVector(rvec, tvec); }
};

/** Calls a method `repeat` times. A method that throws or finds nothing has not solved.

Through a lens that is no pinhole OpenCV's methods get the rays where they meet the plane z = 1, as
cv::fisheye::undistortPoints would give them; a set with a ray 90 degrees or more off the axis they cannot solve. */
Estimate estimatePose(const CorrespondenceSet& set, const Method& method, int repeat);

}  // namespace samples

#endif  // GMLPNP_SAMPLES_METHODS_HPP
