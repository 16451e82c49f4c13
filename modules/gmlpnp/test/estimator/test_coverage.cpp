// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../scenes.hpp"

// Whether the pose covariance holds what it promises.

namespace opencv_test {
namespace {

using namespace cv::gmlpnp::detail;
using cv::gmlpnp::Params;
using cv::gmlpnp::Result;

constexpr double CHI2_6_95 = 12.592;

enum class Made
{
    OBJECT,
    PIXELS,
    BOTH
};

// The first `noisy` points have five times the noise.
Scene sceneOf(cv::RNG& rng, Made made, int n, double halfField, int noisy)
{
    const double slope = std::tan(halfField);
    std::vector<Vector3d> points(n);
    for (Vector3d& X : points) {
        const double x = rng.uniform(-slope, slope), y = rng.uniform(-slope, slope);
        X = rng.uniform(4., 8.) * Vector3d(x, y, 1);
    }
    Scene scene = exactScene(rng, points);
    const Matrix3d root =
        made == Made::PIXELS ? Matrix3d(Matrix3d::Zero()) : Eigen3d(randomNoise(rng, 0.1)).operatorSqrt();
    const double px = made == Made::OBJECT ? 0 : 2;
    for (int i = 0; i < n; ++i) {
        const double times = i < noisy ? 5 : 1;
        const Vector3d e = times * root * gaussian3(rng);
        for (int k = 0; k < 3; ++k)
            scene.objectPoints(i, k) += e(k);
        scene.imagePoints(i, 0) += times * px * rng.gaussian(1);
        scene.imagePoints(i, 1) += times * px * rng.gaussian(0.5);
    }
    return scene;
}

double covered(cv::RNG& rng, Made made, int n, double halfField, double noisy, int trials)
{
    int inside = 0;
    for (int k = 0; k < trials; ++k) {
        const Scene scene = sceneOf(rng, made, n, halfField, cvRound(noisy * n));
        const Result result = solvedPixels(scene, Params());
        inside += mahalanobis2(scene.truth, poseOf(result), result.poseCovariance) < CHI2_6_95;
    }
    return inside / double(trials);
}

// The 95 % ellipsoid of the pose holds the truth in 93 to 97 %, give or take three binomial standard errors.
void expectCovers(int trials, const std::vector<int>& counts, double noisy)
{
    cv::RNG rng = testRng();
    const double error = 3 * std::sqrt(0.95 * 0.05 / trials);
    for (Made made : {Made::OBJECT, Made::PIXELS, Made::BOTH})
        for (double degrees : {15., 60.})
            for (int n : counts) {
                const double share = covered(rng, made, n, degrees * CV_PI / 180, noisy, trials);
                std::cout << "noise " << static_cast<int>(made) << ", half field " << degrees << ", n " << n << ": "
                          << share << std::endl;
                EXPECT_GE(share, 0.93 - error);
                EXPECT_LE(share, 0.97 + error);
            }
}

TEST(Gmlpnp_Noise, poseCovarianceCovers)
{
    expectCovers(300, {15, 50}, 0);
}

TEST(SlowGmlpnp_Noise, poseCovarianceCovers)
{
    expectCovers(2000, {15, 20, 50, 100, 200}, 0);
}

TEST(SlowGmlpnp_Noise, poseCovarianceCoversWithTails)
{
    expectCovers(2000, {15, 20, 50, 200}, 0.1);
}

TEST(SlowGmlpnp_Noise, poseCovarianceCoversWithHeavyTails)
{
    expectCovers(2000, {15, 20, 50, 200}, 0.2);
}

}  // namespace
}  // namespace opencv_test
