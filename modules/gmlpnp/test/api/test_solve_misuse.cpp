// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../expect_error.hpp"
#include "../scenes.hpp"

// Bad data are a status, wrong arguments an error that names them.

namespace opencv_test {
namespace {

using cv::gmlpnp::Params;
using cv::gmlpnp::Result;

TEST(Gmlpnp_Solve, badDataIsAStatusAndTouchesNothing)
{
    cv::RNG rng = testRng();
    const Scene scene = paperScene(rng, 10, 0.1, 1);
    const Result before = solved(scene, Params());
    cv::Mat_<double> nan = scene.objectPoints.clone(), line = scene.objectPoints.clone(), place(10, 3, 1.5),
                     zero = scene.rays.clone();
    nan(3, 1) = std::nan("");
    zero.row(4) = 0;
    cv::Mat_<double> huge = scene.objectPoints.clone(), tiny = huge.clone();
    huge *= 1e101;
    tiny *= 1e-101;
    for (int i = 0; i < 10; ++i)
        line(i, 0) = i, line(i, 1) = 2 * i, line(i, 2) = -i;
    cv::Mat_<double> threePlaces = scene.objectPoints.clone(), theirRays = scene.rays.clone();
    for (int i = 3; i < 10; ++i) {
        threePlaces.row(i % 3).copyTo(threePlaces.row(i));
        theirRays.row(i % 3).copyTo(theirRays.row(i));
    }
    const struct
    {
        cv::Mat_<double> points, rays;
        int status;
    } cases[] = {{nan, scene.rays, cv::gmlpnp::STATUS_NOT_FINITE},
                 {huge, scene.rays, cv::gmlpnp::STATUS_NOT_FINITE},
                 {scene.objectPoints, zero, cv::gmlpnp::STATUS_NOT_FINITE},
                 {line, scene.rays, cv::gmlpnp::STATUS_DEGENERATE},
                 {place, scene.rays, cv::gmlpnp::STATUS_DEGENERATE},
                 {tiny, scene.rays, cv::gmlpnp::STATUS_DEGENERATE},
                 {scene.objectPoints.rowRange(0, 3), scene.rays.rowRange(0, 3), cv::gmlpnp::STATUS_TOO_FEW_POINTS},
                 {threePlaces, theirRays, cv::gmlpnp::STATUS_TOO_FEW_POINTS}};
    for (int method : METHODS)
        for (const auto& bad : cases) {
            Result result = before;
            const cv::Mat points = bad.points.clone(), rays = bad.rays.clone();
            EXPECT_FALSE(cv::gmlpnp::solveRays(points, rays, result, paramsOf(method)));
            EXPECT_EQ(bad.status, result.status);
            EXPECT_EQ(before.rvec, result.rvec);
            EXPECT_EQ(before.tvec, result.tvec);
            EXPECT_EQ(before.cost, result.cost);
            EXPECT_EQ(before.poseCovariance.data, result.poseCovariance.data);
            EXPECT_EQ(0, std::memcmp(points.data, bad.points.data, points.total() * sizeof(double))) << "input written";
        }
}

TEST(Gmlpnp_Solve, misuseThrowsAndNamesTheArgument)
{
    cv::RNG rng = testRng();
    const Scene scene = paperScene(rng, 10, 0.1, 1);
    Params params;
    const auto refused = [&](const std::string& name) {
        Result result;
        expectError(cv::Error::StsBadArg, name,
                    [&] { cv::gmlpnp::solveRays(scene.objectPoints, scene.rays, result, params); });
    };
    params.method = 42;
    refused("method");
    params = Params();
    params.maxRounds = -1;
    refused("maxRounds");
    params = Params();
    params.tolerance = std::nan("");
    refused("tolerance");
    params = Params();
    params.objectNoise = (cv::Mat_<double>(3, 3) << 1, 2, 0, 2, 1, 0, 0, 0, 1);  // not positive semidefinite
    refused("objectNoise");
    params = Params();
    params.bearingNoise = (cv::Mat_<double>(3, 3) << 1, 0, 0, 0.5, 1, 0, 0, 0, 1);  // not symmetric
    refused("bearingNoise");
    params.bearingNoise = 1e61 * cv::Mat::eye(3, 3, CV_64F);  // the covariance of the pose would have no numbers
    refused("bearingNoise");
    params = Params();
    params.objectNoise = params.bearingNoise = cv::Mat::zeros(3, 3, CV_64F);
    params.objectCovariances = cv::Mat(10, 9, CV_64F, cv::Scalar(std::nan("")));
    refused("objectCovariances");
    Result result;
    params = Params();
    params.objectNoise = cv::Mat::eye(2, 2, CV_64F);
    EXPECT_THROW(cv::gmlpnp::solveRays(scene.objectPoints, scene.rays, result, params), cv::Exception);
    EXPECT_THROW(cv::gmlpnp::solveRays(scene.objectPoints, scene.rays.rowRange(0, 9), result), cv::Exception);
    EXPECT_THROW(cv::gmlpnp::solve(scene.objectPoints, scene.imagePoints, cv::Ptr<cv::gmlpnp::CameraModel>(), result),
                 cv::Exception);
}

}  // namespace
}  // namespace opencv_test
