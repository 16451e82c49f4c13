// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../../src/ransac/search.hpp"
#include "../statistics.hpp"
#include "matching_problem.hpp"

namespace opencv_test {
namespace {

using namespace matching;

TEST(Gmlpnp_RansacStatistics, orderSavesSamples)
{
    cv::RNG rng = testRng();
    RatioOfMeans ratio;
    for (int trial = 0; trial < 20; ++trial) {
        const MatchingProblem problem(rng, 300, 0.85);  // the wrong ones come last
        RansacOptions options{0.99, 10000, static_cast<uint64>(trial), false, 1e-3, std::nullopt};
        const auto a = findConsensus(problem.data, problem.metrics, options);
        options.ordered = true;
        const auto b = findConsensus(problem.data, problem.metrics, options);
        ASSERT_TRUE(a && b);
        EXPECT_TRUE(poseNear(b->pose, problem.scene.truth, 0.02, 0.1));
        ratio.add(b->iterations, a->iterations);
    }
    EXPECT_TRUE(atMost(ratio.value(), 0.05, ratio.deviation()));
}

TEST(Gmlpnp_RansacStatistics, confidenceIsKept)
{
    // Of 80 % wrong correspondences a sample of three is clean with .008; 99 % of the searches must end right.
    cv::RNG rng = testRng();
    int right = 0;
    Mean iterations;
    constexpr int TRIALS = 600;
    for (int trial = 0; trial < TRIALS; ++trial) {
        const MatchingProblem problem(rng, 200, 0.8);
        const auto found =
            findConsensus(problem.data, problem.metrics, {0.99, 10000, static_cast<uint64>(trial), false, 1e-3, {}});
        ASSERT_TRUE(found);
        right += bool(poseNear(found->pose, problem.scene.truth, 0.05, 0.3));
        iterations.add(found->iterations);
    }
    EXPECT_TRUE(shareAtLeast(right, TRIALS, 0.99));
    // One in five clean samples may lead nowhere: 720 are asked for where the best pose has all inliers, more where
    // not.
    EXPECT_TRUE(atMost(iterations.value(), 900, iterations.deviation()));
}

}  // namespace
}  // namespace opencv_test
