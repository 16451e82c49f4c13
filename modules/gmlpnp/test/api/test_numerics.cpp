// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include <cfenv>
#include <functional>

#include "../../src/rays/ray_pass.hpp"
#include "../scenes.hpp"

// Units, offsets, many points, the order of the points, instruction sets and threads: none of them is in the pose.

namespace opencv_test {
namespace {

using namespace cv::gmlpnp::detail;
using cv::gmlpnp::Params;
using cv::gmlpnp::Result;

cv::Mat_<double> affine(const cv::Mat& points, double scale, const cv::Vec3d& offset)
{
    cv::Mat_<double> out(points.size());
    for (int i = 0; i < out.rows; ++i)
        for (int k = 0; k < 3; ++k)
            out(i, k) = scale * points.at<double>(i, k) + offset[k];
    return out;
}

Pose poseOfResult(const Result& result)
{
    return poseOf(result.rvec, result.tvec);
}

// Metres and millimetres, with everything that has a unit of length: known noises, a guess, the threshold of RANSAC is
// in pixels.
TEST(Gmlpnp_Numerics, millimetres)
{
    cv::RNG rng = testRng();
    for (int k = 0; k < 4; ++k) {
        const Scene scene = paperScene(rng, 40, 0.05, 1);
        Params m = paramsOf(METHODS[k % 2]);
        if (k > 1) {  // these have no length in them
            m.bearingNoise = cv::Mat_<double>::eye(3, 3) * 1e-6;
            m.pixelCovariances = cv::Mat_<double>::ones(40, 1);
        }
        m.objectNoise = cv::Mat_<double>::eye(3, 3) * 0.0025;
        m.objectCovariances = cv::Mat_<double>::zeros(40, 9);
        for (int i = 0; i < 40; ++i)
            for (int axis = 0; axis < 3; ++axis)
                m.objectCovariances.at<double>(i, 4 * axis) = 1e-4 * (i + 1);
        m.useExtrinsicGuess = true;
        const Vector3d r = logSO3(scene.truth.R), t = scene.truth.t;
        m.rvec = {r.x() + 0.02, r.y(), r.z() - 0.03};
        m.tvec = {t.x(), t.y() + 0.1, t.z()};
        Params mm = m;
        mm.objectNoise = cv::Mat(m.objectNoise * 1e6);  // a new one: the arrays of Params are shared
        mm.objectCovariances = cv::Mat(m.objectCovariances * 1e6);
        mm.tvec = 1000 * m.tvec;
        Result a, b;
        ASSERT_TRUE(cv::gmlpnp::solve(scene.objectPoints, scene.imagePoints, paperCamera(), cv::noArray(), a, m));
        ASSERT_TRUE(cv::gmlpnp::solve(affine(scene.objectPoints, 1000, {}), scene.imagePoints, paperCamera(),
                                      cv::noArray(), b, mm));
        EXPECT_TRUE(poseNear(b, {poseOfResult(a).R, 1000 * poseOfResult(a).t}, 1e-11, 1e-8));
        EXPECT_LT(cv::norm(b.cameraCenterCovariance, 1e6 * a.cameraCenterCovariance),
                  1e-9 * cv::norm(b.cameraCenterCovariance));
        EXPECT_LT(cv::norm(b.bearingNoise, a.bearingNoise), 1e-9 * cv::norm(a.bearingNoise) + 1e-30);
    }
}

// Map coordinates in double: the offset costs no more than the rounding of the coordinates themselves (ECEF: 1e-9 m).
TEST(Gmlpnp_Numerics, mapCoordinates)
{
    const cv::Vec3d UTM(292742.252, 5731078.97, 186.663), ECEF(4041839.13, 624193.82, 4884512.07);
    cv::RNG rng = testRng();
    for (int method : METHODS)
        for (const cv::Vec3d& offset : {UTM, ECEF}) {
            const Scene scene = paperScene(rng, 60, 0.05, 1);
            const cv::Mat_<double> far = affine(scene.objectPoints, 1, offset);
            Result near, map;
            std::vector<int> inliersNear, inliersMap;
            ASSERT_TRUE(cv::gmlpnp::solve(scene.objectPoints, scene.imagePoints, paperCamera(), cv::noArray(), near,
                                          paramsOf(method)));
            ASSERT_TRUE(cv::gmlpnp::solve(far, scene.imagePoints, paperCamera(), cv::noArray(), map, paramsOf(method)));
            EXPECT_LT(rotationAngle(poseOfResult(near).R, poseOfResult(map).R), 1e-8);
            EXPECT_LT(cv::norm(map.cameraCenter - near.cameraCenter - offset), 1e-7);
            ASSERT_TRUE(cv::gmlpnp::solveRansac(scene.objectPoints, scene.imagePoints, paperCamera(), cv::noArray(),
                                                near, inliersNear, {}, paramsOf(method)));
            ASSERT_TRUE(cv::gmlpnp::solveRansac(far, scene.imagePoints, paperCamera(), cv::noArray(), map, inliersMap,
                                                {}, paramsOf(method)));
            EXPECT_EQ(inliersNear, inliersMap);
            EXPECT_LT(cv::norm(map.cameraCenter - near.cameraCenter - offset), 1e-7);
        }
}

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

TEST(Gmlpnp_Numerics, aMillionPoints)
{
    constexpr int N = 1000000;
    cv::RNG rng = testRng();
    const Scene scene = paperScene(rng, N, 0.1, 1);
    for (int method : METHODS) {
        Result result;
        ASSERT_TRUE(cv::gmlpnp::solveRays(scene.objectPoints, scene.rays, result, paramsOf(method)));
        EXPECT_TRUE(std::isfinite(result.cost));
        EXPECT_EQ(N, result.usedPoints);
        cv::Vec3d rvec, tvec;  // by parts
        ASSERT_TRUE(cv::gmlpnp::solvePnP(scene.objectPoints, scene.imagePoints, paperCamera(), cv::noArray(), rvec,
                                         tvec, false, method));
        if (method == cv::gmlpnp::SOLVEPNP_GMLPNP) {  // its bias does not shrink with n
            EXPECT_TRUE(poseNear(result, scene.truth, 2e-3, 2e-2));
            EXPECT_TRUE(poseNear(poseOf(rvec, tvec), scene.truth, 2e-3, 2e-2));
            continue;
        }
        EXPECT_LT(cv::trace(result.poseCovariance)[0], 1e-6);
        EXPECT_LT(mahalanobis2(poseOfResult(result), scene.truth, result.poseCovariance), 40);
        EXPECT_LT(mahalanobis2(poseOf(rvec, tvec), poseOfResult(result), result.poseCovariance), 0.25 * 6);
    }
}

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
                EXPECT_TRUE(poseNear(b, poseOfResult(a), 1e-9, 1e-9 * cv::norm(a.tvec)));
                EXPECT_LT(cv::norm(a.poseCovariance, b.poseCovariance), 1e-6 * cv::norm(a.poseCovariance));
            }
}

