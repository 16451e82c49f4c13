// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../camera/camera_util.hpp"
#include "../scenes.hpp"

#include <thread>

// The contract of a drop-in for cv::solvePnPRansac.

namespace opencv_test {
namespace {

using namespace camera;

constexpr int FLAGS[] = {gmlpnp::SOLVEPNP_GMLPNP, gmlpnp::SOLVEPNP_GMLPNP_MARGINAL};

// The paper's scene, a third of the correspondences wrong.
Scene spoiledScene(cv::RNG& rng, int n = 60, double px = 0.5)
{
    Scene scene = paperScene(rng, n, 0.001, px);
    for (int i = 0; i < n; i += 3) {
        scene.imagePoints(i, 0) = rng.uniform(0., 640.);
        scene.imagePoints(i, 1) = rng.uniform(0., 480.);
    }
    return scene;
}

template <class... More>
bool ransac(const Scene& scene, OutputArray rvec, OutputArray tvec, More&&... more)
{
    return gmlpnp::solvePnPRansac(scene.objectPoints, scene.imagePoints, paperCamera(), noArray(), rvec, tvec,
                                  std::forward<More>(more)...);
}

TEST(Gmlpnp_SolvePnPRansac, poseAndInliers)
{
    cv::RNG rng = testRng();
    for (const int flag : FLAGS) {
        const Scene scene = spoiledScene(rng);
        Mat rvec, tvec, inliers;
        ASSERT_TRUE(ransac(scene, rvec, tvec, false, 1000, 8.f, 0.99, inliers, flag));
        EXPECT_EQ(CV_64FC1, rvec.type());
        EXPECT_EQ(Size(1, 3), rvec.size());
        EXPECT_EQ(CV_64FC1, tvec.type());
        EXPECT_EQ(Size(1, 3), tvec.size());
        EXPECT_TRUE(poseNear(poseOf(Vec3d(rvec), Vec3d(tvec)), scene.truth, 0.005, 0.02));
        // Inliers are those of the pose that is returned, by OpenCV's own projection.
        EXPECT_EQ(CV_32SC1, inliers.type());
        EXPECT_EQ(1, inliers.cols);
        Mat projected;
        cv::projectPoints(scene.objectPoints, rvec, tvec, paperCamera(), noArray(), projected);
        projected = projected.reshape(1, scene.imagePoints.rows);
        std::vector<int> expected;
        for (int i = 0; i < projected.rows; ++i)
            if (cv::norm(projected.row(i), scene.imagePoints.row(i)) <= 8)
                expected.push_back(i);
        EXPECT_EQ(expected, std::vector<int>(inliers.begin<int>(), inliers.end<int>()));
        std::vector<int> list;
        ASSERT_TRUE(ransac(scene, rvec, tvec, false, 1000, 8.f, 0.99, list, flag));
        EXPECT_EQ(expected, list);
    }
}

TEST(Gmlpnp_SolvePnPRansac, failureLeavesTheOutputsAlone)
{
    cv::RNG rng = testRng();
    Scene scene = spoiledScene(rng, 12);
    for (int i = 0; i < 12; ++i)
        for (int k = 0; k < 2; ++k)
            scene.imagePoints(i, k) = rng.uniform(0., 480.);
    const Mat before = (Mat_<double>(3, 1) << 1, 2, 3);
    Mat rvec = before.clone(), tvec = before.clone(), inliers = Mat_<int>(2, 1, 7);
    EXPECT_FALSE(ransac(scene, rvec, tvec, false, 100, 2.f, 0.99, inliers));
    scene.imagePoints(3, 1) = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(ransac(scene, rvec, tvec, false, 100, 2.f, 0.99, inliers));
    EXPECT_EQ(0, cv::norm(rvec, before));
    EXPECT_EQ(0, cv::norm(tvec, before));
    EXPECT_EQ(0, cv::norm(inliers, Mat_<int>(2, 1, 7)));
}

template <class Vector>
void expectFilled(const Scene& scene, Vector rvec, Vector tvec)
{
    ASSERT_TRUE(ransac(scene, rvec, tvec));
    const Mat r(rvec), t(tvec);
    Mat r64, t64;
    r.reshape(1, 3).convertTo(r64, CV_64F);
    t.reshape(1, 3).convertTo(t64, CV_64F);
    EXPECT_TRUE(poseNear(poseOf(Vec3d(r64), Vec3d(t64)), scene.truth, 0.005, 0.02));
}

TEST(Gmlpnp_SolvePnPRansac, presetVectors)
{
    cv::RNG rng = testRng();
    const Scene scene = spoiledScene(rng);
    expectFilled(scene, Vec3d(), Vec3d());
    expectFilled(scene, Vec3f(), Vec3f());
    expectFilled(scene, Matx31f(), Matx31f());
    expectFilled(scene, Matx31d(), Matx31d());
    Mat_<float> rvec(3, 1), tvec(3, 1);
    ASSERT_TRUE(ransac(scene, rvec, tvec));
    EXPECT_TRUE(poseNear(poseOf(Vec3f(rvec), Vec3f(tvec)), scene.truth, 0.005, 0.02));
    UMat ur, ut;
    ASSERT_TRUE(ransac(scene, ur, ut));
    EXPECT_EQ(Size(1, 3), ur.size());
}

TEST(Gmlpnp_SolvePnPRansac, layouts)
{
    cv::RNG rng = testRng();
    const Scene scene = spoiledScene(rng);
    Vec3d rvec, tvec, r, t;
    ASSERT_TRUE(ransac(scene, rvec, tvec));
    const std::vector<Point3d> points = Mat_<Point3d>(scene.objectPoints.reshape(3));
    const std::vector<Point2d> pixels = Mat_<Point2d>(scene.imagePoints.reshape(2));
    ASSERT_TRUE(gmlpnp::solvePnPRansac(points, pixels, paperCamera(), noArray(), r, t));
    EXPECT_EQ(tvec, t);
    Mat wide(scene.objectPoints.rows, 5, CV_64F);
    Mat middle = wide.colRange(1, 4);
    scene.objectPoints.copyTo(middle);
    ASSERT_TRUE(gmlpnp::solvePnPRansac(middle, Mat(pixels).reshape(2, 1), paperCamera(), noArray(), r, t));
    EXPECT_EQ(tvec, t);
}

TEST(Gmlpnp_SolvePnPRansac, bitIdenticalAlsoAcrossThreads)
{
    cv::RNG rng = testRng();
    const Scene scene = spoiledScene(rng, 300);
    Vec3d rvec, tvec;
    std::vector<int> inliers;
    ASSERT_TRUE(ransac(scene, rvec, tvec, false, 1000, 8.f, 0.99, inliers));
    constexpr int THREADS = 4;
    Vec3d rvecs[THREADS], tvecs[THREADS];
    std::vector<int> lists[THREADS];
    std::vector<std::thread> threads;
    cv::theRNG().state = 12345;  // global states are not ours
    for (int k = 0; k < THREADS; ++k)
        threads.emplace_back([&, k] {
            for (int repeat = 0; repeat < 3; ++repeat)
                ransac(scene, rvecs[k], tvecs[k], false, 1000, 8.f, 0.99, lists[k]);
        });
    for (std::thread& thread : threads)
        thread.join();
    EXPECT_EQ(12345u, cv::theRNG().state);
    for (int k = 0; k < THREADS; ++k) {
        EXPECT_EQ(rvec, rvecs[k]);
        EXPECT_EQ(tvec, tvecs[k]);
        EXPECT_EQ(inliers, lists[k]);
    }
}

TEST(Gmlpnp_SolvePnPRansac, flagsOfOpenCVAreForwarded)
{
    cv::RNG rng = testRng();
    const Scene scene = spoiledScene(rng);
    for (const int flag : {int(cv::SOLVEPNP_EPNP), int(cv::SOLVEPNP_SQPNP), int(cv::USAC_DEFAULT),
                           int(cv::USAC_ACCURATE), int(cv::USAC_MAGSAC)}) {
        Mat rvec, tvec, inliers, r, t, list;
        ASSERT_TRUE(ransac(scene, rvec, tvec, false, 200, 8.f, 0.99, inliers, flag)) << "flag " << flag;
        ASSERT_TRUE(cv::solvePnPRansac(scene.objectPoints, scene.imagePoints, paperCamera(), noArray(), r, t, false,
                                       200, 8.f, 0.99, list, flag));
        EXPECT_EQ(0, cv::norm(rvec, r)) << "flag " << flag;
        EXPECT_EQ(0, cv::norm(tvec, t)) << "flag " << flag;
        EXPECT_EQ(0, cv::norm(inliers, list)) << "flag " << flag;
    }
}

TEST(Gmlpnp_SolvePnPRansac, usacParams)
{
    cv::RNG rng = testRng();
    const Scene scene = spoiledScene(rng);
    gmlpnp::UsacParams usac;
    usac.threshold = 6;
    usac.maxIterations = 2000;
    usac.randomGeneratorState = 5;
    Matx33d K = paperCamera();
    Mat rvec, tvec, inliers;
    ASSERT_TRUE(gmlpnp::solvePnPRansac(scene.objectPoints, scene.imagePoints, K, noArray(), rvec, tvec, inliers, usac));
    EXPECT_EQ(paperCamera(), K);
    // It is solveRansac() with the same threshold, seed and order.
    for (const bool ordered : {false, true}) {
        usac.sampler = ordered ? SAMPLING_PROSAC : SAMPLING_UNIFORM;
        ASSERT_TRUE(
            gmlpnp::solvePnPRansac(scene.objectPoints, scene.imagePoints, K, noArray(), rvec, tvec, inliers, usac));
        gmlpnp::RansacParams ransacParams;
        ransacParams.threshold = 6;
        ransacParams.maxIterations = 2000;
        ransacParams.seed = 5;
        ransacParams.ordered = ordered;
        gmlpnp::Result result;
        Mat list;
        ASSERT_TRUE(solveRansac(scene.objectPoints, scene.imagePoints, K, noArray(), result, list, ransacParams));
        EXPECT_EQ(result.tvec, Vec3d(tvec));
        EXPECT_EQ(0, cv::norm(inliers, list));
    }
    EXPECT_THROW(
        gmlpnp::solvePnPRansac(scene.objectPoints, scene.imagePoints, Mat(), noArray(), rvec, tvec, inliers, usac),
        cv::Exception);
}

TEST(Gmlpnp_SolvePnPRansac, misuseIsNamed)
{
    cv::RNG rng = testRng();
    const Scene scene = spoiledScene(rng);
    Mat rvec, tvec, inliers;
    const float nan = std::numeric_limits<float>::quiet_NaN();
    expectError(Error::StsBadArg, "iterationsCount", [&] { ransac(scene, rvec, tvec, false, 0); });
    expectError(Error::StsBadArg, "reprojectionError", [&] { ransac(scene, rvec, tvec, false, 100, 0.f); });
    expectError(Error::StsBadArg, "reprojectionError", [&] { ransac(scene, rvec, tvec, false, 100, nan); });
    expectError(Error::StsBadArg, "confidence", [&] { ransac(scene, rvec, tvec, false, 100, 8.f, 1.); });
    expectError(Error::StsBadArg, "flags", [&] { ransac(scene, rvec, tvec, false, 100, 8.f, 0.99, inliers, 99); });
    expectError(Error::StsAssert, "rvec", [&] { ransac(scene, Mat(), Mat(), true); });
    expectError(Error::StsAssert, "objectPoints", [&] {
        gmlpnp::solvePnPRansac(scene.objectPoints.rowRange(0, 3), scene.imagePoints.rowRange(0, 3), paperCamera(),
                               noArray(), rvec, tvec);
    });
    expectError(Error::StsAssert, "imagePoints",
                [&] { gmlpnp::solvePnPRansac(scene.objectPoints, scene.rays, paperCamera(), noArray(), rvec, tvec); });
    gmlpnp::RansacParams angle;
    angle.threshold = 2;
    gmlpnp::Result result;
    expectError(Error::StsBadArg, "threshold",
                [&] { solveRaysRansac(scene.objectPoints, scene.rays, result, inliers, angle); });
    angle.threshold = -1;
    expectError(Error::StsBadArg, "threshold", [&] {
        solveRansac(scene.objectPoints, scene.imagePoints, paperCamera(), noArray(), result, inliers, angle);
    });
}

}  // namespace
}  // namespace opencv_test
