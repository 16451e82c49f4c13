// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../statistics.hpp"
#include "matching_problem.hpp"

namespace opencv_test {
namespace {

using namespace matching;

// All that so many points fill the lanes of.
std::vector<const RayKernels*> kernelsFor(int n)
{
    std::vector<const RayKernels*> out;
    for (const RayKernels* kernels : availableKernels())
        if (kernels->lanes <= n)
            out.push_back(kernels);
    return out;
}

TEST(Gmlpnp_Ransac, scoreIsItsDefinition)
{
    cv::RNG rng = testRng();
    for (const int n : {4, 7, 8, 9, 63, 64, 65, 500}) {
        const MatchingProblem problem(rng, n, 0.3);
        for (const RayKernels* kernels : kernelsFor(n)) {
            SCOPED_TRACE(testing::Message() << kernels->name << ", " << n << " points");
            const ScoredPoints points(problem.data, problem.metrics, rng, *kernels);
            for (const double size : {1e-3, 1e-2, 1.}) {
                const Pose pose = near(rng, problem.data.fromObject(problem.scene.truth), size);
                const Score expected = problem.score(pose), found = points.score(pose);
                EXPECT_NEAR(expected.cost, found.cost, 1e-9 * n);
                EXPECT_EQ(expected.inliers, found.inliers);
                EXPECT_EQ(problem.inliers(pose), points.inliers(pose));
            }
        }
    }
}

TEST(Gmlpnp_Ransac, robustStepIsItsDefinition)
{
    cv::RNG rng = testRng();
    for (const int n : {6, 7, 8, 9, 10, 65, 500})
        for (const double width : {1.5, 3.}) {
            const MatchingProblem problem(rng, n, 0.3);
            const Pose pose = near(rng, problem.data.fromObject(problem.scene.truth), 3e-3);
            const Pose expected = problem.stepped(pose, width);
            for (const RayKernels* kernels : kernelsFor(n)) {
                Pose found = pose;
                ASSERT_TRUE(ScoredPoints(problem.data, problem.metrics, rng, *kernels).step(found, width, n));
                EXPECT_TRUE(poseNear(found, expected, 1e-6, 1e-6)) << kernels->name << ", " << n << " points";
            }
        }
}

TEST(Gmlpnp_RansacStatistics, givingUpEarlySparesTheBetter)
{
    cv::RNG rng = testRng();
    int better = 0, lost = 0, worse = 0, spared = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        const MatchingProblem problem(rng, 400, rng.uniform(0., 0.9));
        const ScoredPoints points(problem.data, problem.metrics, rng);
        const Pose truth = problem.data.fromObject(problem.scene.truth);
        const Score a = points.score(near(rng, truth, 3e-3));
        const Pose b = trial % 2 ? near(rng, truth, 3e-3) : Pose{randomRotation(rng), truth.t};
        const Score full = points.score(b), early = points.scoreAgainst(b, a.cost);
        if (std::isfinite(early.cost)) {
            EXPECT_EQ(full.cost, early.cost);
        }
        if (full.cost < a.cost) {
            ++better;
            lost += !std::isfinite(early.cost);
        } else if (trial % 2 == 0) {
            ++worse;
            spared += std::isfinite(early.cost);
        }
    }
    ASSERT_GT(better, 300);
    EXPECT_TRUE(shareAtMost(lost, better, 0.001));
    EXPECT_TRUE(shareAtMost(spared, worse, 0.05));
}

TEST(Gmlpnp_Ransac, robustStepsFindTheTruth)
{
    cv::RNG rng = testRng();
    for (int trial = 0; trial < 50; ++trial) {
        const MatchingProblem problem(rng, exactScene(rng, surroundingPoints(rng, 60)), 0.4);
        const ScoredPoints points(problem.data, problem.metrics, rng);
        const Pose truth = problem.data.fromObject(problem.scene.truth);
        Pose pose = near(rng, truth, 1e-3);
        for (int round = 0; round < 10; ++round)
            ASSERT_TRUE(points.step(pose, 1.5, points.size()));
        // Wrong correspondences that lie within the threshold by chance pull a little.
        EXPECT_TRUE(poseNear(pose, truth, 1e-3, 1e-3)) << "trial " << trial;
    }
}

}  // namespace
}  // namespace opencv_test
