// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include <thread>

#include "../expect_error.hpp"
#include "../scenes.hpp"

// Many problems at once, and one problem from many threads: the bits of each alone.

namespace opencv_test {
namespace {

using cv::gmlpnp::Params;
using cv::gmlpnp::Result;

bool identical(const Result& a, const Result& b)
{
    const auto same = [](const cv::Mat& x, const cv::Mat& y) {
        return x.size() == y.size() && (x.empty() || std::memcmp(x.data, y.data, x.total() * x.elemSize()) == 0);
    };
    return a.status == b.status && a.rounds == b.rounds && a.cost == b.cost && a.rvec == b.rvec && a.tvec == b.tvec &&
           same(a.poseCovariance, b.poseCovariance) && same(a.objectNoise, b.objectNoise) &&
           same(a.bearingNoise, b.bearingNoise);
}

TEST(Gmlpnp_Solve, sameInputSameBitsFromAnyThread)
{
    cv::RNG rng = testRng();
    const Scene scene = paperScene(rng, 50, 0.1, 1);
    for (int method : METHODS) {
        const Result reference = solved(scene, paramsOf(method));
        std::vector<Result> results(4);
        std::vector<std::thread> threads;
        for (Result& result : results)
            threads.emplace_back([&, method] {
                for (int k = 0; k < 20; ++k)
                    cv::gmlpnp::solveRays(scene.objectPoints, scene.rays, result, paramsOf(method));
            });
        for (std::thread& thread : threads)
            thread.join();
        for (const Result& result : results)
            EXPECT_TRUE(identical(reference, result));
    }
}

TEST(Gmlpnp_Solve, aBatchIsItsProblemsOneByOne)
{
    cv::RNG rng = testRng();
    std::vector<cv::Mat> points, rays;
    for (int n : {50, 3, 6, 200, 1000, 20, 4}) {
        const Scene scene = paperScene(rng, n, 0.1, 1);
        points.push_back(scene.objectPoints);
        rays.push_back(scene.rays);
    }
    points[5].col(2) = 0, points[5].col(1) = 0;  // a line
    const int threads = cv::getNumThreads();
    for (int method : METHODS)
        for (int count : {1, 4}) {
            cv::setNumThreads(count);
            std::vector<Result> results(1);
            EXPECT_EQ(5, cv::gmlpnp::solveBatch(points, rays, results, paramsOf(method)));
            ASSERT_EQ(points.size(), results.size());
            for (size_t k = 0; k < points.size(); ++k) {
                Result alone;
                cv::gmlpnp::solveRays(points[k], rays[k], alone, paramsOf(method));
                EXPECT_TRUE(identical(alone, results[k])) << "problem " << k;
            }
            EXPECT_EQ(cv::gmlpnp::STATUS_TOO_FEW_POINTS, results[1].status);
            EXPECT_EQ(cv::gmlpnp::STATUS_DEGENERATE, results[5].status);
        }
    cv::setNumThreads(threads);
}

TEST(Gmlpnp_Solve, aBatchTakesListsOfVectorsAndRefusesByName)
{
    const std::vector<cv::Point3f> points = {{0, 0, 3}, {1, 0, 4}, {0, 1, 5}, {1, 1, 3}, {-1, 0, 4}, {0, -1, 3}};
    const std::vector<std::vector<cv::Point3f>> twice(2, points);
    std::vector<Result> results;
    EXPECT_EQ(2, cv::gmlpnp::solveBatch(twice, twice, results));
    EXPECT_EQ(0, cv::gmlpnp::solveBatch(std::vector<cv::Mat>(), std::vector<cv::Mat>(), results));
    EXPECT_TRUE(results.empty());

    const std::vector<std::vector<cv::Point3f>> nothingSeen = {points, {}, points};
    EXPECT_EQ(2, cv::gmlpnp::solveBatch(nothingSeen, nothingSeen, results));
    ASSERT_EQ(3u, results.size());
    EXPECT_EQ(cv::gmlpnp::STATUS_TOO_FEW_POINTS, results[1].status);

    results.resize(1);
    const std::vector<std::vector<cv::Point3f>> once(1, points), shorter = {points, {points[0], points[1]}};
    expectError(cv::Error::StsAssert, "number of problems", [&] { cv::gmlpnp::solveBatch(twice, once, results); });
    expectError(cv::Error::StsAssert, "problem 1: ", [&] { cv::gmlpnp::solveBatch(twice, shorter, results); });
    Params params;
    params.objectCovariances = cv::Mat::zeros(6, 9, CV_64F);
    expectError(cv::Error::StsBadArg, "objectCovariances",
                [&] { cv::gmlpnp::solveBatch(once, once, results, params); });
    EXPECT_EQ(1u, results.size());
}

}  // namespace
}  // namespace opencv_test
