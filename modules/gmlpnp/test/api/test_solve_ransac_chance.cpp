// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "observed.hpp"

// Where nothing fits, a pose is found as rarely as is allowed for.

namespace opencv_test {
namespace {

using namespace ransac;

TEST(Gmlpnp_SolveRansac, chanceIsNoConsensus)
{
    // Nothing fits; one of twenty data sets may look as if something did.
    cv::RNG rng = testRng();
    for (const int n : {6, 20, 100, 400}) {
        int found = 0;
        for (int trial = 0; trial < 20; ++trial) {
            const Observed data = observed(rng, *paperLens(), n, 1, 0);
            Result result;
            Mat inliers;
            const bool solved = solveRansac(data.scene.objectPoints, data.pixels, paperLens(), result, inliers);
            found += solved;
            EXPECT_TRUE(solved || result.status == gmlpnp::STATUS_NO_CONSENSUS);
        }
        EXPECT_LE(found, 3) << n << " points";  // binomial, .05: 2 % of the seeds have more
    }
}

// Of a hundred data sets in which nothing fits: how many are said to have a pose. `spoil` adds to them or changes them.
int claimed(cv::RNG& rng, int n, const std::function<void(Mat_<double>&, Mat_<double>&)>& spoil)
{
    int found = 0;
    for (int trial = 0; trial < 100; ++trial) {
        const Observed data = observed(rng, *paperLens(), n, 1, 0);
        Mat_<double> points = data.scene.objectPoints, pixels = data.pixels;
        spoil(points, pixels);
        Result result;
        found += solveRansac(points, pixels, paperLens(), result, noArray());
    }
    return found;
}

constexpr int BY_CHANCE = 5;  // of a hundred: the expected number that is allowed for

TEST(Gmlpnp_SolveRansac, repeatsOfWrongMatchesAreNoConsensus)
{
    cv::RNG rng = testRng();
    for (const double px : {0.7, 5.})  // at 5 px most are matches of their own, of which one at most can be right
        for (const int n : {20, 50}) {
            const auto someAgain = [&](Mat_<double>& points, Mat_<double>& pixels) {
                for (int i = 0; i < n * 3 / 20; ++i)
                    repeat(rng, points, pixels, i, px);
            };
            EXPECT_LE(claimed(rng, n, someAgain), BY_CHANCE) << n << " matches, repeats within " << px << " px";
        }
    const auto allTwice = [&](Mat_<double>& points, Mat_<double>& pixels) {
        for (int i = 0; i < 30; ++i)
            repeat(rng, points, pixels, i, 0);
    };
    EXPECT_LE(claimed(rng, 30, allTwice), BY_CHANCE);
}

TEST(Gmlpnp_SolveRansac, manyPointsMatchedToOnePixelAreNoConsensus)
{
    cv::RNG rng = testRng();
    for (const int places : {20, 50}) {
        const auto sharePixels = [&](Mat_<double>&, Mat_<double>& pixels) {
            for (int i = places; i < pixels.rows; ++i)
                pixels.row(rng.uniform(0, places)).copyTo(pixels.row(i));
        };
        EXPECT_LE(claimed(rng, 200, sharePixels), BY_CHANCE) << places << " pixels";
    }
}

}  // namespace
}  // namespace opencv_test
