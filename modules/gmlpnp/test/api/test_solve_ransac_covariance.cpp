// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../statistics.hpp"
#include "observed.hpp"

namespace opencv_test {
namespace {

using namespace ransac;

struct Cell
{
    double threshold;  // px, at a noise of 1 px
    bool known;

    std::string name() const
    {
        return cv::format("threshold%02dNoise%s", cvRound(10 * threshold), known ? "Known" : "Estimated");
    }
    friend void PrintTo(const Cell& cell, std::ostream* out) { *out << cell.name(); }
};

class Gmlpnp_RansacCovarianceStatistics : public testing::TestWithParam<Cell>
{};

// Where residuals are nearly uniform they tell less of the noise: the tails are longer.
TEST_P(Gmlpnp_RansacCovarianceStatistics, holdsWhereTheThresholdCutsIntoTheNoise)
{
    constexpr int TRIALS = 500, MATCHES = 140;
    cv::RNG rng = testRng();
    const Ptr<CameraModel> lens = paperLens();
    Params params;
    if (GetParam().known) {
        params.objectNoise = params.bearingNoise = Mat::zeros(3, 3, CV_64F);
        params.pixelCovariances = Mat(MATCHES, 1, CV_64F, Scalar(1));
    }
    RansacParams ransac;
    ransac.threshold = GetParam().threshold;
    Consistency consistency;
    for (int trial = 0; trial < TRIALS; ++trial) {
        const Observed data = observed(rng, *lens, MATCHES, 0.3, 1, true);
        Result result;
        ASSERT_TRUE(solveRansac(data.scene.objectPoints, data.pixels, lens, result, noArray(), ransac, params));
        consistency.add(mahalanobis2(data.scene.truth, poseOf(result), result.poseCovariance));
    }
    const bool uniform = GetParam().threshold < 2;
    EXPECT_TRUE(within(consistency.mean(), 5.85, uniform ? 7.15 : 6.15, consistency.deviation()));
    EXPECT_TRUE(shareAtLeast(consistency.inside(), TRIALS, uniform ? 0.905 : 0.95));
}

std::vector<Cell> cells()
{
    std::vector<Cell> all;
    for (const bool known : {false, true})
        for (const double threshold : {1.5, 2., 3., 8.})
            all.push_back({threshold, known});
    return all;
}

INSTANTIATE_TEST_SUITE_P(/**/, Gmlpnp_RansacCovarianceStatistics, testing::ValuesIn(cells()), nameOf<Cell>);

}  // namespace
}  // namespace opencv_test
