// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../scenes.hpp"

// solve() from a pose that the caller knows roughly.

namespace opencv_test {
namespace {

using cv::gmlpnp::Params;
using cv::gmlpnp::Result;

TEST(Gmlpnp_Solve, guessIsHonoured)
{
    cv::RNG rng = testRng();
    for (int method : METHODS) {
        const Scene scene = paperScene(rng, 30, 0.05, 1);
        const Result free = solved(scene, paramsOf(method));
        Params params = paramsOf(method);
        params.useExtrinsicGuess = true;
        params.rvec = free.rvec + cv::Vec3d(0.1, -0.1, 0.05);
        params.tvec = free.tvec + cv::Vec3d(0.3, 0.2, -0.4);
        const Result guided = solved(scene, params);
        EXPECT_TRUE(poseNear(guided, poseOf(free), 2e-3, 1e-2));
    }
    // Another minimum: the mirrored pose of a small flat object, kept only because the guess lies there.
    const cv::Matx33d K = paperCamera();
    const std::vector<cv::Point3d> square = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    std::vector<cv::Point2d> pixels;
    const cv::Vec3d rvec(0.5, 0.1, 0), tvec(0, 0, 40);
    cv::projectPoints(square, rvec, tvec, K, cv::noArray(), pixels);
    Params params;
    params.useExtrinsicGuess = true;
    params.rvec = cv::Vec3d(-0.5, -0.1, 0);
    params.tvec = tvec;
    Result mirrored;
    ASSERT_TRUE(cv::gmlpnp::solve(square, pixels, K, cv::noArray(), mirrored, params));
    EXPECT_TRUE(poseNear(mirrored, poseOf(params.rvec, tvec), 0.2, 1));
    Result best;
    ASSERT_TRUE(cv::gmlpnp::solve(square, pixels, K, cv::noArray(), best));
    EXPECT_TRUE(poseNear(best, poseOf(rvec, tvec), 1e-7, 1e-6));
}

TEST(Gmlpnp_Solve, threePointsWithAGuess)
{
    cv::RNG rng = testRng();
    const Scene scene = exactScene(rng, boxPoints(rng, 3));
    Params params;
    params.useExtrinsicGuess = true;
    const Vector3d rvec = cv::gmlpnp::detail::logSO3(scene.truth.R);
    params.rvec = cv::Vec3d(rvec.x() + 0.02, rvec.y(), rvec.z());
    params.tvec = cv::Vec3d(scene.truth.t.x(), scene.truth.t.y(), scene.truth.t.z() + 0.05);
    const Result result = solved(scene, params);
    EXPECT_TRUE(poseNear(result, scene.truth, 1e-8, 1e-7));
    EXPECT_TRUE(result.poseCovariance.empty());
    Result without;
    EXPECT_FALSE(cv::gmlpnp::solveRays(scene.objectPoints, scene.rays, without));
    EXPECT_EQ(cv::gmlpnp::STATUS_TOO_FEW_POINTS, without.status);
}

TEST(Gmlpnp_Solve, guessesBeyondReasonAreNotFinite)
{
    cv::RNG rng = testRng();
    const Scene scene = paperScene(rng, 10, 0.1, 1);
    for (const double value : {std::nan(""), 1.01e100, -1e160}) {
        Params params;
        params.useExtrinsicGuess = true;
        (value < 0 ? params.rvec : params.tvec)[1] = value;
        Result result;
        EXPECT_FALSE(cv::gmlpnp::solveRays(scene.objectPoints, scene.rays, result, params));
        EXPECT_EQ(cv::gmlpnp::STATUS_NOT_FINITE, result.status);
    }
}

}  // namespace
}  // namespace opencv_test
