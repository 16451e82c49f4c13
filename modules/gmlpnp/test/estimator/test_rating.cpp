// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../../src/estimator/initial_pose.hpp"
#include "../../src/estimator/rating.hpp"
#include "../../src/noise/model.hpp"
#include "../scenes.hpp"

namespace opencv_test {
namespace {

using namespace cv::gmlpnp::detail;

// Squares of points ten sides away, seen with noise of a pixel: most have a mirror image that fits nearly as well.
Scene squareScene(cv::RNG& rng, int n)
{
    const Matrix3d R = randomRotation(rng);
    std::vector<Vector3d> points(n);
    for (Vector3d& X : points)
        X = R * Vector3d(rng.uniform(-0.5, 0.5), rng.uniform(-0.5, 0.5), 0) + Vector3d(0, 0, 10);
    Scene scene = exactScene(rng, points);
    disturb(rng, scene, 0, 1, *cv::gmlpnp::CameraModel::pinhole(paperCamera()));
    return scene;
}

// The limit of the EM algorithm, which never raises L and knows no prior.
double leastCost(const Correspondences& data, const Pose& pose, NoiseKind kind, const IsotropicNoise& start)
{
    const int n = data.size();
    const auto toObject = [&](const Matrix3d& M) { return Matrix3d(pose.R.transpose() * M * pose.R); };
    Noise noise = isotropic(start.a, start.b);
    for (int k = 0; k < 500; ++k) {
        const RaySums sums = rayPass(data, pose, noise);
        if (kind == NoiseKind::OBJECT)
            noise.Sigma = emUpdate(noise.Sigma, toObject(sums.Zo), toObject(sums.Go), n);
        else
            noise.Gamma = emUpdate(noise.Gamma, sums.Zb, sums.Gb, n);
    }
    return rayPass(data, pose, noise).L;
}

TEST(Gmlpnp_Rating, isTheLeastCostOfEitherNoise)
{
    cv::RNG rng = testRng();
    for (int k = 0; k < 20; ++k) {
        // Noise of one shape: of a nearly singular one the prior of the shape keeps the rating away.
        Scene scene = exactScene(rng, boxPoints(rng, 100));
        cv::Mat_<double> noisy = k % 2 ? scene.objectPoints : scene.rays;
        std::for_each(noisy.begin(), noisy.end(), [&](double& x) { x += rng.gaussian(k % 2 ? 0.1 : 0.002); });
        const Correspondences data(scene.objectPoints, scene.rays);
        const Pose minimum = initialPoses(data).at(0).pose;
        const IsotropicSplit split = splitResiduals(data, minimum);
        const double object = leastCost(data, minimum, NoiseKind::OBJECT, split.object);
        const double bearing = leastCost(data, minimum, NoiseKind::BEARING, split.bearing);
        const double least = std::min(object + priorCost(NoiseKind::OBJECT, split), bearing);
        const double rated = costOfMinimum(data, minimum, false);
        EXPECT_GT(rated, least - 0.05);
        EXPECT_LT(rated, least + 1);  // nat: the prior weighs two of the hundred points
    }
}

TEST(Gmlpnp_Rating, choosesTheMinimumThatIsRefined)
{
    cv::RNG rng = testRng();
    int several = 0, otherThanTheCost = 0, otherThanTheEnd = 0;
    for (int k = 0; k < 400; ++k) {
        const Scene scene = squareScene(rng, 6 + k % 40);
        const Correspondences data(scene.objectPoints, scene.rays);
        const std::vector<PoseCandidate> minima = initialPoses(data);
        if (minima.size() < 2)
            continue;
        const auto best = std::min_element(minima.begin(), minima.end(), [&](const auto& a, const auto& b) {
            return costOfMinimum(data, a.pose, true) < costOfMinimum(data, b.pose, true);
        });
        several++;
        otherThanTheCost += best != minima.begin();
        cv::gmlpnp::Result result;
        ASSERT_TRUE(cv::gmlpnp::solveRays(scene.objectPoints, scene.rays, result));
        const Pose found = data.fromObject(poseOf(result));
        const auto nearest = std::min_element(minima.begin(), minima.end(), [&](const auto& a, const auto& b) {
            return rotationAngle(a.pose.R, found.R) < rotationAngle(b.pose.R, found.R);
        });
        EXPECT_EQ(best - minima.begin(), nearest - minima.begin()) << k;
        std::vector<cv::gmlpnp::Result> all;
        ASSERT_GE(cv::gmlpnp::solveAll(scene.objectPoints, scene.imagePoints, paperCamera(), cv::noArray(), all), 1);
        otherThanTheEnd += rotationAngle(poseOf(all[0].rvec, {}).R, found.R) > 0.05;
    }
    EXPECT_GT(several, 100);
    EXPECT_GT(otherThanTheCost, 3);
    EXPECT_GT(otherThanTheEnd, 3);
}

}  // namespace
}  // namespace opencv_test
