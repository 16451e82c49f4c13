// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../scenes.hpp"
#include "../statistics.hpp"

// Whether the pose covariance holds what it promises.

namespace opencv_test {
namespace {

using namespace cv::gmlpnp::detail;
using cv::gmlpnp::Params;
using cv::gmlpnp::Result;

enum class Made
{
    OBJECT,
    PIXELS,
    BOTH
};

// The first `noisy` points have five times the noise.
Scene sceneOf(cv::RNG& rng, Made made, int n, double halfField, int noisy)
{
    const double slope = std::tan(halfField);
    std::vector<Vector3d> points(n);
    for (Vector3d& X : points) {
        const double x = rng.uniform(-slope, slope), y = rng.uniform(-slope, slope);
        X = rng.uniform(4., 8.) * Vector3d(x, y, 1);
    }
    Scene scene = exactScene(rng, points);
    const Matrix3d root =
        made == Made::PIXELS ? Matrix3d(Matrix3d::Zero()) : Eigen3d(randomNoise(rng, 0.1)).operatorSqrt();
    const double px = made == Made::OBJECT ? 0 : 2;
    for (int i = 0; i < n; ++i) {
        const double times = i < noisy ? 5 : 1;
        const Vector3d e = times * root * gaussian3(rng);
        for (int k = 0; k < 3; ++k)
            scene.objectPoints(i, k) += e(k);
        scene.imagePoints(i, 0) += times * px * rng.gaussian(1);
        scene.imagePoints(i, 1) += times * px * rng.gaussian(0.5);
    }
    return scene;
}

struct Cell
{
    Made made;
    int halfField, n, wild;  // degrees, points, percent of them with five times the noise

    std::string name() const
    {
        const char* const noises[] = {"object", "pixels", "both"};
        const std::string tails = wild ? cv::format("%dPercentWild", wild) : std::string();
        return cv::format("%s%dDegrees%dPoints", noises[static_cast<int>(made)], halfField, n) + tails;
    }
    friend void PrintTo(const Cell& cell, std::ostream* out) { *out << cell.name(); }
};

// The 95 % ellipsoid of the pose holds the truth in 93 to 97 %.
void expectCovers(const Cell& cell, int trials)
{
    cv::RNG rng = testRng();
    int inside = 0;
    for (int k = 0; k < trials; ++k) {
        const Scene scene =
            sceneOf(rng, cell.made, cell.n, cell.halfField * CV_PI / 180, cvRound(0.01 * cell.wild * cell.n));
        const Result result = solvedPixels(scene);
        inside += mahalanobis2(scene.truth, poseOf(result), result.poseCovariance) < CHI2_6_95;
    }
    EXPECT_TRUE(shareWithin(inside, trials, 0.93, 0.97));
}

std::vector<Cell> cells(const std::vector<int>& counts, int wild)
{
    std::vector<Cell> all;
    for (const Made made : {Made::OBJECT, Made::PIXELS, Made::BOTH})
        for (const int halfField : {15, 60})
            for (const int n : counts)
                all.push_back({made, halfField, n, wild});
    return all;
}

class Gmlpnp_CoverageStatistics : public testing::TestWithParam<Cell>
{};

TEST_P(Gmlpnp_CoverageStatistics, poseCovarianceCovers)
{
    expectCovers(GetParam(), 300);
}

class SlowGmlpnp_CoverageStatistics : public testing::TestWithParam<Cell>
{};

TEST_P(SlowGmlpnp_CoverageStatistics, poseCovarianceCovers)
{
    expectCovers(GetParam(), 2000);
}

INSTANTIATE_TEST_SUITE_P(/**/, Gmlpnp_CoverageStatistics, testing::ValuesIn(cells({15, 50}, 0)), nameOf<Cell>);
INSTANTIATE_TEST_SUITE_P(Gaussian, SlowGmlpnp_CoverageStatistics, testing::ValuesIn(cells({15, 20, 50, 100, 200}, 0)),
                         nameOf<Cell>);
INSTANTIATE_TEST_SUITE_P(Tails, SlowGmlpnp_CoverageStatistics, testing::ValuesIn(cells({15, 20, 50, 200}, 10)),
                         nameOf<Cell>);
INSTANTIATE_TEST_SUITE_P(HeavyTails, SlowGmlpnp_CoverageStatistics, testing::ValuesIn(cells({15, 20, 50, 200}, 20)),
                         nameOf<Cell>);

}  // namespace
}  // namespace opencv_test
