// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_SAMPLES_METHODS_HPP
#define GMLPNP_SAMPLES_METHODS_HPP

#include <string>
#include <vector>

#include "common/correspondences.hpp"

namespace samples {

/** A solver that is compared: its name and its flag for cv::gmlpnp::solvePnP. */
struct Method
{
    std::string name;
    int flag;
};

/** OpenCV's EPNP, ITERATIVE and SQPNP, and both of this module. */
const std::vector<Method>& allMethods();

/** One method's answer to one set. */
struct Estimate
{
    bool solved = false;
    cv::Vec3d rvec, tvec;
    double microseconds = 0.0;  //!< median thread time of one call

    Pose pose() const { return poseFromRotationVector(rvec, tvec); }
};

/** Calls cv::gmlpnp::solvePnP `repeat` times. A method that throws or finds nothing has not solved. */
Estimate estimatePose(const CorrespondenceSet& set, const Method& method, int repeat);

}  // namespace samples

#endif  // GMLPNP_SAMPLES_METHODS_HPP
