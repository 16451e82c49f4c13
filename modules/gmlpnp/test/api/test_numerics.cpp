// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include <cfenv>
#include <functional>

#include "../../src/rays/ray_pass.hpp"
#include "../scenes.hpp"
#include "../statistics.hpp"

// Many points, floating-point exceptions, instruction sets and threads.

namespace opencv_test {
namespace {

using namespace cv::gmlpnp::detail;
using cv::gmlpnp::Params;
using cv::gmlpnp::Result;

// Programs that trap invalid operations, divisions by zero and overflows may call with any finite data.
TEST(Gmlpnp_Numerics, finiteDataRaiseNoFloatingPointExceptions)
{
    constexpr int TRAPPED = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW;
    cv::RNG rng = testRng();
    const cv::Matx33d K = paperCamera();
    const auto quiet = [](const std::function<void()>& call) {
        std::feclearexcept(FE_ALL_EXCEPT);
        call();
        const int raised = std::fetestexcept(TRAPPED);
        return raised == 0 ? testing::AssertionSuccess() : testing::AssertionFailure() << "flags " << raised;
    };
    for (const int n : {4, 5, 6, 20, 300, 1000})
        for (const double noise : {0., 1.})
            for (const bool flat : {false, true}) {
                SCOPED_TRACE(testing::Message() << n << " points, noise " << noise << (flat ? ", flat" : ""));
                Scene scene = exactScene(rng, boxPoints(rng, n, flat));
                synthetic::disturb(rng, scene, 0.02 * noise, noise, *cv::gmlpnp::CameraModel::pinhole(K));
                Result result;
                std::vector<Result> results;
                std::vector<int> inliers;
                std::vector<cv::Mat> rvecs, tvecs;
                for (const int method : METHODS) {
                    const Params params = paramsOf(method);
                    EXPECT_TRUE(quiet([&] {
                        cv::gmlpnp::solve(scene.objectPoints, scene.imagePoints, K, cv::noArray(), result, params);
                    }));
                    EXPECT_TRUE(quiet([&] {
                        cv::gmlpnp::solvePnPGeneric(scene.objectPoints, scene.imagePoints, K, cv::noArray(), rvecs,
                                                    tvecs, false, method);
                    }));
                    EXPECT_TRUE(quiet([&] {
                        cv::gmlpnp::solveRansac(scene.objectPoints, scene.imagePoints, K, cv::noArray(), result,
                                                inliers, {}, params);
                    }));
                }
            }
    Result result;
    const Scene scene = paperScene(rng, 20, 0.1, 1);
    const cv::Mat place(20, 3, CV_64F, cv::Scalar(1.5));
    EXPECT_TRUE(quiet([&] { cv::gmlpnp::solveRays(place, scene.rays, result); })) << "one place";
    for (const auto& lens :
         {cv::gmlpnp::CameraModel::pinhole(K), cv::gmlpnp::CameraModel::fisheye(K),
          cv::gmlpnp::CameraModel::omnidir(K, cv::noArray(), 1), cv::gmlpnp::CameraModel::eucm(K, 0.5, 1),
          cv::gmlpnp::CameraModel::doubleSphere(K, 0, 0.5), cv::gmlpnp::CameraModel::equirectangular({2000, 1000})})
        for (const cv::Vec3d& point : {cv::Vec3d(1, 0, 0), cv::Vec3d(0, 0, 0), cv::Vec3d(0, 0, -1)}) {
            cv::Point2d pixel;
            EXPECT_TRUE(quiet([&] { lens->projectPoint(point, pixel); })) << point;
        }
}

std::string nameOfMethod(const testing::TestParamInfo<int>& info)
{
    return methodName(info.param);
}

class Gmlpnp_NumericsStatistics : public testing::TestWithParam<int>
{};

TEST_P(Gmlpnp_NumericsStatistics, aMillionPoints)
{
    constexpr int N = 1000000;
    const int method = GetParam();
    cv::RNG rng = testRng();
    const Scene scene = paperScene(rng, N, 0.1, 1);
    const Result result = solved(scene, paramsOf(method));
    EXPECT_TRUE(std::isfinite(result.cost));
    EXPECT_EQ(N, result.usedPoints);
    cv::Vec3d rvec, tvec;  // by parts
    ASSERT_TRUE(cv::gmlpnp::solvePnP(scene.objectPoints, scene.imagePoints, paperCamera(), cv::noArray(), rvec, tvec,
                                     false, method));
    // The bias of the published method does not shrink with n. It is that of the shape of the noise, up to .003 rad in
    // 13 draws.
    if (method == cv::gmlpnp::SOLVEPNP_GMLPNP) {
        EXPECT_TRUE(poseNear(result, scene.truth, 5e-3, 2e-2));
        EXPECT_TRUE(poseNear(poseOf(rvec, tvec), scene.truth, 5e-3, 2e-2));
        return;
    }
    EXPECT_LT(cv::trace(result.poseCovariance)[0], 1e-6);
    EXPECT_LT(mahalanobis2(poseOf(rvec, tvec), poseOf(result), result.poseCovariance), 0.25 * 6);
    EXPECT_TRUE(asChiSquared6(mahalanobis2(scene.truth, poseOf(result), result.poseCovariance)));
}

INSTANTIATE_TEST_SUITE_P(/**/, Gmlpnp_NumericsStatistics, testing::ValuesIn(METHODS), nameOfMethod);

// Ten Gauss-Newton steps with the kernels of each instruction set end at the same pose to the bound of the order.
TEST(Gmlpnp_Numerics, instructionSetsAgree)
{
    cv::RNG rng = testRng();
    for (int n : {6, 50, 1001}) {
        const Scene scene = paperScene(rng, n, 0.05, 1);
        const Correspondences data(scene.objectPoints, scene.rays);
        const Noise noise{1e-3 * Matrix3d::Identity(), 1e-6 * Matrix3d::Identity(), {0.1}};
        const auto poseBy = [&](const RayKernels& kernels) {
            Pose pose = data.fromObject(scene.truth);
            for (int k = 0; k < 10; ++k) {
                const RaySums sums = rayPass(data, pose, noise, {}, kernels);
                pose = perturbed(pose, -sums.H.ldlt().solve(sums.g));
            }
            return pose;
        };
        const Pose scalar = poseBy(*availableKernels().back());
        for (const RayKernels* kernels : availableKernels()) {
            if (kernels->lanes > n)
                continue;
            EXPECT_TRUE(poseNear(poseBy(*kernels), scalar, 1e-9, 1e-9 * scalar.t.norm())) << kernels->name << ", " << n;
        }
    }
}

// cv::setNumThreads changes no bit, neither of a solve nor of a search.
TEST(Gmlpnp_Numerics, numbersOfThreadsAgreeToTheBit)
{
    cv::RNG rng = testRng();
    const int before = cv::getNumThreads();
    for (int n : {50, 5000, 50000}) {
        const Scene scene = paperScene(rng, n, 0.02, 1);
        Result reference;
        std::vector<int> referenceInliers;
        for (int threads : {1, 2, 8}) {
            cv::setNumThreads(threads);
            Result rays, pixels;
            std::vector<int> inliers;
            ASSERT_TRUE(cv::gmlpnp::solveRays(scene.objectPoints, scene.rays, rays));
            ASSERT_TRUE(cv::gmlpnp::solveRansac(scene.objectPoints, scene.imagePoints, paperCamera(), cv::noArray(),
                                                pixels, inliers));
            if (threads == 1) {
                reference = rays;
                reference.cameraCenter = pixels.cameraCenter;
                referenceInliers = inliers;
            }
            EXPECT_EQ(reference.rvec, rays.rvec);
            EXPECT_EQ(reference.tvec, rays.tvec);
            EXPECT_EQ(reference.cost, rays.cost);
            EXPECT_EQ(0, cv::norm(reference.poseCovariance, rays.poseCovariance, cv::NORM_INF));
            EXPECT_EQ(reference.cameraCenter, pixels.cameraCenter);
            EXPECT_EQ(referenceInliers, inliers);
        }
    }
    cv::setNumThreads(before);
}

}  // namespace
}  // namespace opencv_test
