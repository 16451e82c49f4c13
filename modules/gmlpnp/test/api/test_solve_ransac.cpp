// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../camera/camera_util.hpp"
#include "../scenes.hpp"

#include <functional>

// RANSAC through the public functions: shares of outliers, sizes, lenses, what comes out.

namespace opencv_test {
namespace {

using namespace camera;
using gmlpnp::Params;
using gmlpnp::RansacParams;
using gmlpnp::Result;

// Pixels of the scene in a lens, with noise; the last of them anywhere. Points may lie anywhere around the camera.
struct Observed
{
    Scene scene;
    Mat_<double> pixels;
    int good;
};

Observed observed(cv::RNG& rng, const CameraModel& lens, int n, double outliers, double px, bool flat = false)
{
    std::vector<Vector3d> points;
    Observed out;
    out.pixels.create(n, 2);
    Point2d pixel;
    while (static_cast<int>(points.size()) < n)
        for (const Vector3d& X : flat ? boxPoints(rng, n, true) : surroundingPoints(rng, n))
            if (static_cast<int>(points.size()) < n && lens.projectPoint(Vec3d(X.x(), X.y(), X.z()), pixel) &&
                std::abs(pixel.x) < 4000 && std::abs(pixel.y) < 4000) {
                const int i = static_cast<int>(points.size());
                out.pixels(i, 0) = pixel.x + rng.gaussian(px);
                out.pixels(i, 1) = pixel.y + rng.gaussian(px);
                points.push_back(X);
            }
    out.scene = exactScene(rng, points);
    out.good = n - static_cast<int>(std::lround(outliers * n));
    const Mat all = out.pixels.clone();
    for (int i = out.good; i < n; ++i)  // the pixel of another point: as wrong matches are
        for (int k = 0; k < 2; ++k)
            out.pixels(i, k) = all.at<double>(rng.uniform(0, n), k) + rng.uniform(-100., 100.);
    return out;
}

Ptr<CameraModel> paperLens()
{
    return CameraModel::pinhole(paperCamera());
}

std::vector<int> rowsOf(const Mat& inliers)
{
    EXPECT_EQ(CV_32SC1, inliers.type());
    EXPECT_EQ(1, inliers.cols);
    return {inliers.begin<int>(), inliers.end<int>()};
}

// Rows that have a ray and whose reprojection error is at most the threshold.
std::vector<int> withinThreshold(const CameraModel& lens, const Observed& data, const Result& result, double threshold)
{
    const Pose pose = poseOf(result.rvec, result.tvec);
    std::vector<int> rows;
    for (int i = 0; i < data.pixels.rows; ++i) {
        const double* p = data.scene.objectPoints[i];
        const Vector3d X = pose * Vector3d(p[0], p[1], p[2]);
        Point2d pixel;
        Vec3d ray;
        if (lens.unprojectPoint({data.pixels(i, 0), data.pixels(i, 1)}, ray) &&
            lens.projectPoint(Vec3d(X.x(), X.y(), X.z()), pixel) &&
            std::hypot(pixel.x - data.pixels(i, 0), pixel.y - data.pixels(i, 1)) <= threshold)
            rows.push_back(i);
    }
    return rows;
}

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

TEST(Gmlpnp_SolveRansac, lensesBeyond180Degrees)
{
    cv::RNG rng = testRng();
    const Matx33d K = matrixK(300, 302, 640, 480);
    const std::vector<Ptr<CameraModel>> lenses = {
        CameraModel::fisheye(K, Vec4d(-0.02, 0.004, -0.001, 0.0001)),
        CameraModel::omnidir(K, Vec4d(-0.1, 0.02, 0, 0), 1.2), CameraModel::eucm(K, 0.65, 1.1),
        CameraModel::doubleSphere(K, -0.2, 0.6), CameraModel::equirectangular(Size(1600, 800))};
    for (size_t k = 0; k < lenses.size(); ++k)
        for (const double outliers : {0.1, 0.6}) {
            const Observed data = observed(rng, *lenses[k], 150, outliers, 0.5);
            Result result;
            Mat inliers;
            ASSERT_TRUE(solveRansac(data.scene.objectPoints, data.pixels, lenses[k], result, inliers)) << "lens " << k;
            EXPECT_TRUE(poseNear(result, data.scene.truth, 0.005, 0.02)) << "lens " << k;
            const std::vector<int> rows = rowsOf(inliers), expected = withinThreshold(*lenses[k], data, result, 8);
            // Across the seam of the panorama the picture says otherwise.
            EXPECT_TRUE(std::includes(rows.begin(), rows.end(), expected.begin(), expected.end())) << "lens " << k;
            EXPECT_LE(rows.size(), expected.size() + (k == 4 ? 3 : 0)) << "lens " << k;
        }
}

TEST(Gmlpnp_SolveRansac, seamOfAPanorama)
{
    // Half of the points appear at the left edge, of which half are seen at the right one.
    cv::RNG rng = testRng();
    const Ptr<CameraModel> lens = CameraModel::equirectangular(Size(2000, 1000));
    std::vector<Vector3d> points;
    Mat_<double> pixels(40, 2);
    for (int i = 0; i < 40; ++i) {
        const double turn = CV_PI - rng.uniform(0., 0.004), up = rng.uniform(-1., 1.);
        points.emplace_back(rng.uniform(3., 6.) * Vector3d(std::sin(turn), std::tan(up), std::cos(turn)));
        points.back().x() = i % 2 ? points.back().x() : rng.uniform(-3., 3.);
        Point2d pixel;
        ASSERT_TRUE(lens->projectPoint(Vec3d(points[i].x(), points[i].y(), points[i].z()), pixel));
        pixels(i, 0) = pixel.x + (i % 4 == 1 ? (pixel.x > 1000 ? -1999.5 : 1999.5) : 0);  // half a pixel off
        pixels(i, 1) = pixel.y;
    }
    const Scene scene = exactScene(rng, points);
    Result result;
    Mat inliers;
    ASSERT_TRUE(solveRansac(scene.objectPoints, pixels, lens, result, inliers));
    EXPECT_EQ(40, inliers.rows);
    EXPECT_TRUE(poseNear(result, scene.truth, 0.01, 0.05));
}

TEST(Gmlpnp_SolveRansac, rays)
{
    cv::RNG rng = testRng();
    for (const double threshold : {1e-6, 1e-3, 0.05}) {
        Scene scene = exactScene(rng, surroundingPoints(rng, 200));
        for (int i = 0; i < 120; ++i) {
            const Vector3d m = gaussian3(rng);
            for (int k = 0; k < 3; ++k)
                scene.rays(i, k) = m(k);
        }
        RansacParams ransac;
        ransac.threshold = threshold;
        Result result;
        Mat inliers;
        ASSERT_TRUE(solveRaysRansac(scene.objectPoints, scene.rays, result, inliers, ransac)) << threshold;
        EXPECT_TRUE(poseNear(result, scene.truth, threshold, 5 * threshold));
        EXPECT_GE(inliers.rows, 80);
        for (const int i : rowsOf(inliers)) {
            const Vector3d p(scene.objectPoints[i]), m(scene.rays[i]), X = poseOf(result.rvec, result.tvec) * p;
            EXPECT_LE(std::atan2(m.cross(X).norm(), m.dot(X)), threshold * (1 + 1e-9));
        }
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
    EXPECT_TRUE(poseNear(robust, poseOf(alone.rvec, alone.tvec), 1e-3, 5e-3));
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

// --- The covariance beside the threshold ---

TEST(Gmlpnp_SolveRansac, covarianceHoldsWhereTheThresholdCutsIntoTheNoise)
{
    cv::RNG rng = testRng();
    const Ptr<CameraModel> lens = paperLens();
    for (const bool known : {false, true})
        for (const double threshold : {1.5, 2., 3., 8.}) {  // px, at a noise of 1 px
            Params params;
            if (known) {
                params.objectNoise = Mat::zeros(3, 3, CV_64F);
                params.bearingNoise = Mat::zeros(3, 3, CV_64F);
                params.pixelCovariances = Mat(140, 1, CV_64F, Scalar(1));
            }
            RansacParams ransac;
            ransac.threshold = threshold;
            constexpr int TRIALS = 200;
            double sum = 0;
            int inside = 0;
            for (int trial = 0; trial < TRIALS; ++trial) {
                const Observed data = observed(rng, *lens, 140, 0.3, 1, true);
                Result result;
                ASSERT_TRUE(solveRansac(data.scene.objectPoints, data.pixels, lens, result, noArray(), ransac, params));
                const double nees =
                    mahalanobis2(data.scene.truth, poseOf(result.rvec, result.tvec), result.poseCovariance);
                sum += nees;
                inside += nees < 12.592;  // 95 % quantile
            }
            // The mean of so many has a standard deviation of .25, the share one of .016. Where residuals are nearly
            // uniform they tell less of the noise: the tails are longer.
            SCOPED_TRACE(testing::Message() << threshold << " px, " << (known ? "known" : "estimated") << " noise");
            EXPECT_GT(sum / TRIALS, 5.2);
            EXPECT_LT(sum / TRIALS, threshold < 2 ? 7.8 : 6.8);
            EXPECT_GE(inside, TRIALS * (threshold < 2 ? 0.85 : 0.91));
        }
}

// --- Repeats ---

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

void repeat(cv::RNG& rng, Mat_<double>& points, Mat_<double>& pixels, int row, double px)
{
    points.push_back(points.row(row).clone());
    pixels.push_back(pixels.row(row).clone());
    pixels(pixels.rows - 1, 0) += rng.uniform(-px, px);
    pixels(pixels.rows - 1, 1) += rng.uniform(-px, px);
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
