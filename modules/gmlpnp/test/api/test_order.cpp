// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../scenes.hpp"
#include "../statistics.hpp"

// The order of the points is not in the pose.

namespace opencv_test {
namespace {

using namespace cv::gmlpnp::detail;
using cv::gmlpnp::Params;
using cv::gmlpnp::Result;

cv::Mat_<double> permuted(const cv::Mat_<double>& rows, const std::vector<int>& order)
{
    cv::Mat_<double> out(rows.size());
    for (int i = 0; i < rows.rows; ++i)
        rows.row(order[i]).copyTo(out.row(i));
    return out;
}

std::vector<int> shuffled(cv::RNG& rng, int n)
{
    std::vector<int> order(n);
    for (int i = 0; i < n; ++i) {
        order[i] = i;
        std::swap(order[i], order[rng.uniform(0, i + 1)]);
    }
    return order;
}

TEST(Gmlpnp_Numerics, theOrderOfThePointsDoesNotMatter)
{
    cv::RNG rng = testRng();
    for (int method : METHODS)
        for (int n : {4, 6, 10, 50, 199, 500, 5000})
            for (int k = 0; k < 5; ++k) {
                SCOPED_TRACE(testing::Message() << "method " << method << ", n " << n << ", problem " << k);
                const Scene scene = paperScene(rng, n, 0.05, 1);
                const std::vector<int> order = shuffled(rng, n);
                Result a, b;
                ASSERT_TRUE(cv::gmlpnp::solveRays(scene.objectPoints, scene.rays, a, paramsOf(method)));
                ASSERT_TRUE(cv::gmlpnp::solveRays(permuted(scene.objectPoints, order), permuted(scene.rays, order), b,
                                                  paramsOf(method)));
                EXPECT_TRUE(poseNear(b, poseOf(a), 1e-9, 1e-9 * cv::norm(a.tvec)));
                EXPECT_LT(cv::norm(a.poseCovariance, b.poseCovariance), 1e-6 * cv::norm(a.poseCovariance));
            }
}

struct Cell
{
    int method, n;

    std::string name() const { return methodName(method) + cv::format("%dPoints", n); }
    friend void PrintTo(const Cell& cell, std::ostream* out) { *out << cell.name(); }
};

class Gmlpnp_OrderStatistics : public testing::TestWithParam<Cell>
{};

// Where only the pose is asked for, scoring looks at a quarter of 200 points and more, and of 600 and more a part finds
// the noise. Which points these are depends on the order; the pose by less than a third of its standard deviation.
TEST_P(Gmlpnp_OrderStatistics, theOrderMattersLittleToThePoseOfManyPoints)
{
    const Cell& cell = GetParam();
    cv::RNG rng = testRng();
    Mean square;  // of the deviation in standard deviations, mean over the six parameters
    for (int k = 0; k < 30; ++k) {
        const Scene scene = paperScene(rng, cell.n, 0.05, 1);
        const std::vector<int> order = shuffled(rng, cell.n);
        const Result result = solved(scene, paramsOf(cell.method));
        cv::Vec3d rvec[2], tvec[2];
        ASSERT_TRUE(cv::gmlpnp::solvePnP(scene.objectPoints, scene.imagePoints, paperCamera(), cv::noArray(), rvec[0],
                                         tvec[0], false, cell.method));
        ASSERT_TRUE(cv::gmlpnp::solvePnP(permuted(scene.objectPoints, order), permuted(scene.imagePoints, order),
                                         paperCamera(), cv::noArray(), rvec[1], tvec[1], false, cell.method));
        square.add(mahalanobis2(poseOf(rvec[1], tvec[1]), poseOf(rvec[0], tvec[0]), result.poseCovariance) / 6);
    }
    if (cell.n < 200) {
        EXPECT_LT(square.value(), 1e-12);
    } else {
        EXPECT_TRUE(atMost(square.value(), 0.08, square.deviation()));
        EXPECT_LT(square.value(), 1. / 9);
    }
}

std::vector<Cell> cells()
{
    std::vector<Cell> all;
    for (const int method : METHODS)
        for (const int n : {50, 200, 500, 1000, 5000})
            all.push_back({method, n});
    return all;
}

INSTANTIATE_TEST_SUITE_P(/**/, Gmlpnp_OrderStatistics, testing::ValuesIn(cells()), nameOf<Cell>);

// RANSAC draws its samples by number, so another order is another search. The pose that it ends at moves by a fraction
// of its standard deviation: inliers on the edge of the threshold may differ.
TEST(Gmlpnp_Numerics, ransacInAnotherOrderFindsTheSamePose)
{
    cv::RNG rng = testRng();
    for (int method : METHODS)
        for (int k = 0; k < 10; ++k) {
            Scene scene = paperScene(rng, 200, 0.02, 1);
            for (int i = 0; i < 60; ++i) {
                scene.imagePoints(i, 0) = rng.uniform(0., 640.);
                scene.imagePoints(i, 1) = rng.uniform(0., 480.);
            }
            const std::vector<int> order = shuffled(rng, 200);
            Result a, b;
            std::vector<int> inliers;
            ASSERT_TRUE(cv::gmlpnp::solveRansac(scene.objectPoints, scene.imagePoints, paperCamera(), cv::noArray(), a,
                                                inliers, {}, paramsOf(method)));
            ASSERT_TRUE(cv::gmlpnp::solveRansac(permuted(scene.objectPoints, order), permuted(scene.imagePoints, order),
                                                paperCamera(), cv::noArray(), b, inliers, {}, paramsOf(method)));
            const double distance = std::sqrt(mahalanobis2(poseOf(b), poseOf(a), a.poseCovariance));
            EXPECT_LT(distance, 0.5) << "standard deviations, problem " << k;
        }
}

}  // namespace
}  // namespace opencv_test
