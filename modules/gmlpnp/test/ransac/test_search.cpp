// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../../src/ransac/search.hpp"
#include "matching_problem.hpp"

namespace opencv_test {
namespace {

using namespace matching;

TEST(Gmlpnp_Ransac, orderSavesSamples)
{
    cv::RNG rng = testRng();
    int uniform = 0, ordered = 0;
    for (int trial = 0; trial < 20; ++trial) {
        const MatchingProblem problem(rng, 300, 0.85);  // the wrong ones come last
        RansacOptions options{0.99, 10000, static_cast<uint64>(trial), false, 1e-3, std::nullopt};
        const auto a = findConsensus(problem.data, problem.metrics, options);
        options.ordered = true;
        const auto b = findConsensus(problem.data, problem.metrics, options);
        ASSERT_TRUE(a && b);
        EXPECT_TRUE(poseNear(b->pose, problem.scene.truth, 0.02, 0.1));
        uniform += a->iterations;
        ordered += b->iterations;
    }
    EXPECT_LT(10 * ordered, uniform);
}

TEST(Gmlpnp_Ransac, confidenceIsKept)
{
    // Of 80 % wrong correspondences a sample of three is clean with .008; 99 % of the searches must end right.
    cv::RNG rng = testRng();
    int right = 0, iterations = 0;
    constexpr int TRIALS = 300;
    for (int trial = 0; trial < TRIALS; ++trial) {
        const MatchingProblem problem(rng, 200, 0.8);
        const auto found =
            findConsensus(problem.data, problem.metrics, {0.99, 10000, static_cast<uint64>(trial), false, 1e-3, {}});
        ASSERT_TRUE(found);
        right += bool(poseNear(found->pose, problem.scene.truth, 0.05, 0.3));
        iterations += found->iterations;
    }
    EXPECT_GE(right, 290);                // 297 expected, with a standard deviation of 1.7
    EXPECT_LT(iterations, TRIALS * 900);  // one in five clean samples may lead nowhere: 720 are asked for
}

}  // namespace
}  // namespace opencv_test
