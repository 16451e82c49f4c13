// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../../src/ransac/measure.hpp"
#include "../../src/ransac/repeats.hpp"
#include "../../src/ransac/sampler.hpp"
#include "../../src/ransac/score.hpp"
#include "../scenes.hpp"

namespace opencv_test {
namespace {

using namespace cv::gmlpnp::detail;

// --- Samples ---

TEST(Gmlpnp_Ransac, samplesAreDistinctAndEquallyLikely)
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
    const double expected = 3. * DRAWS / N, deviation = std::sqrt(DRAWS * (3. / N) * (1 - 3. / N));
    for (const int c : count)
        EXPECT_NEAR(expected, c, 4 * deviation);
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

// --- Repeats ---

TEST(Gmlpnp_Ransac, repeatsArePointsWithNearlyTheSameRay)
{
    // Along a row of rays .2 thresholds apart each point has those of its own number and the next two, the last point
    // one that is .5 thresholds off and one that is behind.
    constexpr double THRESHOLD = 0.01;
    const double offsets[] = {0, 0, 0.2, 0, 0.5, 0.2}, zeros[] = {0, 0., 0, -0., 0, 0};
    cv::Mat_<double> points(8, 3), rays(8, 3);
    for (int i = 0; i < 6; ++i) {
        const cv::Vec3d ray(std::tan(offsets[i] * THRESHOLD), 0, 1);
        for (int k = 0; k < 3; ++k) {
            points(i, k) = i == 3 ? k + 1e-9 : k;  // another point, however near
            rays(i, k) = ray[k] * (1 + i);
        }
        points(i, 0) = zeros[i];
    }
    points.row(0).copyTo(points.row(6));
    cv::Mat(-rays.row(0)).copyTo(rays.row(6));
    for (int k = 0; k < 3; ++k)
        points(7, k) = rays(7, k) = 7 - k;
    const Correspondences data(points, rays);
    std::vector<Metric> metrics;
    for (int i = 0; i < data.size(); ++i)
        metrics.push_back(angularMetric(data.rayAt(i).normalized(), THRESHOLD));
    EXPECT_EQ((std::vector<int>{0, 3, 4, 6, 7}), withoutRepeats(data, metrics));
}

TEST(Gmlpnp_Ransac, nothingRepeatsInGeneral)
{
    cv::RNG rng = testRng();
    const Scene scene = paperScene(rng, 2000, 0.01, 1);
    const Correspondences data(scene.objectPoints, scene.rays);
    DistinctPoints points(data, data.size());
    for (int i = 0; i < data.size(); ++i) {
        EXPECT_FALSE(points.has(i));
        EXPECT_EQ(i, points.add(i));
    }
    EXPECT_EQ(2000, points.count());
    EXPECT_EQ(2000 - 1, points.add(2000 - 1));
    EXPECT_EQ(2000, points.count());
    EXPECT_TRUE(withoutRepeats(data, std::vector<Metric>(2000)).empty());
}

TEST(Gmlpnp_Ransac, manyMatchesOfOnePointTakeNoLongerThanOthers)
{
    // Pairwise looking would take minutes.
    constexpr int N = 200000;
    cv::RNG rng = testRng();
    Scene scene = exactScene(rng, surroundingPoints(rng, N));
    for (int i = 0; i < N / 2; ++i)
        scene.objectPoints.row(0).copyTo(scene.objectPoints.row(i));
    const Correspondences data(scene.objectPoints, scene.rays);
    std::vector<Metric> metrics;
    for (int i = 0; i < N; ++i)
        metrics.push_back(angularMetric(data.rayAt(i).normalized(), 1e-6));
    EXPECT_GE(static_cast<int>(withoutRepeats(data, metrics).size()), N - 10);
}

// --- Residuals ---

TEST(Gmlpnp_Ransac, metricTurnsRaysIntoThresholds)
{
    cv::RNG rng = testRng();
    const auto camera = cv::gmlpnp::CameraModel::fisheye(cv::Matx33d(300, 0, 320, 0, 310, 240, 0, 0, 1),
                                                         cv::Matx14d(0.02, -0.003, 0.001, 0));
    for (int trial = 0; trial < 100; ++trial) {
        const cv::Point2d pixel(rng.uniform(0., 640.), rng.uniform(0., 480.));
        cv::Vec3d m;
        cv::Matx32d J;
        ASSERT_TRUE(camera->unprojectPoint(pixel, m, &J));
        Eigen::Matrix<double, 3, 2> jacobian;
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 2; ++k)
                jacobian(i, k) = J(i, k);
        constexpr double THRESHOLD = 4;
        const Metric B = pixelMetric(jacobian, THRESHOLD);
        EXPECT_TRUE(matrixNear(THRESHOLD * B * jacobian, Eigen::Matrix2d::Identity(), 1e-9));
        EXPECT_LT((B * Vector3d(m[0], m[1], m[2])).norm(), 1e-9);
        // A pixel near by is as far in the metric as in the picture.
        const cv::Point2d near(pixel.x + rng.uniform(-2., 2.), pixel.y + rng.uniform(-2., 2.));
        ASSERT_TRUE(camera->unprojectPoint(near, m));
        const Vector3d X(m[0], m[1], m[2]), m0 = jacobian.col(0).cross(jacobian.col(1)).normalized();
        const double e = (B * X).norm() / std::abs(m0.dot(X));
        EXPECT_NEAR(cv::norm(near - pixel) / THRESHOLD, e, 0.01);
    }
}

TEST(Gmlpnp_Ransac, metricOfAnAngleIsExact)
{
    cv::RNG rng = testRng();
    for (int trial = 0; trial < 100; ++trial) {
        const Vector3d m = gaussian3(rng).normalized(), X = m + 0.5 * gaussian3(rng);
        const double s = m.dot(X);
        if (s <= 0)
            continue;
        const double angle = std::atan2(m.cross(X).norm(), s);
        const Metric B = angularMetric(m, angle);
        EXPECT_NEAR(1, (B * X).norm() / s, 1e-9);
    }
}

TEST(Gmlpnp_Ransac, varianceThatAThresholdLeaves)
{
    cv::RNG rng = testRng();
    for (const double sigma : {0.05, 0.2, 0.3, 0.5, 0.6}) {  // thresholds
        double sum = 0;
        int count = 0;
        for (int i = 0; i < 400000; ++i) {
            const double u = rng.gaussian(sigma), v = rng.gaussian(sigma), e2 = u * u + v * v;
            sum += e2 < 1 ? e2 : 0;
            count += e2 < 1;
        }
        EXPECT_NEAR(sum / count / (2 * sigma * sigma), varianceLeft(sum / count), 0.01) << sigma;
    }
    EXPECT_EQ(1, varianceLeft(0));
    // Uniform residuals, or more of them at the rim, bound the noise from below alone.
    EXPECT_EQ(varianceLeft(0.5), varianceLeft(1));
    EXPECT_EQ(varianceLeft(0.5), varianceLeft(10));
}

// A scene with wrong correspondences, as the search sees it.
struct Problem
{
    Problem(cv::RNG& rng, int n, double outliers) : Problem(rng, paperScene(rng, n, 0.01, 1), outliers) {}

