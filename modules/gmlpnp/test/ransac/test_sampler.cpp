// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../../src/ransac/sampler.hpp"
#include "../scenes.hpp"
#include "../statistics.hpp"

namespace opencv_test {
namespace {

using namespace cv::gmlpnp::detail;

TEST(Gmlpnp_RansacStatistics, samplesAreDistinctAndEquallyLikely)
{
    constexpr int N = 7, DRAWS = 70000;
    Sampler sampler(N, 1, false, DRAWS);
    int count[N] = {};
    for (int k = 0; k < DRAWS; ++k) {
        const Sample s = sampler.next();
        ASSERT_TRUE(s[0] != s[1] && s[1] != s[2] && s[2] != s[0]);
        for (const int i : s) {
            ASSERT_TRUE(i >= 0 && i < N);
            ++count[i];
        }
    }
    for (const int c : count)
        EXPECT_TRUE(shareWithin(c, DRAWS, 3. / N, 3. / N));
}

TEST(Gmlpnp_Ransac, samplesDependOnTheSeedAlone)
{
    // The numbers are part of the promise: the same on every platform.
    Sampler sampler(1000, 42, false, 10), again(1000, 42, false, 10), other(1000, 43, false, 10);
    const Sample first = sampler.next();
    EXPECT_EQ((Sample{140, 48, 29}), first);
    EXPECT_EQ(first, again.next());
    EXPECT_NE(first, other.next());
}

TEST(Gmlpnp_Ransac, orderedSamplesStartWithTheBest)
{
    constexpr int N = 100;
    Sampler sampler(N, 1, true, 10000);
    Sample s = sampler.next();
    std::sort(s.begin(), s.end());
    EXPECT_EQ((Sample{0, 1, 2}), s);
    for (int pool = 3; pool < N;) {
        s = sampler.next();
        ASSERT_GE(sampler.pool(), pool);  // Eq. (3) of the paper: grows, and never past all points
        ASSERT_LE(sampler.pool(), N);
        pool = sampler.pool();
        const int last = *std::max_element(s.begin(), s.end());
        ASSERT_TRUE(pool == N || last == pool - 1) << "the newest of a pool of " << pool << " is in each sample";
    }
}

TEST(Gmlpnp_Ransac, orderedSamplesComeToAllPoints)
{
    for (const int n : {4, 20, 300, 20000})
        for (const int most : {40, 1000, 10000, 1000000}) {
            Sampler sampler(n, 1, true, most);
            for (int k = 0; k < most; ++k)
                sampler.next();
            EXPECT_EQ(n, sampler.pool()) << most << " samples";
            EXPECT_GE(sampler.ofAll(), 0.7 * most) << n << " points, " << most << " samples";
        }
}

}  // namespace
}  // namespace opencv_test
