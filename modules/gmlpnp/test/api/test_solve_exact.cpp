// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../scenes.hpp"

// Exact data are solved exactly, of every size and shape; noisy ones nearly so.

namespace opencv_test {
namespace {

using cv::gmlpnp::CameraModel;
using cv::gmlpnp::Result;

void expectComplete(const Result& result, int n)
{
    EXPECT_EQ(n, result.usedPoints);
    EXPECT_TRUE(std::isfinite(result.cost));
    for (const cv::Mat* m : {&result.poseCovariance, &result.poseCovarianceRt, &result.cameraCenterCovariance,
                             &result.objectNoise, &result.bearingNoise}) {
        ASSERT_EQ(CV_64F, m->type());
        EXPECT_TRUE(cv::checkRange(*m, true, nullptr, -DBL_MAX, DBL_MAX));
        EXPECT_EQ(0, cv::norm(*m, m->t(), cv::NORM_INF)) << "symmetric";
    }
    EXPECT_EQ(cv::Size(6, 6), result.poseCovariance.size());
    EXPECT_EQ(cv::Size(6, 6), result.poseCovarianceRt.size());
    EXPECT_EQ(cv::Size(3, 3), result.cameraCenterCovariance.size());
}

TEST(Gmlpnp_Solve, exactDataToOneInABillion)
{
    cv::RNG rng = testRng();
    for (int method : METHODS)
        for (int n : {4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 50, 500})
            for (int shape = 0; shape < 3; ++shape) {
                if (n < 6 && shape == 2)
                    continue;  // few points all around are a minimal problem with more than one answer
                SCOPED_TRACE(testing::Message() << "method " << method << ", n " << n << ", shape " << shape);
                const Scene scene =
                    exactScene(rng, shape == 2 ? surroundingPoints(rng, n) : boxPoints(rng, n, shape == 1));
                Result result;
                ASSERT_TRUE(cv::gmlpnp::solveRays(scene.objectPoints, scene.rays, result, paramsOf(method)));
                EXPECT_TRUE(poseNear(result, scene.truth, 1e-9, 1e-8));
                expectComplete(result, n);
            }
}

TEST(Gmlpnp_Solve, noisyDataForEverySmallNumberOfPoints)
{
    cv::RNG rng = testRng();
    for (int method : METHODS)
        for (int n = 6; n <= 14; ++n)
            for (int k = 0; k < 20; ++k) {
                SCOPED_TRACE(testing::Message() << "method " << method << ", n " << n << ", problem " << k);
                const Scene scene = paperScene(rng, n, 0.02, 0.5);
                const Result result = solved(scene, paramsOf(method));
                EXPECT_TRUE(poseNear(result, scene.truth, 0.1, 0.6));
                expectComplete(result, n);
            }
}

TEST(Gmlpnp_Solve, pixelsOfAPinholeAreRays)
{
    cv::RNG rng = testRng();
    for (int method : METHODS) {
        const Scene scene = paperScene(rng, 30, 0.1, 1);
        const Result a = solved(scene, paramsOf(method));
        Result plain, b, c;
        const cv::Ptr<CameraModel> pinhole = CameraModel::pinhole(paperCamera());
        ASSERT_TRUE(cv::gmlpnp::solve(scene.objectPoints, scene.imagePoints, cv::makePtr<PlainLens>(pinhole), plain,
                                      paramsOf(method)));
        EXPECT_TRUE(poseNear(plain, poseOf(a), 1e-9, 1e-9));
        ASSERT_TRUE(cv::gmlpnp::solve(scene.objectPoints, scene.imagePoints, paperCamera(), cv::noArray(), b,
                                      paramsOf(method)));
        ASSERT_TRUE(cv::gmlpnp::solve(scene.objectPoints, scene.imagePoints, pinhole, c, paramsOf(method)));
        EXPECT_EQ(b.rvec, c.rvec);
        EXPECT_EQ(b.tvec, c.tvec);
    }
}

}  // namespace
}  // namespace opencv_test
