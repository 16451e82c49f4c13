// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../expect_error.hpp"
#include "../scenes.hpp"
#include "../statistics.hpp"

// Covariances known of each point.

namespace opencv_test {
namespace {

using namespace cv::gmlpnp::detail;
using cv::gmlpnp::Params;
using cv::gmlpnp::Result;

cv::Mat_<double> asRow(const Matrix3d& C)
{
    cv::Mat_<double> row(1, 9);
    for (int k = 0; k < 9; ++k)
        row(k) = C(k / 3, k % 3);
    return row;
}

TEST(Gmlpnp_Noise, covariancesOfAllPointsAlikeAreKnownNoise)
{
    cv::RNG rng = testRng();
    const Scene scene = paperScene(rng, 40, 0.1, 1);
    const cv::Mat zero = cv::Mat::zeros(3, 3, CV_64F);
    Params known, each;
    known.bearingNoise = each.bearingNoise = zero;
    each.objectNoise = zero;
    known.objectNoise = asRow(scene.Sigma + 1e-3 * Matrix3d::Identity()).reshape(1, 3);
    cv::repeat(known.objectNoise.reshape(1, 1), 40, 1, each.objectCovariances);
    const Result a = solvedPixels(scene, known), b = solvedPixels(scene, each);
    EXPECT_TRUE(poseNear(b, poseOf(a), 1e-7, 1e-7));
    EXPECT_NEAR(a.cost, b.cost, 1e-6);
    EXPECT_LT(cv::norm(a.poseCovariance, b.poseCovariance), 1e-6 * cv::norm(a.poseCovariance));
}

// Half of the points ten times worse, and known to be: the estimate uses it.
TEST(Gmlpnp_NoiseStatistics, objectCovariancesHelp)
{
    cv::RNG rng = testRng();
    RatioOfMeans ratio;
    for (int k = 0; k < 100; ++k) {
        Scene scene = exactScene(rng, boxPoints(rng, 40));
        cv::Mat_<double> rows(0, 9);
        for (int i = 0; i < 40; ++i) {
            const double sigma = i % 2 ? 0.2 : 0.02;
            const Vector3d e = sigma * gaussian3(rng);
            for (int a = 0; a < 3; ++a)
                scene.objectPoints(i, a) += e(a);
            rows.push_back(asRow(sigma * sigma * Matrix3d::Identity()));
        }
        Params params;
        params.robust = false;
        const double without = distance(solvedPixels(scene, params), scene);
        params.objectCovariances = rows;
        ratio.add(distance(solvedPixels(scene, params), scene), without);
    }
    EXPECT_TRUE(atMost(ratio.value(), 0.45, ratio.deviation()));
}

TEST(Gmlpnp_NoiseStatistics, pixelCovariancesHelpInEitherForm)
{
    cv::RNG rng = testRng();
    RatioOfMeans ratio;
    for (int k = 0; k < 100; ++k) {
        Scene scene = exactScene(rng, boxPoints(rng, 40));
        cv::Mat_<double> variances(40, 1), matrices(40, 4, 0.0);
        for (int i = 0; i < 40; ++i) {
            const double sigma = i % 2 ? 10 : 1;
            scene.imagePoints(i, 0) += rng.gaussian(sigma);
            scene.imagePoints(i, 1) += rng.gaussian(sigma);
            variances(i) = matrices(i, 0) = matrices(i, 3) = sigma * sigma;
        }
        Params params;
        params.robust = false;
        const double without = distance(solvedPixels(scene, params), scene);
        params.pixelCovariances = variances;
        const Result a = solvedPixels(scene, params);
        ratio.add(distance(a, scene), without);
        params.pixelCovariances = matrices;
        EXPECT_TRUE(poseNear(solvedPixels(scene, params), poseOf(a), 1e-12, 1e-12));
    }
    EXPECT_TRUE(atMost(ratio.value(), 0.45, ratio.deviation()));
}

TEST(Gmlpnp_Noise, wrongCovariancesAreRefusedAndThePointNamed)
{
    cv::RNG rng = testRng();
    const Scene scene = paperScene(rng, 10, 0.1, 1);
    Params params;
    const auto refused = [&](int code, const std::string& words) {
        Result result;
        expectError(code, words, [&] {
            cv::gmlpnp::solve(scene.objectPoints, scene.imagePoints, paperCamera(), cv::noArray(), result, params);
        });
    };
    cv::repeat(asRow(Matrix3d::Identity()), 10, 1, params.objectCovariances);
    params.objectCovariances.at<double>(7, 4) = -1;
    refused(cv::Error::StsBadArg, "objectCovariances: point 7");
    params.objectCovariances = cv::Mat::ones(10, 6, CV_64F);
    refused(cv::Error::StsAssert, "objectCovariances must have one row per point, with 9 numbers");
    params.objectCovariances = cv::Mat::zeros(9, 9, CV_64F);
    refused(cv::Error::StsAssert, "objectCovariances must have one row per point, with 9 numbers; there are 10 points");
    params.objectCovariances = cv::Mat::zeros(9, 10, CV_64F);  // transposed
    refused(cv::Error::StsAssert, "objectCovariances must have one row per point, with 9 numbers; there are 10 points");
    params.objectCovariances = cv::Mat(90, 20, CV_64F, cv::Scalar(0)).colRange(0, 1);
    refused(cv::Error::StsAssert, "objectCovariances must have one row per point, with 9 numbers; there are 10 points");
    params = Params();
    params.objectNoise = -1e160 * cv::Mat::eye(3, 3, CV_64F);
    refused(cv::Error::StsBadArg, "objectNoise must be symmetric positive semidefinite");
    params = Params();
    params.method = cv::gmlpnp::SOLVEPNP_GMLPNP;
    params.objectNoise = cv::Mat::zeros(3, 3, CV_64F);
    refused(cv::Error::StsBadArg, "objectNoise and bearingNoise are both zero");
    params = Params();
    params.pixelCovariances = cv::Mat::ones(10, 1, CV_32F);
    params.pixelCovariances.at<float>(3) = -2;
    refused(cv::Error::StsBadArg, "pixelCovariances: point 3");
    params.pixelCovariances.at<float>(3) = std::nanf("");
    refused(cv::Error::StsBadArg, "pixelCovariances: point 3");
    params.pixelCovariances = cv::Mat::ones(10, 2, CV_64F);
    refused(cv::Error::StsAssert, "pixelCovariances must have one row per point, with 1 or 4 numbers");
    params.pixelCovariances = cv::Mat::ones(10, 1, CV_64F);
    Result result;
    EXPECT_THROW(cv::gmlpnp::solveRays(scene.objectPoints, scene.rays, result, params), cv::Exception);
}

}  // namespace
}  // namespace opencv_test
