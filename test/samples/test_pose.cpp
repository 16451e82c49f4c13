// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include <gtest/gtest.h>

#include <cmath>

#include "common/pose.hpp"

namespace {

using namespace samples;

TEST(Pose, rotationErrorIsTheAngleFromTinyToHalfATurn)
{
    const Pose base = poseFromRotationVector({0.4, -0.3, 1.2}, {1, 2, 3});
    const cv::Vec3d axis = cv::normalize(cv::Vec3d(1, -2, 0.5));
    for (const double angle : {0.0, 1e-9, 1e-6, 0.01, 1.0, 3.0, 3.14159, CV_PI}) {
        Pose turned = base;
        turned.R = poseFromRotationVector(angle * axis, {}).R * base.R;
        const double error = rotationErrorDegrees(turned, base);
        EXPECT_TRUE(std::abs(error - degrees(angle)) < 1e-10 * (1.0 + degrees(angle))) << angle << ": " << error;
    }
}

TEST(Pose, positionErrorDoesNotDependOnTheObjectsOrigin)
{
    const Pose truth = poseFromRotationVector({0.1, 0.2, 0.3}, {1, 2, 3});
    const Pose estimate = poseFromRotationVector({0.1001, 0.2, 0.3}, {1, 2, 3.01});
    const double error = positionError(estimate, truth);
    EXPECT_GT(error, 0.0);
    const cv::Vec3d shift(1e6, 2e6, 3e3);  // p -> p + shift
    Pose movedTruth = truth, movedEstimate = estimate;
    movedTruth.t -= truth.R * shift;
    movedEstimate.t -= estimate.R * shift;
    EXPECT_NEAR(positionError(movedEstimate, movedTruth), error, 1e-8);
    EXPECT_GT(cv::norm(movedEstimate.t - movedTruth.t), 100.0);  // why it is not the difference of two t
}

TEST(Pose, centreIsWhereTheCameraSeesNoDistance)
{
    const Pose pose = poseFromRotationVector({0.7, -0.2, 0.3}, {1, 2, 3});
    EXPECT_LT(cv::norm(pose * pose.centre()), 1e-14);
}

}  // namespace
