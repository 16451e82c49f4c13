// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../statistics.hpp"
#include "observed.hpp"

// Where nothing fits, a pose is found as rarely as is allowed for.

namespace opencv_test {
namespace {

using namespace ransac;

using Spoil = std::function<void(cv::RNG&, Mat_<double>&, Mat_<double>&)>;

/** Data in which nothing fits: all of `n` matches are wrong, and what is added to them or changed in them. */
struct Nothing
{
    std::string kind;
    int n;
    Spoil spoil;

    std::string name() const { return kind + cv::format("%dMatches", n); }
    friend void PrintTo(const Nothing& cell, std::ostream* out) { *out << cell.name(); }
};

class Gmlpnp_RansacChanceStatistics : public testing::TestWithParam<Nothing>
{};

// One of twenty data sets may look as if something did.
TEST_P(Gmlpnp_RansacChanceStatistics, whereNothingFitsThereIsNoConsensus)
{
    constexpr int TRIALS = 100;
    cv::RNG rng = testRng();
    int found = 0;
    for (int trial = 0; trial < TRIALS; ++trial) {
        const Observed data = observed(rng, *paperLens(), GetParam().n, 1, 0);
        Mat_<double> points = data.scene.objectPoints, pixels = data.pixels;
        GetParam().spoil(rng, points, pixels);
        Result result;
        const bool solved = solveRansac(points, pixels, paperLens(), result, noArray());
        found += solved;
        EXPECT_TRUE(solved || result.status == gmlpnp::STATUS_NO_CONSENSUS) << "trial " << trial;
    }
    EXPECT_TRUE(shareAtMost(found, TRIALS, 0.05));
}

// The first `count` matches come again, within `px`. At 5 px most are matches of their own, of which one at most can be
// right.
Nothing repeated(const char* kind, int n, int count, double px)
{
    return {kind, n, [=](cv::RNG& rng, Mat_<double>& points, Mat_<double>& pixels) {
                for (int i = 0; i < count; ++i)
                    repeat(rng, points, pixels, i, px);
            }};
}

// Many points are matched to each of a few pixels.
Nothing shared(const char* kind, int places)
{
    return {kind, 200, [=](cv::RNG& rng, Mat_<double>&, Mat_<double>& pixels) {
                for (int i = places; i < pixels.rows; ++i)
                    pixels.row(rng.uniform(0, places)).copyTo(pixels.row(i));
            }};
}

INSTANTIATE_TEST_SUITE_P(/**/, Gmlpnp_RansacChanceStatistics,
                         testing::Values(repeated("", 6, 0, 0), repeated("", 20, 0, 0), repeated("", 100, 0, 0),
                                         repeated("", 400, 0, 0), repeated("nearRepeats", 20, 3, 0.7),
                                         repeated("nearRepeats", 50, 7, 0.7), repeated("farRepeats", 20, 3, 5),
                                         repeated("farRepeats", 50, 7, 5), repeated("allTwice", 30, 30, 0),
                                         shared("at20Pixels", 20), shared("at50Pixels", 50)),
                         nameOf<Nothing>);

}  // namespace
}  // namespace opencv_test
