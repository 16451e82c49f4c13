// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../expect_error.hpp"
#include "reference.hpp"

// The contract of a drop-in for cv::solvePnP: what is accepted and returned.

namespace opencv_test {
namespace {

constexpr int FLAGS[] = {cv::gmlpnp::SOLVEPNP_GMLPNP, cv::gmlpnp::SOLVEPNP_GMLPNP_MARGINAL};

void expectSame(const Reference& r, cv::InputArray objectPoints, cv::InputArray imagePoints)
{
    cv::Mat rvec, tvec;
    ASSERT_TRUE(cv::gmlpnp::solvePnP(objectPoints, imagePoints, r.K, cv::noArray(), rvec, tvec));
    ASSERT_EQ(CV_64F, rvec.type());
    ASSERT_EQ(cv::Size(1, 3), rvec.size());
    EXPECT_EQ(0, cv::norm(cv::Mat(r.rvec), rvec, cv::NORM_INF));
    EXPECT_EQ(0, cv::norm(cv::Mat(r.tvec), tvec, cv::NORM_INF));
}

TEST(Gmlpnp_SolvePnP, everyInputLayout)
{
    cv::RNG rng = testRng();
    const Reference r = reference(rng);
    const cv::Mat_<double>&P = r.scene.objectPoints, &U = r.scene.imagePoints;
    for (int depthP : {CV_32F, CV_64F})
        for (int depthU : {CV_32F, CV_64F}) {
            SCOPED_TRACE(testing::Message() << "depths " << depthP << ' ' << depthU);
            cv::Mat p, u;
            P.convertTo(p, depthP);
            U.convertTo(u, depthU);
            expectSame(r, p, u);                              // Nx3, Nx2
            expectSame(r, p.reshape(3), u.reshape(2));        // Nx1, channels
            expectSame(r, p.reshape(3, 1), u.reshape(2, 1));  // 1xN, channels
            expectSame(r, p.getUMat(cv::ACCESS_READ), u.getUMat(cv::ACCESS_READ));
            cv::Mat wideP(P.rows, 5, depthP), wideU(P.rows, 4, depthU);  // not continuous
            p.copyTo(wideP.colRange(1, 4));
            u.copyTo(wideU.colRange(2, 4));
            expectSame(r, wideP.colRange(1, 4), wideU.colRange(2, 4));
        }
    std::vector<cv::Point3f> p3f;
    std::vector<cv::Point3d> p3d;
    std::vector<cv::Vec3d> v3d;
    std::vector<cv::Point2f> p2f;
    std::vector<cv::Point2d> p2d;
    for (int i = 0; i < P.rows; ++i) {
        v3d.emplace_back(P(i, 0), P(i, 1), P(i, 2));
        p3d.emplace_back(v3d.back());
        p3f.emplace_back(p3d.back());
        p2d.emplace_back(U(i, 0), U(i, 1));
        p2f.emplace_back(p2d.back());
    }
    expectSame(r, p3f, p2f);
    expectSame(r, p3d, p2d);
    expectSame(r, v3d, p2f);
}

TEST(Gmlpnp_SolvePnP, cameraMatrixAndDistortionOfEveryDepth)
{
    cv::RNG rng = testRng();
    const Reference r = reference(rng);
    for (int depth : {CV_32F, CV_64F, CV_32S}) {
        cv::Mat K;
        r.K.convertTo(K, depth);
        for (int count : {0, 4, 5, 8, 12, 14}) {
            const cv::Mat D = cv::Mat::zeros(count, count ? 1 : 0, CV_32F);
            cv::Vec3d rvec, tvec;
            ASSERT_TRUE(cv::gmlpnp::solvePnP(r.scene.objectPoints, r.scene.imagePoints, K, D, rvec, tvec));
            EXPECT_LT(cv::norm(rvec - r.rvec) + cv::norm(tvec - r.tvec), 1e-9);
        }
    }
}

// Exact data through strong distortion: undistorted to convergence.
TEST(Gmlpnp_SolvePnP, exactWithDistortion)
{
    cv::RNG rng = testRng();
    const cv::Vec<double, 5> D(-0.28, 0.09, 1e-3, -5e-4, -0.012);
    for (int flag : FLAGS) {
        const Scene scene = exactScene(rng, boxPoints(rng, 20));
        const Vector3d w = cv::gmlpnp::detail::logSO3(scene.truth.R), t = scene.truth.t;
        cv::Mat pixels;
        cv::projectPoints(scene.objectPoints, cv::Vec3d(w.x(), w.y(), w.z()), cv::Vec3d(t.x(), t.y(), t.z()),
                          paperCamera(), D, pixels);
        cv::Vec3d rvec, tvec;
        ASSERT_TRUE(cv::gmlpnp::solvePnP(scene.objectPoints, pixels, paperCamera(), D, rvec, tvec, false, flag));
        EXPECT_TRUE(poseNear(poseOf(rvec, tvec), scene.truth, 1e-9, 1e-8));
    }
}

TEST(Gmlpnp_SolvePnP, outputsKeepTheDepthOfWhatWasPassed)
{
    cv::RNG rng = testRng();
    const Reference r = reference(rng);
    const auto solve = [&](cv::OutputArray rvec, cv::OutputArray tvec) {
        return cv::gmlpnp::solvePnP(r.scene.objectPoints, r.scene.imagePoints, r.K, cv::noArray(), rvec, tvec);
    };
    cv::Vec3d rd, td;
    cv::Vec3f rf, tf;
    cv::Matx31d rx, tx;
    cv::Mat_<float> rm, tm;
    cv::Mat rowR(1, 3, CV_32F), rowT(1, 3, CV_64F);
    std::vector<double> rv(3), tv(3);
    ASSERT_TRUE(solve(rd, td));
    ASSERT_TRUE(solve(rf, tf));
    ASSERT_TRUE(solve(rx, tx));
    ASSERT_TRUE(solve(rm, tm));
    ASSERT_TRUE(solve(rowR, rowT));
    ASSERT_TRUE(solve(rv, tv));
    EXPECT_EQ(r.rvec, rd);
    EXPECT_LT(cv::norm(cv::Vec3d(rf) - r.rvec), 1e-6);
    EXPECT_LT(cv::norm(cv::Vec3d(tf) - r.tvec), 1e-5);
    EXPECT_EQ(0, cv::norm(cv::Mat(rx), cv::Mat(r.rvec)));
    EXPECT_EQ(cv::Size(1, 3), rm.size());
    EXPECT_EQ(CV_32F, rowR.type());
    EXPECT_EQ(CV_64F, rowT.type());
    EXPECT_EQ(cv::Size(1, 3), rowR.size());
    EXPECT_EQ(r.tvec[2], tv[2]);
}

TEST(Gmlpnp_SolvePnP, whatAFloatCannotHoldIsWrittenAsDoubleOrRefused)
{
    cv::RNG rng = testRng();
    const Reference r = reference(rng);
    const cv::Mat points = 1e40 * r.scene.objectPoints;
    const auto solve = [&](cv::OutputArray rvec, cv::OutputArray tvec) {
        return cv::gmlpnp::solvePnP(points, r.scene.imagePoints, r.K, cv::noArray(), rvec, tvec);
    };
    cv::Mat rvec(3, 1, CV_32F), tvec(3, 1, CV_32F);
    ASSERT_TRUE(solve(rvec, tvec));
    EXPECT_EQ(CV_32F, rvec.type());
    EXPECT_EQ(CV_64F, tvec.type());
    EXPECT_LT(cv::norm(1e-40 * tvec, cv::Mat(r.tvec)), 1e-9);
    const cv::Vec3f before(7, 7, 7);
    cv::Vec3f rf = before, tf = before;
    expectError(cv::Error::StsOutOfRange, "tvec", [&] { solve(rf, tf); });
    EXPECT_EQ(before, rf);
    EXPECT_EQ(before, tf);
    std::vector<cv::Vec3f> rvecs(1, before), tvecs(1, before);
    expectError(cv::Error::StsOutOfRange, "tvecs",
                [&] { cv::gmlpnp::solvePnPGeneric(points, r.scene.imagePoints, r.K, cv::noArray(), rvecs, tvecs); });
    EXPECT_EQ(before, tvecs[0]);
}

TEST(Gmlpnp_SolvePnP, guessOfAnyShapeIsHonouredAndAWrongOneRefused)
{
    cv::RNG rng = testRng();
    const Reference r = reference(rng, 30);
    for (int flag : FLAGS) {
        cv::Vec3d start, startT;
        ASSERT_TRUE(cv::gmlpnp::solvePnP(r.scene.objectPoints, r.scene.imagePoints, r.K, cv::noArray(), start, startT,
                                         false, flag));
        cv::Mat rvec = (cv::Mat_<float>(1, 3) << start[0] + 0.05, start[1], start[2]);
        cv::Mat tvec = (cv::Mat_<double>(3, 1) << startT[0], startT[1] + 0.2, startT[2]);
        ASSERT_TRUE(cv::gmlpnp::solvePnP(r.scene.objectPoints, r.scene.imagePoints, r.K, cv::noArray(), rvec, tvec,
                                         true, flag));
        EXPECT_EQ(CV_32F, rvec.type());
        cv::Mat_<double> found(rvec);
        EXPECT_TRUE(
            poseNear(poseOf({found(0), found(1), found(2)}, cv::Vec3d(tvec)), poseOf(start, startT), 5e-3, 5e-2));
    }
    cv::Mat none, four = cv::Mat::zeros(4, 1, CV_64F), ints = cv::Mat::zeros(3, 1, CV_32S);
    cv::Vec3d ok(0, 0, 0), tvec(0, 0, 6);
    for (cv::Mat* wrong : {&none, &four, &ints})
        expectError(cv::Error::StsAssert, "rvec", [&] {
            cv::gmlpnp::solvePnP(r.scene.objectPoints, r.scene.imagePoints, r.K, cv::noArray(), *wrong, tvec, true);
        });
    ok[1] = std::nan("");
    EXPECT_FALSE(cv::gmlpnp::solvePnP(r.scene.objectPoints, r.scene.imagePoints, r.K, cv::noArray(), ok, tvec, true));
}

TEST(Gmlpnp_SolvePnP, opencvFlagsAreForwarded)
{
    cv::RNG rng = testRng();
    const Reference r = reference(rng, 30);
    for (int flag : {cv::gmlpnp::SOLVEPNP_ITERATIVE, cv::gmlpnp::SOLVEPNP_EPNP, cv::gmlpnp::SOLVEPNP_SQPNP}) {
        cv::Vec3d rvec, tvec, theirR, theirT;
        ASSERT_TRUE(
            cv::solvePnP(r.scene.objectPoints, r.scene.imagePoints, r.K, cv::noArray(), theirR, theirT, false, flag));
        ASSERT_TRUE(cv::gmlpnp::solvePnP(r.scene.objectPoints, r.scene.imagePoints, r.K, cv::noArray(), rvec, tvec,
                                         false, flag));
        EXPECT_EQ(theirR, rvec);
        EXPECT_EQ(theirT, tvec);
    }
    cv::Vec3d rvec, tvec;
    for (int flag : {-1, 9, 32, 99, 102, 1 << 20}) {
        SCOPED_TRACE(flag);
        expectError(cv::Error::StsBadArg, "flags", [&] {
            cv::gmlpnp::solvePnP(r.scene.objectPoints, r.scene.imagePoints, r.K, cv::noArray(), rvec, tvec, false,
                                 flag);
        });
    }
}

}  // namespace
}  // namespace opencv_test
