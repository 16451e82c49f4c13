// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../../src/ransac/repeats.hpp"
#include "../scenes.hpp"

namespace opencv_test {
namespace {

using namespace cv::gmlpnp::detail;

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
        metrics.push_back(angularMetric(data.unitRayAt(i), THRESHOLD));
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
        metrics.push_back(angularMetric(data.unitRayAt(i), 1e-6));
    EXPECT_GE(static_cast<int>(withoutRepeats(data, metrics).size()), N - 10);
}

}  // namespace
}  // namespace opencv_test
