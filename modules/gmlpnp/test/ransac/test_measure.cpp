// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../../src/ransac/measure.hpp"
#include "../scenes.hpp"
#include "../statistics.hpp"

namespace opencv_test {
namespace {

using namespace cv::gmlpnp::detail;

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

class Gmlpnp_VarianceLeftStatistics : public testing::TestWithParam<double>
{};

TEST_P(Gmlpnp_VarianceLeftStatistics, isThatOfTheResidualsWithinTheThreshold)
{
    const double sigma = GetParam();  // thresholds
    cv::RNG rng = testRng();
    Mean square;
    for (int i = 0; i < 400000; ++i) {
        const double u = rng.gaussian(sigma), v = rng.gaussian(sigma), e2 = u * u + v * v;
        if (e2 < 1)
            square.add(e2);
    }
    const double unit = 1 / (2 * sigma * sigma), left = unit * square.value();
    EXPECT_TRUE(within(left - varianceLeft(square.value()), -0.004, 0.004, unit * square.deviation()));
}

INSTANTIATE_TEST_SUITE_P(/**/, Gmlpnp_VarianceLeftStatistics, testing::Values(0.05, 0.2, 0.3, 0.5, 0.6), nameOfNumber);

TEST(Gmlpnp_Ransac, varianceThatAThresholdLeaves)
{
    EXPECT_EQ(1, varianceLeft(0));
    // Uniform residuals, or more of them at the rim, bound the noise from below alone.
    EXPECT_EQ(varianceLeft(0.5), varianceLeft(1));
    EXPECT_EQ(varianceLeft(0.5), varianceLeft(10));
}

}  // namespace
}  // namespace opencv_test
