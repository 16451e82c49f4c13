// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_TEST_GMLPNP_FIXED_POSE_HPP
#define OPENCV_TEST_GMLPNP_FIXED_POSE_HPP

#include "../scenes.hpp"

namespace opencv_test {

struct FixedPose
{
    cv::gmlpnp::detail::Correspondences data;
    Pose pose;
};

inline FixedPose fixedPose(cv::RNG& rng, int n)
{
    const Scene scene = paperScene(rng, n, 0.1, 1);
    const cv::gmlpnp::detail::Correspondences data(scene.objectPoints, scene.rays);
    return {data, data.fromObject(scene.truth)};
}

}  // namespace opencv_test

#endif  // OPENCV_TEST_GMLPNP_FIXED_POSE_HPP
