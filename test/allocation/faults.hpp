// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_TEST_ALLOCATION_FAULTS_HPP
#define GMLPNP_TEST_ALLOCATION_FAULTS_HPP

#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <vector>

#include "opencv2/gmlpnp.hpp"

// Memory runs out: each allocation of a call fails in turn, alone or with all that follow. The call throws, its outputs
// hold what they held before, and nothing is lost.

namespace allocation {

/** What a call reads. */
struct Scene
{
    std::vector<cv::Point3d> points;
    std::vector<cv::Point2f> pixels;
    std::vector<cv::Vec3d> rays;
    cv::Matx33d K{800, 0, 320, 0, 800, 240, 0, 0, 1};
    cv::Mat_<double> D = (cv::Mat_<double>(1, 5) << 0.1, -0.05, 0.001, -0.001, 0.01);
    cv::Ptr<cv::gmlpnp::CameraModel> camera = cv::gmlpnp::CameraModel::pinhole(K, D);
};

/** What a call writes, in as many forms as outputs have. */
struct Outputs
{
    cv::Mat rvec, tvec;  // empty
    cv::Vec3d rvecFixed{1, 2, 3}, tvecFixed{4, 5, 6};
    std::vector<double> rvecVector{7, 8};  // of another length
    cv::Mat tvecWrong{1, 5, CV_64F, cv::Scalar(1)};
    cv::Vec3d rvecNear{0.05, 0, 0}, tvecNear{0, 0, 19};  // a pose near that of the scene
    cv::Mat rvecRow = (cv::Mat_<double>(1, 3) << 0, 0.05, 0), tvecRow = (cv::Mat_<double>(1, 3) << 0, 0, 21);
    std::vector<cv::Mat> rvecs{cv::Mat(2, 2, CV_64F, cv::Scalar(1))};
    std::vector<cv::Vec3d> tvecs{{1, 1, 1}};
    std::vector<double> errors;
    cv::Mat inliers, rays, valid, jacobian;
    std::vector<cv::Vec3f> raysVector{{1, 2, 3}};
    std::vector<uchar> validVector;
    cv::Mat image{48, 64, CV_8UC3, cv::Scalar::all(0)};
    cv::gmlpnp::Result result;
    std::vector<cv::gmlpnp::Result> results{cv::gmlpnp::Result()};
};

using Call = std::function<void(const Scene&, Outputs&)>;

class Faults : public testing::Test
{
protected:
    void SetUp() override;

    void expectClean(const Call& call) const;

    Scene scene;

private:
    std::set<size_t> theirSizes;  // of allocations after whose failure OpenCV loses a block

    //! False: the call came to its end before that allocation.
    bool failsCleanly(const Call& call, long number, bool onwards) const;
    long lossesOfTheirs() const;
};

}  // namespace allocation

#endif  // GMLPNP_TEST_ALLOCATION_FAULTS_HPP
