// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../scenes.hpp"

// Heavy tails: what they cost and what they save.

namespace opencv_test {
namespace {

using namespace cv::gmlpnp::detail;
using cv::gmlpnp::Params;
using cv::gmlpnp::Result;

// The first `count` points get five times the noise in all.
void contaminate(cv::RNG& rng, Scene& scene, int count)
{
    const Matrix3d root = Eigen3d(24 * scene.Sigma).operatorSqrt();
    for (int i = 0; i < count; ++i) {
        const Vector3d e = root * gaussian3(rng);
        for (int k = 0; k < 3; ++k)
            scene.objectPoints(i, k) += e(k);
    }
}

TEST(Gmlpnp_Noise, tailsCostNothingOnGaussianDataAndSaveTheRest)
{
    cv::RNG rng = testRng();
    for (int bad : {0, 5}) {
        double robust = 0, gaussian = 0;
        int tails = 0;
        for (int k = 0; k < 400; ++k) {
            Scene scene = paperScene(rng, 50, 0.1, 1);
            contaminate(rng, scene, bad);
            Params params;
            const Result withTails = solvedPixels(scene, params);
            params.robust = false;
            const Result without = solvedPixels(scene, params);
            EXPECT_TRUE(std::isinf(without.tailDof));
            robust += distance(withTails, scene);
            gaussian += distance(without, scene);
            tails += std::isfinite(withTails.tailDof);
        }
        if (bad == 0) {
            EXPECT_LT(robust / gaussian, 1.01);
            EXPECT_LT(tails, 40);
        } else {
            EXPECT_LT(robust / gaussian, 0.8);
            EXPECT_GT(tails, 320);
        }
    }
}

// A Gaussian fitted to 20 points of which four are wild is so wide that none looks wild: the tails must show all the
// same.
TEST(Gmlpnp_Noise, tailsShowAmongFewPoints)
{
    cv::RNG rng = testRng();
    for (int bad : {0, 4}) {
        double robust = 0, gaussian = 0;
        for (int k = 0; k < 1000; ++k) {
            Scene scene = paperScene(rng, 20, 0.1, 1);
            contaminate(rng, scene, bad);
            Params params;
            robust += distance(solvedPixels(scene, params), scene);
            params.robust = false;
            gaussian += distance(solvedPixels(scene, params), scene);
        }
        EXPECT_LT(robust / gaussian, bad == 0 ? 1.02 : 0.7) << bad;
    }
}

// Pixels that are sharp in one direction and seen of a small object: the noise is all but singular, and scoring alone,
// which takes the expected curvature for the true one, ran away from it.
TEST(Gmlpnp_Noise, isFoundWhereItIsAllButSingular)
{
    cv::RNG rng = testRng();
    const cv::Matx33d K = paperCamera();
    double marginal = 0, published = 0;
    for (int k = 0; k < 100; ++k) {
        Scene scene = paperScene(rng, 400, 0, 0);
        scene.objectPoints *= 0.1;  // 60 px
        for (int i = 0; i < 400; ++i) {
            const double sharp = rng.gaussian(0.02), blurred = rng.gaussian(1);
            const Vector3d p(scene.objectPoints(i, 0), scene.objectPoints(i, 1), scene.objectPoints(i, 2));
            const Vector3d x = scene.truth * p / (scene.truth * p).z();
            scene.imagePoints(i, 0) = K(0, 0) * x(0) + K(0, 2) + std::cos(k) * sharp - std::sin(k) * blurred;
            scene.imagePoints(i, 1) = K(1, 1) * x(1) + K(1, 2) + std::sin(k) * sharp + std::cos(k) * blurred;
        }
        Params params;
        const Result found = solvedPixels(scene, params);
        EXPECT_TRUE(std::isinf(found.tailDof)) << k;
        marginal += distance(found, scene);
        params.method = cv::gmlpnp::SOLVEPNP_GMLPNP;
        published += distance(solvedPixels(scene, params), scene);
    }
    EXPECT_LT(marginal / published, 1.05);  // at one depth the two are the same estimate
}

TEST(Gmlpnp_Noise, weightsNameTheOutliers)
{
    cv::RNG rng = testRng();
    Scene scene = paperScene(rng, 60, 0.05, 1);
    for (int i = 0; i < 3; ++i)
        scene.imagePoints(i, 0) += 200;
    const Result result = solvedPixels(scene, Params());
    ASSERT_EQ(cv::Size(1, 60), result.weights.size());
    double mean = 0;
    for (int i = 3; i < 60; ++i)
        mean += result.weights.at<double>(i) / 57;
    EXPECT_GT(mean, 0.9);
    for (int i = 0; i < 3; ++i)
        EXPECT_LT(result.weights.at<double>(i), 0.1);
    EXPECT_TRUE(poseNear(result, scene.truth, 0.02, 0.1));
}

}  // namespace
}  // namespace opencv_test
