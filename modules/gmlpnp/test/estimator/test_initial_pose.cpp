// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../../src/estimator/initial_pose.hpp"
#include "../scenes.hpp"

namespace opencv_test {
namespace {

using namespace cv::gmlpnp::detail;

Pose bestPose(const Scene& scene)
{
    const Correspondences data(scene.objectPoints, scene.rays);
    const std::vector<PoseCandidate> found = initialPoses(data);
    return found.empty() ? Pose{Matrix3d::Constant(std::nan("")), {}} : data.toObject(found.front().pose);
}

TEST(Gmlpnp_InitialPose, exactInTheBoxFromFivePointsOn)
{
    cv::RNG rng = testRng();
    for (int n : {5, 6, 7, 8, 10, 20, 100})
        for (int k = 0; k < 50; ++k) {
            SCOPED_TRACE(testing::Message() << "n " << n << ", problem " << k);
            const Scene scene = exactScene(rng, boxPoints(rng, n));
            EXPECT_TRUE(poseNear(bestPose(scene), scene.truth, 1e-8, 1e-7));
        }
}

// Four points: the truth is among the minima of cost zero.
TEST(Gmlpnp_InitialPose, exactFromFourPoints)
{
    cv::RNG rng = testRng();
    for (int k = 0; k < 200; ++k) {
        SCOPED_TRACE(k);
        const Scene scene = exactScene(rng, boxPoints(rng, 4));
        const Correspondences data(scene.objectPoints, scene.rays);
        bool found = false;
        for (const PoseCandidate& candidate : initialPoses(data))
            found |= bool(poseNear(data.toObject(candidate.pose), scene.truth, 1e-6, 1e-5));
        EXPECT_TRUE(found);
    }
}

TEST(Gmlpnp_InitialPose, exactOnPlanes)
{
    cv::RNG rng = testRng();
    for (int n : {4, 5, 10, 50})
        for (int k = 0; k < 50; ++k) {
            SCOPED_TRACE(testing::Message() << "n " << n << ", problem " << k);
            const Scene scene = exactScene(rng, boxPoints(rng, n, true));
            EXPECT_TRUE(poseNear(bestPose(scene), scene.truth, 1e-6, 1e-5));
        }
}

TEST(Gmlpnp_InitialPose, exactWithRaysBehindTheImagePlane)
{
    cv::RNG rng = testRng();
    for (int n : {5, 6, 10, 50})
        for (int k = 0; k < 50; ++k) {
            SCOPED_TRACE(testing::Message() << "n " << n << ", problem " << k);
            const Scene scene = exactScene(rng, surroundingPoints(rng, n));
            EXPECT_TRUE(poseNear(bestPose(scene), scene.truth, 1e-8, 1e-7));
        }
}

// No start of an exhaustive search ends below the best minimum.
TEST(Gmlpnp_InitialPose, noStartEndsLower)
{
    cv::RNG rng = testRng();
    for (int k = 0; k < 100; ++k) {
        SCOPED_TRACE(k);
        const int n = rng.uniform(4, 30);
        const Scene scene = k % 2 ? paperScene(rng, n, 0.4, 4) : exactScene(rng, boxPoints(rng, n, true));
        cv::Mat_<double> noisy = scene.objectPoints.clone();
        for (int i = 0; i < n; ++i)
            for (int a = 0; a < 3; ++a)
                noisy(i, a) += rng.gaussian(0.05);
        const Correspondences data(noisy, scene.rays);
        const std::vector<PoseCandidate> found = initialPoses(data);
        ASSERT_FALSE(found.empty());
        const Noise unit{Matrix3d::Identity(), Matrix3d::Zero(), {}};
        for (int start = 0; start < 50; ++start) {
            const Pose pose = isotropicPose(data, {randomRotation(rng), Vector3d(0, 0, 4)});
            const RaySums sums = rayPass(data, pose, unit);
            if (2 * sums.inFront > n) {
                EXPECT_GE(sums.c, found.front().cost * (1 - 1e-6) - 1e-12);
            }
        }
    }
}

TEST(Gmlpnp_InitialPose, minimaAreSortedAndWithinTheRatio)
{
    cv::RNG rng = testRng();
    for (int k = 0; k < 50; ++k) {
        const Scene scene = paperScene(rng, 6, 0.5, 5);
        const Correspondences data(scene.objectPoints, scene.rays);
        const std::vector<PoseCandidate> found = initialPoses(data);
        for (size_t i = 1; i < found.size(); ++i) {
            EXPECT_LE(found[i - 1].cost, found[i].cost);
            EXPECT_LE(found[i].cost, INITIAL_COST_RATIO * found[0].cost + 1e-9);
            EXPECT_GT(rotationAngle(found[i].pose.R, found[0].pose.R), 1e-5);
        }
    }
}

}  // namespace
}  // namespace opencv_test