    Problem(cv::RNG& rng, Scene given, double outliers)
        : scene(std::move(given)), data(withOutliers(rng, scene, outliers), scene.rays)
    {
        for (int i = 0; i < data.size(); ++i)
            metrics.push_back(angularMetric(data.rayAt(i), 0.01));
    }

    static cv::Mat_<double> withOutliers(cv::RNG& rng, Scene& scene, double share)
    {
        const int n = scene.objectPoints.rows;
        for (int i = n - static_cast<int>(share * n); i < n; ++i)
            for (int k = 0; k < 3; ++k)
                scene.objectPoints(i, k) = rng.uniform(-3., 3.);
        return scene.objectPoints;
    }

    // By hand, as the definitions say it; behind the camera there is no residual.
    std::optional<Eigen::Vector2d> residual(const Pose& pose, int i) const
    {
        const Vector3d X = pose * data.pointAt(i);
        const double s = data.rayAt(i).dot(X);
        if (s > 0)
            return Eigen::Vector2d(metrics[i] * X / s);
        return std::nullopt;
    }

    Score score(const Pose& pose) const
    {
        Score sum{0, 0};
        for (int i = 0; i < data.size(); ++i) {
            const auto e = residual(pose, i);
            const bool inlier = e && e->squaredNorm() < 1;
            sum.cost += inlier ? e->squaredNorm() : 1;
            sum.inliers += inlier;
        }
        return sum;
    }

