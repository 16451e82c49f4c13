// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../scenes.hpp"

// Noise that the caller knows, of all points alike or of each.

namespace opencv_test {
namespace {

using cv::gmlpnp::Params;
using cv::gmlpnp::Result;

TEST(Gmlpnp_Solve, knownNoiseIsReturnedAsGiven)
{
    cv::RNG rng = testRng();
    const Scene scene = paperScene(rng, 30, 0.1, 1);
    const cv::Mat_<double> Sigma = (cv::Mat_<double>(3, 3) << 0.02, 0.001, 0, 0.001, 0.01, 0, 0, 0, 0.005);
    const cv::Mat Gamma = cv::Mat::eye(3, 3, CV_64F) * 1e-6;
    for (int method : METHODS) {
        Params params = paramsOf(method);
        params.objectNoise = Sigma;
        params.bearingNoise = Gamma;
        const Result result = solved(scene, params);
        EXPECT_LT(cv::norm(result.objectNoise, Sigma), 1e-12);
        EXPECT_LT(cv::norm(result.bearingNoise, Gamma), 1e-18);
        EXPECT_EQ(cv::gmlpnp::STATUS_CONVERGED, result.status);
        // Twice the noise, the same pose, four times the covariance.
        params.objectNoise = Sigma * 4;
        params.bearingNoise = Gamma * 4;
        const Result doubled = solved(scene, params);
        EXPECT_TRUE(poseNear(doubled, poseOf(result), 1e-6, 1e-6));
        EXPECT_LT(cv::norm(doubled.poseCovariance, 4 * result.poseCovariance), 1e-4 * cv::norm(doubled.poseCovariance));
    }
}

// The marginal method estimates what is not given.
TEST(Gmlpnp_Solve, theOtherNoiseIsEstimated)
{
    cv::RNG rng = testRng();
    const Scene scene = paperScene(rng, 200, 0, 2);
    Params params;
    params.objectNoise = cv::Mat::zeros(3, 3, CV_64F);
    const Result result = solved(scene, params);
    EXPECT_LT(cv::norm(result.objectNoise), 1e-18);
    const double sigma = std::sqrt(result.bearingNoise.at<double>(0, 0)) * 800;
    EXPECT_GT(sigma, 0.2);
    EXPECT_LT(sigma, 3);
}

TEST(Gmlpnp_Solve, publishedRankIsReported)
{
    cv::RNG rng = testRng();
    const Scene scene = paperScene(rng, 50, 0.1, 1);
    EXPECT_EQ(2, solved(scene, paramsOf(cv::gmlpnp::SOLVEPNP_GMLPNP)).objectNoiseRank);
    EXPECT_EQ(3, solved(scene, Params()).objectNoiseRank);
}

// One point is far more precise than the others: its residual at the isotropic pose is many of its standard deviations.
// The pose is the one that the truth as a guess leads to.
TEST(Gmlpnp_Solve, knownNoisesOfVeryDifferentSizes)
{
    cv::RNG rng = testRng();
    constexpr int N = 20;
    for (const double precise : {1e-2, 1e-4, 0.})  // of the others' standard deviation
        for (const bool pixels : {true, false})
            for (int k = 0; k < 20; ++k) {
                Scene scene = exactScene(rng, boxPoints(rng, N));
                const double sigma = pixels ? 5 : 0.3;
                Params params;
                params.objectNoise = params.bearingNoise = cv::Mat::zeros(3, 3, CV_64F);
                cv::Mat_<double> known(N, pixels ? 1 : 9, 0.);
                for (int i = 0; i < N; ++i) {
                    const double own = i == 7 ? precise * sigma : sigma;
                    cv::Mat_<double>& noisy = pixels ? scene.imagePoints : scene.objectPoints;
                    for (int axis = 0; axis < noisy.cols; ++axis)
                        noisy(i, axis) += own * rng.gaussian(1);
                    for (int entry = 0; entry < known.cols; entry += 4)
                        known(i, entry) = own * own;
                }
                (pixels ? params.pixelCovariances : params.objectCovariances) = known;
                SCOPED_TRACE(testing::Message() << precise << (pixels ? ", pixels " : ", points ") << k);
                Result result, fromTruth;
                ASSERT_TRUE(cv::gmlpnp::solve(scene.objectPoints, scene.imagePoints, paperCamera(), cv::noArray(),
                                              result, params));
                const Vector3d r = cv::gmlpnp::detail::logSO3(scene.truth.R), t = scene.truth.t;
                params.useExtrinsicGuess = true;
                params.rvec = {r.x(), r.y(), r.z()};
                params.tvec = {t.x(), t.y(), t.z()};
                ASSERT_TRUE(cv::gmlpnp::solve(scene.objectPoints, scene.imagePoints, paperCamera(), cv::noArray(),
                                              fromTruth, params));
                EXPECT_EQ(cv::gmlpnp::STATUS_CONVERGED, result.status);
                EXPECT_LT(result.cost, fromTruth.cost + 0.1);
            }
}

// What objectNoise may be, each point's covariance may be too: of rank one, or zero for some points.
TEST(Gmlpnp_Solve, singularCovariancesOfPointsAreNoReasonToRefuse)
{
    cv::RNG rng = testRng();
    constexpr int N = 20;
    for (const bool noisy : {false, true})
        for (const bool others : {false, true}) {  // whether the rest of the noise is estimated
            SCOPED_TRACE(testing::Message() << noisy << others);
            Scene scene = exactScene(rng, boxPoints(rng, N));
            Params params;
            if (!others)
                params.objectNoise = params.bearingNoise = cv::Mat::zeros(3, 3, CV_64F);
            params.objectCovariances = cv::Mat::zeros(N, 9, CV_64F);
            for (int i = 0; i < N; ++i) {
                params.objectCovariances.at<double>(i, 8) = 0.0025;
                scene.objectPoints(i, 2) += noisy ? rng.gaussian(0.05) : 0;
            }
            Result result;
            EXPECT_TRUE(cv::gmlpnp::solveRays(scene.objectPoints, scene.rays, result, params));
            EXPECT_TRUE(poseNear(result, scene.truth, noisy ? 0.05 : 1e-6, noisy ? 0.3 : 1e-5));
            params.objectCovariances = cv::Mat();
            params.pixelCovariances = cv::Mat(N, 1, CV_64F, cv::Scalar(0.25));
            params.pixelCovariances.at<double>(3) = 0;
            Scene seen = exactScene(rng, boxPoints(rng, N));
            for (int i = 0; i < N; ++i)
                seen.imagePoints(i, 0) += noisy && i != 3 ? rng.gaussian(0.5) : 0;
            EXPECT_TRUE(
                cv::gmlpnp::solve(seen.objectPoints, seen.imagePoints, paperCamera(), cv::noArray(), result, params));
            EXPECT_TRUE(poseNear(result, seen.truth, noisy ? 0.01 : 1e-6, noisy ? 0.05 : 1e-5));
        }
}

}  // namespace
}  // namespace opencv_test
