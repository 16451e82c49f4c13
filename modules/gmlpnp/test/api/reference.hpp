// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_TEST_GMLPNP_REFERENCE_HPP
#define OPENCV_TEST_GMLPNP_REFERENCE_HPP

#include "../scenes.hpp"

namespace opencv_test {

struct Reference
{
    Scene scene;
    cv::Mat K = cv::Mat(paperCamera());
    cv::Vec3d rvec, tvec;
};

inline Reference reference(cv::RNG& rng, int n = 12)
{
    Reference r;
    r.scene = paperScene(rng, n, 0.05, 1);
    // Representable in single precision, so that float and double inputs are the same problem.
    for (cv::Mat_<double>* m : {&r.scene.objectPoints, &r.scene.imagePoints}) {
        cv::Mat f;
        m->convertTo(f, CV_32F);
        f.convertTo(*m, CV_64F);
    }
    EXPECT_TRUE(cv::gmlpnp::solvePnP(r.scene.objectPoints, r.scene.imagePoints, r.K, cv::noArray(), r.rvec, r.tvec));
    return r;
}

}  // namespace opencv_test

#endif  // OPENCV_TEST_GMLPNP_REFERENCE_HPP
