// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "observed.hpp"

// Matches that repeat others, true ones and wrong ones.

namespace opencv_test {
namespace {

using namespace ransac;

TEST(Gmlpnp_SolveRansac, oneWrongMatchManyTimesDoesNotOutvoteTheTrueOnes)
{
    cv::RNG rng = testRng();
    const Ptr<CameraModel> lens = paperLens();
    for (const double px : {0., 0.7})
        for (const int wrong : {1, 3})
            for (int trial = 0; trial < 10; ++trial) {
                const Observed data = observed(rng, *lens, 20 + wrong, double(wrong) / (20 + wrong), 0.5);
                Mat_<double> points = data.scene.objectPoints, pixels = data.pixels;
                for (int k = 0; k < 40 * wrong; ++k)
                    repeat(rng, points, pixels, 20 + k % wrong, px);
                Result result;
                ASSERT_TRUE(solveRansac(points, pixels, lens, result, noArray()));
                EXPECT_TRUE(poseNear(result, data.scene.truth, 0.05, 0.3)) << wrong << " wrong ones, trial " << trial;
            }
}

TEST(Gmlpnp_SolveRansac, trueMatchesMayRepeatToo)
{
    cv::RNG rng = testRng();
    const Ptr<CameraModel> lens = paperLens();
    for (const double outliers : {0., 0.5, 0.8})
        for (const double px : {0., 0.7}) {
            const Observed data = observed(rng, *lens, 60, outliers, 0.5);
            Mat_<double> points = data.scene.objectPoints, pixels = data.pixels;
            for (int i = 0; i < 60; ++i)
                repeat(rng, points, pixels, i, px);
            Result result;
            Mat inliers;
            ASSERT_TRUE(solveRansac(points, pixels, lens, result, inliers)) << outliers;
            EXPECT_TRUE(poseNear(result, data.scene.truth, 0.02, 0.1)) << outliers;
            EXPECT_GE(inliers.rows, 2 * data.good);  // the repeats are inliers all the same
            EXPECT_LE(inliers.rows, 2 * data.good + 4);
        }
}

TEST(Gmlpnp_SolveRansac, densePointsEachCount)
{
    // Four points a pixel, pixels rounded: neighbours are no repeats, and hundreds share a pixel with another.
    cv::RNG rng = testRng();
    const Ptr<CameraModel> lens = paperLens();
    for (const double outliers : {0.3, 0.8}) {
        const int n = 2000;
        std::vector<Vector3d> points;
        Mat_<double> pixels(n, 2);
        for (int i = 0; i < n; ++i) {
            points.emplace_back(rng.uniform(-0.08, 0.08), rng.uniform(-0.08, 0.08), rng.uniform(4., 4.1));
            Point2d pixel;
            ASSERT_TRUE(lens->projectPoint(Vec3d(points[i].x(), points[i].y(), points[i].z()), pixel));
            const bool wrong = i >= n * (1 - outliers);
            pixels(i, 0) = std::round(wrong ? rng.uniform(270., 370.) : pixel.x);
            pixels(i, 1) = std::round(wrong ? rng.uniform(190., 290.) : pixel.y);
        }
        const Scene scene = exactScene(rng, points);
        RansacParams ransac;
        ransac.threshold = 2;
        Result result;
        ASSERT_TRUE(solveRansac(scene.objectPoints, pixels, lens, result, noArray(), ransac)) << outliers;
        EXPECT_TRUE(poseNear(result, scene.truth, 0.1, 0.1)) << outliers;
    }
}

TEST(Gmlpnp_SolveRansac, threePlacesAreNoConsensus)
{
    cv::RNG rng = testRng();
    const Observed data = observed(rng, *paperLens(), 3, 0, 0);
    Mat_<double> points = data.scene.objectPoints, pixels = data.pixels;
    for (int i = 0; i < 27; ++i)
        repeat(rng, points, pixels, i % 3, 0);
    Result result;
    EXPECT_FALSE(solveRansac(points, pixels, paperLens(), result, noArray()));
    EXPECT_EQ(gmlpnp::STATUS_NO_CONSENSUS, result.status);
}

}  // namespace
}  // namespace opencv_test
