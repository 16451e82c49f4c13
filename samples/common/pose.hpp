// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_SAMPLES_POSE_HPP
#define GMLPNP_SAMPLES_POSE_HPP

#include <opencv2/core.hpp>

namespace samples {

/** A rigid motion from the object to the camera frame: X = R p + t. */
struct Pose
{
    cv::Matx33d R = cv::Matx33d::eye();
    cv::Vec3d t;

    cv::Vec3d operator*(const cv::Vec3d& point) const { return R * point + t; }
    Pose operator*(const Pose& other) const { return {R * other.R, *this * other.t}; }

    //! The camera's centre in the object frame.
    cv::Vec3d centre() const { return -(R.t() * t); }
};

inline Pose inverse(const Pose& pose)
{
    return {pose.R.t(), pose.centre()};
}

Pose poseFromRotationVector(const cv::Vec3d& rvec, const cv::Vec3d& tvec);

cv::Vec3d rotationVector(const cv::Matx33d& R);

double degrees(double radians);

/** The angle of the rotation between two poses, degrees. */
double rotationErrorDegrees(const Pose& estimate, const Pose& truth);

/** The distance between two camera centres. Unlike the difference of two t it does not depend on where the object
frame has its origin: with map coordinates of 1e6 m, t moves by metres for a microradian of rotation. */
double positionError(const Pose& estimate, const Pose& truth);

}  // namespace samples

#endif  // GMLPNP_SAMPLES_POSE_HPP