    std::vector<bool> inliers(const Pose& pose) const
    {
        std::vector<bool> found(data.size());
        for (int i = 0; i < data.size(); ++i) {
            const auto e = residual(pose, i);
            found[i] = e && e->squaredNorm() < 1;
        }
        return found;
    }

    // Derivatives by differences.
    Pose stepped(const Pose& pose, double width) const
    {
        Matrix6d H = Matrix6d::Zero();
        Vector6d g = Vector6d::Zero();
        for (int i = 0; i < data.size(); ++i) {
            const auto e = residual(pose, i);
            if (!e || e->norm() >= width)
                continue;
            Eigen::Matrix<double, 2, 6> J;
            for (int k = 0; k < 6; ++k) {
                constexpr double STEP = 1e-6;
                const Vector6d along = STEP * Vector6d::Unit(k);
                J.col(k) = (*residual(perturbed(pose, along), i) - *residual(perturbed(pose, -along), i)) / (2 * STEP);
            }
            const double left = 1 - e->squaredNorm() / (width * width);
            H += left * left * J.transpose() * J;
            g += left * left * J.transpose() * *e;
        }
        return perturbed(pose, -H.ldlt().solve(g));
    }

    Scene scene;
    Correspondences data;
    std::vector<Metric> metrics;
};

Pose near(cv::RNG& rng, const Pose& pose, double size)
{
    Vector6d xi;
    xi << size * gaussian3(rng), size * gaussian3(rng);
    return perturbed(pose, xi);
}

// All that so many points fill the lanes of.
std::vector<const RayKernels*> kernelsFor(int n)
{
    std::vector<const RayKernels*> out;
    for (const RayKernels* kernels : availableKernels())
        if (kernels->lanes <= n)
            out.push_back(kernels);
    return out;
}

TEST(Gmlpnp_Ransac, scoreIsItsDefinition)
{
    cv::RNG rng = testRng();
    for (const int n : {4, 7, 8, 9, 63, 64, 65, 500}) {
        const Problem problem(rng, n, 0.3);
        for (const RayKernels* kernels : kernelsFor(n)) {
            SCOPED_TRACE(testing::Message() << kernels->name << ", " << n << " points");
            const ScoredPoints points(problem.data, problem.metrics, rng, *kernels);
            for (const double size : {1e-3, 1e-2, 1.}) {
                const Pose pose = near(rng, problem.data.fromObject(problem.scene.truth), size);
                const Score expected = problem.score(pose), found = points.score(pose);
                EXPECT_NEAR(expected.cost, found.cost, 1e-9 * n);
                EXPECT_EQ(expected.inliers, found.inliers);
                EXPECT_EQ(problem.inliers(pose), points.inliers(pose));
            }
        }
    }
}

TEST(Gmlpnp_Ransac, robustStepIsItsDefinition)
{
    cv::RNG rng = testRng();
    for (const int n : {6, 7, 8, 9, 10, 65, 500})
        for (const double width : {1.5, 3.}) {
            const Problem problem(rng, n, 0.3);
            const Pose pose = near(rng, problem.data.fromObject(problem.scene.truth), 3e-3);
            const Pose expected = problem.stepped(pose, width);
            for (const RayKernels* kernels : kernelsFor(n)) {
                Pose found = pose;
                ASSERT_TRUE(ScoredPoints(problem.data, problem.metrics, rng, *kernels).step(found, width, n));
                EXPECT_TRUE(poseNear(found, expected, 1e-6, 1e-6)) << kernels->name << ", " << n << " points";
            }
        }
}

TEST(Gmlpnp_Ransac, givingUpEarlySparesTheBetter)
{
    cv::RNG rng = testRng();
    int better = 0, lost = 0, worse = 0, spared = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        const Problem problem(rng, 400, rng.uniform(0., 0.9));
        const ScoredPoints points(problem.data, problem.metrics, rng);
        const Pose truth = problem.data.fromObject(problem.scene.truth);
        const Score a = points.score(near(rng, truth, 3e-3));
        const Pose b = trial % 2 ? near(rng, truth, 3e-3) : Pose{randomRotation(rng), truth.t};
        const Score full = points.score(b), early = points.scoreAgainst(b, a.cost);
        if (std::isfinite(early.cost)) {
            EXPECT_EQ(full.cost, early.cost);
        }
        if (full.cost < a.cost) {
            ++better;
            lost += !std::isfinite(early.cost);
        } else if (trial % 2 == 0) {
            ++worse;
            spared += std::isfinite(early.cost);
        }
    }
    ASSERT_GT(better, 300);
    EXPECT_LE(lost, better / 100);
    EXPECT_LE(spared, worse / 10);
}

