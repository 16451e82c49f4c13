// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>

#include "csv.hpp"
#include "solvers.hpp"
#include "trials.hpp"

// What the experiments rest on: their statistics, their threads, and that each solver is told the noise it has.

namespace {

using namespace experiments;

TEST(Statistics, intervalsOfTheMeanHoldItInNineteenOfTwenty)
{
    constexpr int REPETITIONS = 400, TRIALS = 100;
    const Bootstrap bootstrap(TRIALS);
    cv::RNG rng(1);
    int mean = 0, ratio = 0;
    for (int r = 0; r < REPETITIONS; ++r) {
        std::vector<double> a(TRIALS), b(TRIALS);
        for (int k = 0; k < TRIALS; ++k) {
            b[k] = 3 + rng.gaussian(1);
            a[k] = 0.5 * b[k] + 0.5 + rng.gaussian(0.2);
        }
        const Interval m = bootstrap.mean(a), q = bootstrap.ratio(a, b);
        mean += m.low <= 2 && 2 <= m.high;
        ratio += q.low <= 2. / 3 && 2. / 3 <= q.high;
        EXPECT_LT(q.high - q.low, m.high - m.low);  // the same problems: what they have in common cancels
    }
    // Four standard deviations of the share; the percentile bootstrap is a little narrow.
    EXPECT_NEAR(mean, 0.945 * REPETITIONS, 4 * std::sqrt(0.05 * 0.95 * REPETITIONS));
    EXPECT_NEAR(ratio, 0.945 * REPETITIONS, 4 * std::sqrt(0.05 * 0.95 * REPETITIONS));
}

TEST(Statistics, whatIsNotANumberIsLeftOut)
{
    const double none = std::numeric_limits<double>::quiet_NaN();
    const Bootstrap bootstrap(3);
    EXPECT_EQ(2, bootstrap.mean({1, none, 3}).value);
    EXPECT_EQ(0.5, bootstrap.ratio({1, none, 3}, {2, 5, none}).value);
    EXPECT_TRUE(std::isnan(bootstrap.mean({none, none, none}).value));
    EXPECT_EQ(2, median({3, none, 1}));
    EXPECT_EQ(3, median({5, 3, 1}));
    EXPECT_TRUE(std::isnan(median({none})));
    EXPECT_EQ(2, countNumbers({3, none, 1}));
}

// Newcombe 1998, table I: 81 of 263 and 0 of 20.
TEST(Statistics, shareHasWilsonsInterval)
{
    const Interval some = share(81, 263), no = share(0, 20);
    EXPECT_NEAR(some.low, 0.2553, 5e-5);
    EXPECT_NEAR(some.high, 0.3662, 5e-5);
    EXPECT_NEAR(no.low, 0, 1e-12);
    EXPECT_NEAR(no.high, 0.1611, 5e-5);
}

TEST(Trials, areCalledOnceEachAndThrowToTheCaller)
{
    Progress progress("test", 2000);
    std::vector<std::atomic<int>> calls(1000);
    forTrials(1000, 4, progress, [&](int k) { ++calls[k]; });
    EXPECT_TRUE(std::all_of(calls.begin(), calls.end(), [](const auto& count) { return count == 1; }));
    EXPECT_THROW(forTrials(1000, 4, progress,
                           [](int k) {
                               if (k == 100)
                                   throw std::runtime_error("trial");
                           }),
                 std::runtime_error);
}

// Uniform numbers of neighbouring trials are not neighbours: their mean, and the correlation of one with the next.
TEST(Trials, haveIndependentGenerators)
{
    constexpr int COUNT = 10000;
    double sum = 0, product = 0, last = 0;
    for (int k = 0; k < COUNT; ++k) {
        const double x = trialRng("points", 3, k).uniform(-1., 1.);
        sum += x;
        product += x * last;
        last = x;
    }
    EXPECT_LT(std::abs(sum), 4 * std::sqrt(COUNT / 3.));
    EXPECT_LT(std::abs(product), 4 * std::sqrt(COUNT) / 3);
    EXPECT_NE(trialRng("points", 3, 1).next(), trialRng("noise", 3, 1).next());
    EXPECT_NE(trialRng("points", 3, 1).next(), trialRng("points", 4, 1).next());
    EXPECT_EQ(trialRng("points", 3, 1).next(), trialRng("points", 3, 1).next());
}

// One point of the camera frame seen 20000 times: what is across the true ray must have the covariance that is given to
// the solvers. Strong anisotropy and a random pose: a wrong frame or a missing depth is off by far more than 5 %.
void expectTrueCovariances(const cv::Ptr<cv::gmlpnp::CameraModel>& camera, const Vector3d& X, double sigma, double px)
{
    constexpr int COUNT = 20000;
    cv::RNG rng(7);
    Scene scene = synthetic::exactScene(rng, std::vector<Vector3d>(COUNT, X));
    synthetic::disturb(rng, scene, sigma, px, *camera);
    const Problem problem = prepared(scene, camera, false);
    const Vector3d m = X.normalized(), a = m.unitOrthogonal(), b = m.cross(a);
    Matrix2d covariance = Matrix2d::Zero(), given = Matrix2d::Zero();
    for (int i = 0; i < COUNT; ++i) {
        const Vector3d e = (scene.truth * problem.data.points.col(i)).normalized() - problem.data.rays.col(i);
        const Eigen::Vector2d across(a.dot(e), b.dot(e));
        covariance += across * across.transpose() / COUNT;
        Eigen::Matrix<double, 3, 2> basis;
        basis << a, b;
        given += basis.transpose() * problem.rayCovariances[i] * basis / COUNT;
    }
    EXPECT_LT((covariance - given).norm(), 0.05 * given.norm()) << covariance << "\n\n" << given;
}

TEST(Problem, rayCovariancesAreThoseOfTheNoise)
{
    expectTrueCovariances(pinhole(), {1.5, -1, 5}, 0.1, 0.01);
    expectTrueCovariances(pinhole(), {1.5, -1, 5}, 0.001, 3);
    expectTrueCovariances(pinhole(), {1.5, -1, 5}, 0.01, 2);
    expectTrueCovariances(wideLens(), {3, -2, -1}, 0.01, 2);
}

// GMLPnP* is told the true noise of points and pixels: then the covariance of its pose must be true, too.
TEST(Solvers, trueNoiseIsGivenInTheRightFrame)
{
    constexpr int TRIALS = 400;
    for (const Draw& draw :
         {coneProblem(40, 50, 0.02, 2), depthProblem(40, 3, 60, 0.05, 1), wideProblem(40, 0.05, 1)}) {
        int hits = 0;
        for (int k = 0; k < TRIALS; ++k) {
            cv::RNG rng = trialRng("true noise", 0, k);
            const Problem problem = draw(rng);
            const std::optional<cv::gmlpnp::Result> result = solved(problem, trueNoise(problem));
            ASSERT_TRUE(result);
            const auto xi = cv::gmlpnp::detail::difference(problem.scene.truth, poseOf(*result));
            const cv::Mat& C = result->poseCovariance;
            hits +=
                xi.dot(Eigen::Map<const baselines::Matrix6d>(C.ptr<double>()).ldlt().solve(xi)) <= synthetic::CHI2_6_95;
        }
        EXPECT_NEAR(hits, 0.95 * TRIALS, 4 * std::sqrt(0.05 * 0.95 * TRIALS));
    }
}

TEST(Solvers, everyOneSolvesTheProblemsThatItCan)
{
    cv::RNG rng(1);
    const Problem seen = paperProblem(40, 0.01, 0.1)(rng), wide = wideProblem(40, 0.01, 0.1)(rng);
    for (const Problem* problem : {&seen, &wide})
        for (const Solver& solver : solversFor(problem->perspective)) {
            const std::optional<Pose> pose = solver.solve(*problem);
            ASSERT_TRUE(pose) << solver.name;
            EXPECT_LT(synthetic::columnAngle(pose->R, problem->scene.truth.R), 0.5) << solver.name;
            EXPECT_LT((pose->t - problem->scene.truth.t).norm(), 0.05) << solver.name;
        }
    EXPECT_LT(solversFor(false).size(), solversFor(true).size());
}

}  // namespace
