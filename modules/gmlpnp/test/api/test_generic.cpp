// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../scenes.hpp"

// solvePnPGeneric, solveAll and the refinements: every distinct pose, a given pose never made worse.

namespace opencv_test {
namespace {

const std::vector<cv::Point3d> SQUARE = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};

// A small tilted square far away: two poses explain its pixels nearly as well.
std::vector<cv::Point2d> squarePixels(const cv::Vec3d& rvec, const cv::Vec3d& tvec)
{
    std::vector<cv::Point2d> pixels;
    cv::projectPoints(SQUARE, rvec, tvec, paperCamera(), cv::noArray(), pixels);
    return pixels;
}

TEST(Gmlpnp_Generic, bothPosesOfAPlanarAmbiguity)
{
    const cv::Vec3d rvec(0.5, 0.1, 0), tvec(0.3, -0.2, 40);
    const std::vector<cv::Point2d> pixels = squarePixels(rvec, tvec);
    for (int flag : {cv::gmlpnp::SOLVEPNP_GMLPNP, cv::gmlpnp::SOLVEPNP_GMLPNP_MARGINAL}) {
        std::vector<cv::Mat> rvecs, tvecs;
        cv::Mat errors;
        const int count = cv::gmlpnp::solvePnPGeneric(SQUARE, pixels, paperCamera(), cv::noArray(), rvecs, tvecs, false,
                                                      flag, cv::noArray(), cv::noArray(), errors);
        ASSERT_EQ(2, count);
        ASSERT_EQ(2u, rvecs.size());
        EXPECT_EQ(CV_64F, rvecs[0].type());
        EXPECT_EQ(cv::Size(1, 3), rvecs[0].size());
        EXPECT_TRUE(poseNear(poseOf(cv::Vec3d(rvecs[0]), cv::Vec3d(tvecs[0])), poseOf(rvec, tvec), 1e-7, 1e-6));
        EXPECT_GT(rotationAngle(poseOf(cv::Vec3d(rvecs[1]), {}).R, poseOf(rvec, {}).R), 0.5);
        ASSERT_EQ(cv::Size(1, 2), errors.size());
        EXPECT_LT(errors.at<double>(0), 1e-6);
        // sqrt(sum e^2 / 2N), as OpenCV computes it.
        std::vector<cv::Point2d> projected;
        cv::projectPoints(SQUARE, rvecs[1], tvecs[1], paperCamera(), cv::noArray(), projected);
        EXPECT_NEAR(cv::norm(projected, pixels) / std::sqrt(8.), errors.at<double>(1), 1e-9);
        EXPECT_LT(errors.at<double>(1), 1);
    }
}

TEST(Gmlpnp_Generic, outputTypes)
{
    cv::RNG rng = testRng();
    const Scene scene = paperScene(rng, 20, 0.1, 1);
    cv::Vec3d rvec, tvec;
    ASSERT_TRUE(cv::gmlpnp::solvePnP(scene.objectPoints, scene.imagePoints, paperCamera(), cv::noArray(), rvec, tvec));
    const auto solve = [&](cv::OutputArrayOfArrays rvecs, cv::OutputArrayOfArrays tvecs) {
        return cv::gmlpnp::solvePnPGeneric(scene.objectPoints, scene.imagePoints, paperCamera(), cv::noArray(), rvecs,
                                           tvecs);
    };
    std::vector<cv::Mat> rm, tm;
    std::vector<cv::Vec3d> rd, td;
    std::vector<cv::Vec3f> rf, tf;
    std::vector<cv::Point3d> rp, tp;
    EXPECT_GE(solve(rm, tm), 1);
    EXPECT_GE(solve(rd, td), 1);
    EXPECT_GE(solve(rf, tf), 1);
    EXPECT_GE(solve(rp, tp), 1);
    EXPECT_LT(cv::norm(cv::Vec3d(rm.at(0)) - rvec), 1e-12);
    EXPECT_LT(cv::norm(rd.at(0) - rvec), 1e-12);
    EXPECT_LT(cv::norm(cv::Vec3d(tf.at(0)) - tvec), 1e-5);
    EXPECT_LT(cv::norm(cv::Vec3d(tp.at(0)) - tvec), 1e-12);
}

TEST(Gmlpnp_Generic, cameraMatrixOfEveryDepth)
{
    const std::vector<cv::Point2d> pixels = squarePixels({0.5, 0.1, 0}, {0.3, -0.2, 10});
    for (int depth : {CV_8U, CV_16S, CV_32S, CV_32F, CV_64F}) {
        cv::Mat K = (cv::Mat_<double>(3, 3) << 200, 0, 100, 0, 200, 100, 0, 0, 1), errors;
        K.convertTo(K, depth);
        std::vector<cv::Vec3d> rvecs, tvecs;
        EXPECT_GE(
            cv::gmlpnp::solvePnPGeneric(SQUARE, pixels, K, cv::noArray(), rvecs, tvecs, false,
                                        cv::gmlpnp::SOLVEPNP_GMLPNP_MARGINAL, cv::noArray(), cv::noArray(), errors),
            1);
        EXPECT_TRUE(cv::checkRange(errors));
    }
}

TEST(Gmlpnp_Generic, guessLeadsToOnePoseAndIsNotWritten)
{
    const cv::Vec3d rvec(0.5, 0.1, 0), tvec(0.3, -0.2, 40);
    const std::vector<cv::Point2d> pixels = squarePixels(rvec, tvec);
    const cv::Vec3d guess(-0.5, -0.1, 0);
    cv::Mat r(guess, true), t(tvec, true);
    std::vector<cv::Vec3d> rvecs, tvecs;
    ASSERT_EQ(1, cv::gmlpnp::solvePnPGeneric(SQUARE, pixels, paperCamera(), cv::noArray(), rvecs, tvecs, true,
                                             cv::gmlpnp::SOLVEPNP_GMLPNP_MARGINAL, r, t));
    EXPECT_EQ(guess, cv::Vec3d(r));
    EXPECT_EQ(tvec, cv::Vec3d(t));
    EXPECT_TRUE(poseNear(poseOf(rvecs[0], tvecs[0]), poseOf(guess, tvec), 0.3, 1));
}

TEST(Gmlpnp_Generic, badDataIsZeroAndTouchesNothing)
{
    cv::Mat_<double> line(8, 3), pixels(8, 2);
    for (int i = 0; i < 8; ++i) {
        line(i, 0) = i, line(i, 1) = 2 * i, line(i, 2) = 1;
        pixels(i, 0) = 10 * i, pixels(i, 1) = 5 * i;
    }
    std::vector<cv::Vec3d> rvecs = {{1, 2, 3}}, tvecs = {{4, 5, 6}};
    EXPECT_EQ(0, cv::gmlpnp::solvePnPGeneric(line, pixels, paperCamera(), cv::noArray(), rvecs, tvecs));
    EXPECT_EQ(cv::Vec3d(1, 2, 3), rvecs.at(0));
    std::vector<cv::gmlpnp::Result> results(3);
    EXPECT_EQ(0, cv::gmlpnp::solveAll(line, pixels, paperCamera(), cv::noArray(), results));
    EXPECT_EQ(3u, results.size());
}

TEST(Gmlpnp_Generic, allPosesAscendInCostAndDiffer)
{
    cv::RNG rng = testRng();
    for (int k = 0; k < 50; ++k) {
        const Scene scene = paperScene(rng, 8, 0.3, 3);
        std::vector<cv::gmlpnp::Result> results;
        cv::gmlpnp::Result best;
        const int count =
            cv::gmlpnp::solveAll(scene.objectPoints, scene.imagePoints, paperCamera(), cv::noArray(), results);
        ASSERT_GE(count, 1);
        ASSERT_TRUE(cv::gmlpnp::solve(scene.objectPoints, scene.imagePoints, paperCamera(), cv::noArray(), best));
        EXPECT_LE(results[0].cost, best.cost);
        for (int i = 1; i < count; ++i) {
            EXPECT_LE(results[i - 1].cost, results[i].cost);
            EXPECT_GT(rotationAngle(poseOf(results[i].rvec, {}).R, poseOf(results[i - 1].rvec, {}).R) +
                          cv::norm(results[i].tvec - results[i - 1].tvec),
                      1e-6);
        }
    }
}

// L at a pose, with the noise held: what a refinement must not raise.
double costAt(const Scene& scene, const cv::Vec3d& rvec, const cv::Vec3d& tvec, const cv::gmlpnp::Result& noise)
{
    using namespace cv::gmlpnp::detail;
    const Correspondences data(scene.objectPoints, scene.rays);
    const double unit = 1 / (data.scale * data.scale);
    return rayPass(data, data.fromObject(poseOf(rvec, tvec)),
                   {unit * matrix3(noise.objectNoise), matrix3(noise.bearingNoise), {noise.tailShare}})
        .L;
}

TEST(Gmlpnp_Generic, aGuessIsNeverMadeWorse)
{
    cv::RNG rng = testRng();
    for (int k = 0; k < 200; ++k) {
        const Scene scene = paperScene(rng, 12, 0.2, 2);
        cv::gmlpnp::Params params;
        params.useExtrinsicGuess = true;
        const Vector3d w = cv::gmlpnp::detail::logSO3(scene.truth.R) + 0.02 * gaussian3(rng);
        const Vector3d t = scene.truth.t + 0.05 * gaussian3(rng);
        params.rvec = {w.x(), w.y(), w.z()};
        params.tvec = {t.x(), t.y(), t.z()};
        cv::gmlpnp::Result result;
        ASSERT_TRUE(cv::gmlpnp::solveRays(scene.objectPoints, scene.rays, result, params));
        EXPECT_LE(costAt(scene, result.rvec, result.tvec, result),
                  costAt(scene, params.rvec, params.tvec, result) + 1e-9);
    }
}

TEST(Gmlpnp_Generic, refineTakesAnyShape)
{
    cv::RNG rng = testRng();
    const Scene scene = paperScene(rng, 40, 0.1, 1);
    cv::Vec3d best, bestT;
    ASSERT_TRUE(cv::gmlpnp::solvePnP(scene.objectPoints, scene.imagePoints, paperCamera(), cv::noArray(), best, bestT));
    cv::Mat row = (cv::Mat_<double>(1, 3) << best[0] + 0.03, best[1], best[2] - 0.02);
    cv::Vec3f column(static_cast<float>(bestT[0]), static_cast<float>(bestT[1]) + 0.1f, static_cast<float>(bestT[2]));
    cv::gmlpnp::solvePnPRefine(scene.objectPoints, scene.imagePoints, paperCamera(), cv::noArray(), row, column);
    EXPECT_TRUE(poseNear(poseOf(cv::Vec3d(row.reshape(1, 3)), cv::Vec3d(column)), poseOf(best, bestT), 2e-3, 1e-2));
}

// One round over all points, however many there are: it is that of solve().
TEST(Gmlpnp_Generic, theCountOfARefinementBoundsTheRounds)
{
    cv::RNG rng = testRng();
    for (const int n : {400, 599, 600, 1000, 3000}) {
        const Scene scene = paperScene(rng, n, 0.3, 1);
        cv::gmlpnp::Params params;
        params.maxRounds = 1;
        params.useExtrinsicGuess = true;
        cv::Rodrigues(cv::Matx33d(scene.truth.R.data()).t(), params.rvec);
        params.tvec = cv::Vec3d(scene.truth.t.data()) + cv::Vec3d(0.2, -0.1, 0.3);
        cv::Vec3d rvec = params.rvec, tvec = params.tvec;
        cv::gmlpnp::solvePnPRefine(scene.objectPoints, scene.imagePoints, paperCamera(), cv::noArray(), rvec, tvec,
                                   cv::TermCriteria(cv::TermCriteria::COUNT, 1, 0));
        EXPECT_TRUE(poseNear(poseOf(rvec, tvec), poseOf(solvedPixels(scene, params)), 1e-12, 1e-11)) << n;
    }
}

TEST(Gmlpnp_Generic, opencvFlagsAndRefinementsAreForwarded)
{
    cv::RNG rng = testRng();
    const Scene scene = paperScene(rng, 30, 0.1, 1);
    std::vector<cv::Vec3d> rvecs, tvecs, theirR, theirT;
    cv::gmlpnp::solvePnPGeneric(scene.objectPoints, scene.imagePoints, paperCamera(), cv::noArray(), rvecs, tvecs,
                                false, cv::gmlpnp::SOLVEPNP_SQPNP);
    cv::solvePnPGeneric(scene.objectPoints, scene.imagePoints, paperCamera(), cv::noArray(), theirR, theirT, false,
                        cv::SOLVEPNP_SQPNP);
    ASSERT_EQ(theirR.size(), rvecs.size());
    EXPECT_EQ(theirR[0], rvecs[0]);
    for (bool lm : {true, false}) {
        cv::Vec3d r = rvecs[0], t = tvecs[0], r2 = r, t2 = t;
        const auto ours = [&](auto&&... a) {
            lm ? cv::gmlpnp::solvePnPRefineLM(a...) : cv::gmlpnp::solvePnPRefineVVS(a...);
        };
        const auto theirs = [&](auto&&... a) { lm ? cv::solvePnPRefineLM(a...) : cv::solvePnPRefineVVS(a...); };
        ours(scene.objectPoints, scene.imagePoints, paperCamera(), cv::noArray(), r, t);
        theirs(scene.objectPoints, scene.imagePoints, paperCamera(), cv::noArray(), r2, t2);
        EXPECT_EQ(r2, r);
        EXPECT_EQ(t2, t);
    }
}

}  // namespace
}  // namespace opencv_test