TEST(Gmlpnp_Ransac, robustStepsFindTheTruth)
{
    cv::RNG rng = testRng();
    for (int trial = 0; trial < 50; ++trial) {
        const Problem problem(rng, exactScene(rng, surroundingPoints(rng, 60)), 0.4);
        const ScoredPoints points(problem.data, problem.metrics, rng);
        const Pose truth = problem.data.fromObject(problem.scene.truth);
        Pose pose = near(rng, truth, 1e-3);
        for (int round = 0; round < 10; ++round)
            ASSERT_TRUE(points.step(pose, 1.5, points.size()));
        // Wrong correspondences that lie within the threshold by chance pull a little.
        EXPECT_TRUE(poseNear(pose, truth, 1e-3, 1e-3)) << "trial " << trial;
    }
}

// --- Search ---

TEST(Gmlpnp_Ransac, orderSavesSamples)
{
    cv::RNG rng = testRng();
    int uniform = 0, ordered = 0;
    for (int trial = 0; trial < 20; ++trial) {
        const Problem problem(rng, 300, 0.85);  // the wrong ones come last
        RansacOptions options{0.99, 10000, static_cast<uint64>(trial), false, 1e-3, std::nullopt};
        const auto a = findConsensus(problem.data, problem.metrics, options);
        options.ordered = true;
        const auto b = findConsensus(problem.data, problem.metrics, options);
        ASSERT_TRUE(a && b);
        EXPECT_TRUE(poseNear(b->pose, problem.scene.truth, 0.02, 0.1));
        uniform += a->iterations;
        ordered += b->iterations;
    }
    EXPECT_LT(10 * ordered, uniform);
}

TEST(Gmlpnp_Ransac, confidenceIsKept)
{
    // Of 80 % wrong correspondences a sample of three is clean with .008; 99 % of the searches must end right.
    cv::RNG rng = testRng();
    int right = 0, iterations = 0;
    constexpr int TRIALS = 300;
    for (int trial = 0; trial < TRIALS; ++trial) {
        const Problem problem(rng, 200, 0.8);
        const auto found =
            findConsensus(problem.data, problem.metrics, {0.99, 10000, static_cast<uint64>(trial), false, 1e-3, {}});
        ASSERT_TRUE(found);
        right += bool(poseNear(found->pose, problem.scene.truth, 0.05, 0.3));
        iterations += found->iterations;
    }
    EXPECT_GE(right, 290);                // 297 expected, with a standard deviation of 1.7
    EXPECT_LT(iterations, TRIALS * 900);  // one in five clean samples may lead nowhere: 720 are asked for
}

}  // namespace
}  // namespace opencv_test
