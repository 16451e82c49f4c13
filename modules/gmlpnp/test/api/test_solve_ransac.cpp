// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "observed.hpp"

// RANSAC through the public functions: shares of outliers, sizes, what comes out.

namespace opencv_test {
namespace {

using namespace ransac;

TEST(Gmlpnp_SolveRansac, sharesOfOutliersAndSizes)
{
    cv::RNG rng = testRng();
    const Ptr<CameraModel> lens = paperLens();
    struct
    {
        int n;
        double outliers;
    } const cases[] = {{4, 0},     {5, 0},    {6, 0.2},    {10, 0.4},    {20, 0.6},    {50, 0.8},
                       {100, 0.9}, {1000, 0}, {1000, 0.9}, {20000, 0.5}, {100000, 0.9}};
    for (const auto& each : cases) {
        const Observed data = observed(rng, *lens, each.n, each.outliers, 0.5);
        Result result;
        Mat inliers;
        ASSERT_TRUE(solveRansac(data.scene.objectPoints, data.pixels, lens, result, inliers))
            << each.n << " points, " << each.outliers;
        const double bound = 0.1 / std::sqrt(data.good);
        EXPECT_TRUE(poseNear(result, data.scene.truth, bound, 8 * bound)) << each.n << " points, " << each.outliers;
        EXPECT_EQ(withinThreshold(*lens, data, result, 8), rowsOf(inliers)) << each.n << " points";
        EXPECT_GE(inliers.rows, data.good * 99 / 100);
    }
}

TEST(Gmlpnp_SolveRansac, planes)
{
    cv::RNG rng = testRng();
    const Ptr<CameraModel> lens = paperLens();
    for (const double outliers : {0., 0.3, 0.7}) {
        const Observed data = observed(rng, *lens, 100, outliers, 0.5, true);
        Result result;
        Mat inliers;
        ASSERT_TRUE(solveRansac(data.scene.objectPoints, data.pixels, lens, result, inliers));
        EXPECT_TRUE(poseNear(result, data.scene.truth, 0.01, 0.03)) << outliers;
        EXPECT_EQ(withinThreshold(*lens, data, result, 8), rowsOf(inliers));
    }
}

TEST(Gmlpnp_SolveRansac, resultIsThatOfTheInliers)
{
    cv::RNG rng = testRng();
    const Ptr<CameraModel> lens = paperLens();
    const Observed data = observed(rng, *lens, 80, 0.5, 1);
    Result robust, alone;
    Mat inliers;
    ASSERT_TRUE(solveRansac(data.scene.objectPoints, data.pixels, lens, robust, inliers));
    Mat_<double> points, pixels;
    for (const int i : rowsOf(inliers)) {
        points.push_back(data.scene.objectPoints.row(i));
        pixels.push_back(data.pixels.row(i));
    }
    ASSERT_TRUE(solve(points, pixels, lens, alone));
    // The same minimum, reached from another start.
    EXPECT_TRUE(poseNear(robust, poseOf(alone), 1e-3, 5e-3));
    EXPECT_EQ(inliers.rows, robust.usedPoints);
    ASSERT_EQ(80, robust.weights.rows);
    for (int i = 0, k = 0; i < 80; ++i) {
        const bool inlier = k < inliers.rows && inliers.at<int>(k) == i;
        EXPECT_EQ(inlier, robust.weights.at<double>(i) > 0) << "row " << i;
        k += inlier;
    }
    EXPECT_EQ(Size(6, 6), robust.poseCovariance.size());
}

TEST(Gmlpnp_SolveRansac, knownCovariancesBelongToTheirPoints)
{
    cv::RNG rng = testRng();
    const Ptr<CameraModel> lens = paperLens();
    const int n = 60;
    const Observed data = observed(rng, *lens, n, 0.5, 1);
    Params params;
    Mat_<double> variances(n, 1), spoiled(n, 1);
    for (int i = 0; i < n; ++i) {
        variances(i) = rng.uniform(0.5, 2.);
        spoiled(i) = i < data.good ? variances(i) : 1e4;  // of wrong correspondences: no part of the solve
    }
    params.objectNoise = Mat::zeros(3, 3, CV_64F);
    params.bearingNoise = Mat::zeros(3, 3, CV_64F);
    Result a, b;
    Mat inliers;
    params.pixelCovariances = variances;
    ASSERT_TRUE(solveRansac(data.scene.objectPoints, data.pixels, lens, a, inliers, RansacParams(), params));
    EXPECT_EQ(data.good, inliers.rows);
    params.pixelCovariances = spoiled;
    ASSERT_TRUE(solveRansac(data.scene.objectPoints, data.pixels, lens, b, inliers, RansacParams(), params));
    EXPECT_EQ(a.tvec, b.tvec);
    EXPECT_EQ(0, cv::norm(a.poseCovariance, b.poseCovariance));
}

TEST(Gmlpnp_SolveRansac, guesses)
{
    cv::RNG rng = testRng();
    const Ptr<CameraModel> lens = paperLens();
    const Observed data = observed(rng, *lens, 300, 0.9, 0.5);
    const Vector3d phi = gmlpnp::detail::logSO3(data.scene.truth.R), t = data.scene.truth.t;
    Params params;
    params.useExtrinsicGuess = true;
    params.rvec = Vec3d(phi.x(), phi.y(), phi.z());
    params.tvec = Vec3d(t.x(), t.y(), t.z()) * 1.01;
    RansacParams hurried;
    hurried.maxIterations = 1;
    Result result;
    Mat inliers;
    EXPECT_FALSE(solveRansac(data.scene.objectPoints, data.pixels, lens, result, inliers, hurried));
    EXPECT_EQ(gmlpnp::STATUS_NO_CONSENSUS, result.status);
    ASSERT_TRUE(solveRansac(data.scene.objectPoints, data.pixels, lens, result, inliers, hurried, params));
    EXPECT_TRUE(poseNear(result, data.scene.truth, 0.02, 0.1));
    params.rvec = Vec3d(1, 2, 3);  // a bad one does no harm
    ASSERT_TRUE(solveRansac(data.scene.objectPoints, data.pixels, lens, result, inliers, RansacParams(), params));
    EXPECT_TRUE(poseNear(result, data.scene.truth, 0.02, 0.1));
}

TEST(Gmlpnp_SolveRansac, wrongOrderIsNotFatal)
{
    cv::RNG rng = testRng();
    const Ptr<CameraModel> lens = paperLens();
    RansacParams ransac;
    ransac.ordered = true;
    for (const int n : {50, 300, 15000})
        for (int trial = 0; trial < (n > 1000 ? 2 : 20); ++trial) {
            const Observed data = observed(rng, *lens, n, n > 1000 ? 0.7 : 0.5, 0.5);
            Mat points, pixels;
            cv::flip(data.scene.objectPoints, points, 0);  // the wrong ones come first
            cv::flip(data.pixels, pixels, 0);
            Result result;
            Mat inliers;
            ASSERT_TRUE(solveRansac(points, pixels, lens, result, inliers, ransac)) << n << " points, trial " << trial;
            EXPECT_TRUE(poseNear(result, data.scene.truth, 0.05, 0.3)) << n << " points, trial " << trial;
            EXPECT_GE(inliers.rows, data.good * 99 / 100);
        }
}

TEST(Gmlpnp_SolveRansac, statusOfBadData)
{
    cv::RNG rng = testRng();
    const Observed data = observed(rng, *paperLens(), 30, 0, 0.5);
    Result result;
    Mat inliers;
    const auto statusOf = [&](const Mat& points, const Mat& pixels) {
        EXPECT_FALSE(solveRansac(points, pixels, paperLens(), result, inliers));
        EXPECT_TRUE(inliers.empty());
        return result.status;
    };
    EXPECT_EQ(gmlpnp::STATUS_TOO_FEW_POINTS,
              statusOf(data.scene.objectPoints.rowRange(0, 3), data.pixels.rowRange(0, 3)));
    Mat_<double> nan = data.pixels.clone();
    nan(7, 1) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(gmlpnp::STATUS_NOT_FINITE, statusOf(data.scene.objectPoints, nan));
    Mat_<double> line(30, 3);
    for (int i = 0; i < 30; ++i)
        line(i, 0) = line(i, 1) = line(i, 2) = i;
    EXPECT_EQ(gmlpnp::STATUS_DEGENERATE, statusOf(line, data.pixels));
}

}  // namespace
}  // namespace opencv_test
