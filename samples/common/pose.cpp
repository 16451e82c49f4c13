// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "common/pose.hpp"

#include <cmath>

#include <opencv2/gmlpnp/compat.hpp>

namespace samples {

Pose poseFromRotationVector(const cv::Vec3d& rvec, const cv::Vec3d& tvec)
{
    Pose pose;
    cv::Rodrigues(rvec, pose.R);
    pose.t = tvec;
    return pose;
}

cv::Vec3d rotationVector(const cv::Matx33d& R)
{
    cv::Vec3d rvec;
    cv::Rodrigues(R, rvec);
    return rvec;
}

double degrees(double radians)
{
    return radians * 180.0 / CV_PI;
}

double rotationErrorDegrees(const Pose& estimate, const Pose& truth)
{
    const cv::Matx33d D = estimate.R * truth.R.t();
    // The arc tangent of sine and cosine: the arc cosine of the trace alone loses half the digits near zero.
    const cv::Vec3d axis(D(2, 1) - D(1, 2), D(0, 2) - D(2, 0), D(1, 0) - D(0, 1));
    return degrees(std::atan2(cv::norm(axis), cv::trace(D) - 1.0));
}

double positionError(const Pose& estimate, const Pose& truth)
{
    return cv::norm(estimate.centre() - truth.centre());
}

}  // namespace samples
