// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_TEST_GMLPNP_EVERY_FUNCTION_HPP
#define OPENCV_TEST_GMLPNP_EVERY_FUNCTION_HPP

#include <cstdio>
#include <fstream>
#include <functional>

#include "../scenes.hpp"

// Every public function, called with the same arguments: the bits of what each returns.

namespace opencv_test {

/** What all threads share, made without a call of what they call, the pinhole apart. */
struct Shared
{
    explicit Shared(cv::RNG&& rng) : scene(paperScene(rng, 60, 0.02, 1)), file(cv::tempfile(".yml"))
    {
        const Vector3d w = cv::gmlpnp::detail::logSO3(scene.truth.R) + Vector3d(0.01, -0.02, 0.01);
        const Vector3d t = scene.truth.t + Vector3d(0.05, 0, -0.1);
        nearby.rvec = {w.x(), w.y(), w.z()};
        nearby.tvec = {t.x(), t.y(), t.z()};
        nearby.poseCovariance = 1e-4 * cv::Mat::eye(6, 6, CV_64F);
        std::ofstream(file) << "K: [ 800., 0., 320., 0., 800., 240., 0., 0., 1. ]\nD: [ 0.1, 0., 0., 0. ]\n";
    }
    ~Shared() { std::remove(file.c_str()); }
    Shared(const Shared&) = delete;
    Shared& operator=(const Shared&) = delete;

    const Scene scene;
    const cv::Matx33d K = paperCamera();
    const cv::Mat D{1, 4, CV_64F, cv::Scalar(0)};
    const cv::Ptr<cv::gmlpnp::CameraModel> camera = cv::gmlpnp::CameraModel::pinhole(K, D);
    cv::gmlpnp::Result nearby;  // to the pose
    const cv::String file;
};

using Bits = std::vector<double>;

struct Function
{
    const char* name;
    std::function<Bits(const Shared&)> call;
};

std::vector<Function> everyFunction();

}  // namespace opencv_test

#endif  // OPENCV_TEST_GMLPNP_EVERY_FUNCTION_HPP
