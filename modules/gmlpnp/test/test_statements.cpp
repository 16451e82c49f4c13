// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "test_precomp.hpp"

#include "scenes.hpp"
#include "statistics.hpp"

// The statements of the statistics themselves: which values they accept.

namespace opencv_test {
namespace {

TEST(Gmlpnp_Statements, acceptWhatIsWithinTheDeviations)
{
    EXPECT_TRUE(withinSigma(1.39, 1, 0.1));
    EXPECT_FALSE(withinSigma(1.41, 1, 0.1));
    EXPECT_FALSE(withinSigma(0.59, 1, 0.1));
    EXPECT_TRUE(within(0.41, 0.8, 1, 0.1));
    EXPECT_TRUE(atMost(-100, 1, 0.1));
    EXPECT_FALSE(atMost(1.41, 1, 0.1));
    EXPECT_FALSE(withinSigma(std::nan(""), 1, 0.1));
    EXPECT_FALSE(atMost(1, 1, std::nan("")));
    EXPECT_TRUE(asChiSquared6(27));
    EXPECT_FALSE(asChiSquared6(28));
}

// Of 100 draws with 5 % each, 16 or more come with a probability of 3.7e-5, and 17 or more with 9.4e-6.
TEST(Gmlpnp_Statements, acceptCountsThatAreNotTooRare)
{
    EXPECT_TRUE(shareAtMost(16, 100, 0.05));
    EXPECT_FALSE(shareAtMost(17, 100, 0.05));
    EXPECT_TRUE(shareAtLeast(84, 100, 0.95));
    EXPECT_FALSE(shareAtLeast(83, 100, 0.95));
    EXPECT_TRUE(shareWithin(50, 100, 0.5, 0.5));
    EXPECT_FALSE(shareWithin(28, 100, 0.5, 0.5));
    EXPECT_FALSE(shareWithin(72, 100, 0.5, 0.5));
    EXPECT_TRUE(shareAtMost(0, 100, 0)) << "none";
    EXPECT_FALSE(shareAtMost(1, 100, 0));
}

// Whether the deviations are those that repetitions have.
TEST(Gmlpnp_Statements, deviationsAreThoseOfRepetitions)
{
    constexpr int REPETITIONS = 400, PROBLEMS = 200;
    cv::RNG rng = testRng();
    Mean ofMean, ofRatio;
    double meanSquare = 0, ratioSquare = 0;
    for (int r = 0; r < REPETITIONS; ++r) {
        Mean mean;
        RatioOfMeans ratio;
        for (int k = 0; k < PROBLEMS; ++k) {
            const double theirs = 3 + rng.gaussian(1), ours = 0.5 * theirs + 0.5 + rng.gaussian(0.2);
            mean.add(ours);
            ratio.add(ours, theirs);
        }
        meanSquare += (mean.value() - 2) * (mean.value() - 2) / REPETITIONS;
        ratioSquare += (ratio.value() - 2. / 3) * (ratio.value() - 2. / 3) / REPETITIONS;
        ofMean.add(mean.deviation());
        ofRatio.add(ratio.deviation());
    }
    // A standard deviation over so many repetitions is known to 3.5 %.
    EXPECT_NEAR(1, std::sqrt(meanSquare) / ofMean.value(), 0.15);
    EXPECT_NEAR(1, std::sqrt(ratioSquare) / ofRatio.value(), 0.15);
}

}  // namespace
}  // namespace opencv_test