// Where only the pose is asked for, scoring looks at a quarter of 200 points and more, and of 600 and more a part finds
// the noise. Which points these are depends on the order; the pose by less than a third of its standard deviation.
TEST(Gmlpnp_Numerics, theOrderMattersLittleToThePoseOfManyPoints)
{
    cv::RNG rng = testRng();
    for (int method : METHODS)
        for (int n : {50, 200, 500, 1000, 5000}) {
            double square = 0;  // of the deviation in standard deviations, mean over the six parameters
            constexpr int PROBLEMS = 30;
            for (int k = 0; k < PROBLEMS; ++k) {
                const Scene scene = paperScene(rng, n, 0.05, 1);
                const std::vector<int> order = shuffled(rng, n);
                Result result;
                ASSERT_TRUE(cv::gmlpnp::solveRays(scene.objectPoints, scene.rays, result, paramsOf(method)));
                cv::Vec3d rvec[2], tvec[2];
                ASSERT_TRUE(cv::gmlpnp::solvePnP(scene.objectPoints, scene.imagePoints, paperCamera(), cv::noArray(),
                                                 rvec[0], tvec[0], false, method));
                ASSERT_TRUE(cv::gmlpnp::solvePnP(permuted(scene.objectPoints, order),
                                                 permuted(scene.imagePoints, order), paperCamera(), cv::noArray(),
                                                 rvec[1], tvec[1], false, method));
                square += mahalanobis2(poseOf(rvec[1], tvec[1]), poseOf(rvec[0], tvec[0]), result.poseCovariance) /
                          (6 * PROBLEMS);
            }
            std::cout << "method " << method << ", n " << n << ": " << std::sqrt(square) << std::endl;
            EXPECT_LT(std::sqrt(square), n < 200 ? 1e-6 : 1. / 3) << "method " << method << ", n " << n;
        }
}

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
            const double distance = std::sqrt(mahalanobis2(poseOfResult(b), poseOfResult(a), a.poseCovariance));
            EXPECT_LT(distance, 0.5) << "standard deviations, problem " << k;
        }
}

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
