// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

// No heap inside a round: a call that runs many rounds allocates exactly as often as one that runs few.

#include <gtest/gtest.h>

#include <cstdlib>
#include <vector>

#include "hooks.hpp"
#include "opencv2/gmlpnp.hpp"

namespace {

struct Data
{
    std::vector<cv::Point3d> points;
    std::vector<cv::Vec3d> rays;
};

Data noisyData(int n)
{
    cv::RNG rng(7);
    Data data;
    for (int i = 0; i < n; ++i) {
        const cv::Vec3d X(rng.uniform(-2., 2.), rng.uniform(-2., 2.), rng.uniform(4., 8.));
        data.rays.push_back(X);
        data.points.emplace_back(X[0] + rng.gaussian(.1), X[1] + rng.gaussian(.05), X[2] + rng.gaussian(.02));
    }
    return data;
}

long allocationsOf(const Data& data, int method, int rounds)
{
    cv::gmlpnp::Params params;
    params.method = method;
    params.maxRounds = rounds;
    params.tolerance = 0;  // run them all
    cv::gmlpnp::Result result;
    const long before = allocation::made();
    const bool solved = cv::gmlpnp::solveRays(data.points, data.rays, result, params);
    const long count = allocation::made() - before;
    EXPECT_TRUE(solved);
    EXPECT_EQ(rounds, result.rounds);
    return count;
}

class Allocation : public testing::Test
{
protected:
    void SetUp() override
    {
        if (!allocation::counted())
            GTEST_SKIP() << "allocations cannot be counted under a sanitizer or without glibc";
    }
};

TEST_F(Allocation, theCounterFires)
{
    const long before = allocation::made();
    void* volatile block = std::malloc(100);
    std::free(block);
    EXPECT_EQ(before + 1, allocation::made());
    const cv::Mat mat(100, 100, CV_64F);
    EXPECT_GT(allocation::made(), before + 1) << "not in OpenCV's library";
}

TEST_F(Allocation, noneInARound)
{
    for (int method : {cv::gmlpnp::SOLVEPNP_GMLPNP, cv::gmlpnp::SOLVEPNP_GMLPNP_MARGINAL})
        for (int n : {10, 200}) {
            const Data data = noisyData(n);
            allocationsOf(data, method, 2);  // whatever a first call sets up
            const long few = allocationsOf(data, method, 2);
            EXPECT_GT(few, 0);
            EXPECT_EQ(few, allocationsOf(data, method, 40)) << "method " << method << ", n " << n;
        }
}

}  // namespace
