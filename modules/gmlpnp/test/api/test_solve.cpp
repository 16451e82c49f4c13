// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include <thread>

#include "../expect_error.hpp"
#include "../scenes.hpp"

namespace opencv_test {
namespace {

using cv::gmlpnp::CameraModel;
using cv::gmlpnp::Params;
using cv::gmlpnp::Result;

cv::Mat_<double> affine(const cv::Mat_<double>& m, double scale, double offset = 0)
{
    cv::Mat_<double> out;
    m.convertTo(out, CV_64F, scale, offset);
    return out;
}

cv::Mat_<double> rotated(const Matrix3d& R, const cv::Mat_<double>& rows)
{
    cv::Mat_<double> out(rows.size());
    for (int i = 0; i < rows.rows; ++i) {
        const Vector3d v = R * Vector3d(rows(i, 0), rows(i, 1), rows(i, 2));
        for (int k = 0; k < 3; ++k)
            out(i, k) = v(k);
    }
    return out;
}

Result solved(const cv::Mat_<double>& points, const cv::Mat_<double>& rays, const Params& params)
{
    Result result;
    EXPECT_TRUE(cv::gmlpnp::solveRays(points, rays, result, params));
    return result;
}

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
                const Result result = solved(scene.objectPoints, scene.rays, paramsOf(method));
                EXPECT_TRUE(poseNear(result, scene.truth, 0.1, 0.6));
                expectComplete(result, n);
            }
}

// UTM: what the offset costs is the rounding of the coordinates themselves.
TEST(Gmlpnp_Solve, largeOffsetsDoNotMatter)
{
    cv::RNG rng = testRng();
    const Vector3d offset(292742.252, 2731078.97, 186.663);
    for (int method : METHODS) {
        const Scene scene = paperScene(rng, 60, 0.1, 1);
        cv::Mat_<double> far = scene.objectPoints.clone();
        for (int i = 0; i < far.rows; ++i)
            for (int k = 0; k < 3; ++k)
                far(i, k) += offset(k);
        const Result near = solved(scene.objectPoints, scene.rays, paramsOf(method));
        const Result utm = solved(far, scene.rays, paramsOf(method));
        const Pose nearPose = poseOf(near.rvec, near.tvec), utmPose = poseOf(utm.rvec, utm.tvec);
        EXPECT_LT(rotationAngle(nearPose.R, utmPose.R), 1e-8);
        const cv::Vec3d centre = near.cameraCenter + cv::Vec3d(offset.x(), offset.y(), offset.z());
        EXPECT_LT(cv::norm(utm.cameraCenter - centre), 1e-7);
        EXPECT_LT(cv::norm(near.cameraCenterCovariance, utm.cameraCenterCovariance),
                  1e-5 * cv::norm(near.cameraCenterCovariance));
        EXPECT_LT(cv::norm(near.objectNoise, utm.objectNoise), 1e-5 * cv::norm(near.objectNoise));
    }
}

// estimator.md: moving the object by a rigid G moves the pose by G^-1 and Sigma to R_G Sigma R_G^T.
TEST(Gmlpnp_Solve, equivariantUnderMotionOfTheObject)
{
    cv::RNG rng = testRng();
    for (int method : METHODS) {
        const Scene scene = paperScene(rng, 40, 0.1, 1);
        const Matrix3d G = randomRotation(rng);
        const Result a = solved(scene.objectPoints, scene.rays, paramsOf(method));
        const Result b = solved(affine(rotated(G, scene.objectPoints), 1, 5), scene.rays, paramsOf(method));
        const Pose pose = poseOf(a.rvec, a.tvec);
        const Matrix3d R = pose.R * G.transpose();
        EXPECT_TRUE(poseNear(b, {R, pose.t - R * Vector3d::Constant(5)}, 1e-8, 1e-7));
        EXPECT_TRUE(matrixNear(matrix3(b.objectNoise), G * matrix3(a.objectNoise) * G.transpose(), 1e-7));
        EXPECT_NEAR(a.cost, b.cost, 1e-6);
    }
}

// Scaling the scene leaves R, scales t and Sigma and shifts L by 2 n log k.
TEST(Gmlpnp_Solve, equivariantUnderScale)
{
    cv::RNG rng = testRng();
    for (int method : METHODS)
        for (double k : {1e-6, 1e3, 1e9}) {
            const Scene scene = paperScene(rng, 40, 0.1, 1);
            const Result a = solved(scene.objectPoints, scene.rays, paramsOf(method));
            const Result b = solved(affine(scene.objectPoints, k), scene.rays, paramsOf(method));
            const Pose pose = poseOf(a.rvec, a.tvec);
            EXPECT_TRUE(poseNear(b, {pose.R, k * pose.t}, 1e-9, 1e-8 * k));
            EXPECT_LT(cv::norm(b.objectNoise, k * k * a.objectNoise), 1e-7 * k * k);
            EXPECT_LT(cv::norm(b.bearingNoise, a.bearingNoise), 1e-9);
            EXPECT_NEAR(b.cost, a.cost + 2 * 40 * std::log(k), 1e-6);
            EXPECT_LT(cv::norm(b.cameraCenterCovariance, k * k * a.cameraCenterCovariance), 1e-7 * k * k);
        }
}

// Rotating the camera frame rotates R, t and Gamma.
TEST(Gmlpnp_Solve, equivariantUnderRotationOfTheCamera)
{
    cv::RNG rng = testRng();
    for (int method : METHODS) {
        const Scene scene = paperScene(rng, 40, 0.02, 3);
        const Matrix3d C = randomRotation(rng);
        const Result a = solved(scene.objectPoints, scene.rays, paramsOf(method));
        const Result b = solved(scene.objectPoints, rotated(C, scene.rays), paramsOf(method));
        const Pose pose = poseOf(a.rvec, a.tvec);
        EXPECT_TRUE(poseNear(b, {C * pose.R, C * pose.t}, 1e-8, 1e-7));
        EXPECT_TRUE(matrixNear(matrix3(b.bearingNoise), C * matrix3(a.bearingNoise) * C.transpose(), 1e-9));
        EXPECT_NEAR(a.cost, b.cost, 1e-6);
    }
}

TEST(Gmlpnp_Solve, pixelsOfAPinholeAreRays)
{
    cv::RNG rng = testRng();
    for (int method : METHODS) {
        const Scene scene = paperScene(rng, 30, 0.1, 1);
        const Result a = solved(scene.objectPoints, scene.rays, paramsOf(method));
        Result plain, b, c;
        const cv::Ptr<CameraModel> pinhole = CameraModel::pinhole(paperCamera());
        ASSERT_TRUE(cv::gmlpnp::solve(scene.objectPoints, scene.imagePoints, cv::makePtr<PlainLens>(pinhole), plain,
                                      paramsOf(method)));
        EXPECT_TRUE(poseNear(plain, poseOf(a.rvec, a.tvec), 1e-9, 1e-9));
        ASSERT_TRUE(cv::gmlpnp::solve(scene.objectPoints, scene.imagePoints, paperCamera(), cv::noArray(), b,
                                      paramsOf(method)));
        ASSERT_TRUE(cv::gmlpnp::solve(scene.objectPoints, scene.imagePoints, pinhole, c, paramsOf(method)));
        EXPECT_EQ(b.rvec, c.rvec);
        EXPECT_EQ(b.tvec, c.tvec);
    }
}

TEST(Gmlpnp_Solve, guessIsHonoured)
{
    cv::RNG rng = testRng();
    for (int method : METHODS) {
        const Scene scene = paperScene(rng, 30, 0.05, 1);
        const Result free = solved(scene.objectPoints, scene.rays, paramsOf(method));
        Params params = paramsOf(method);
        params.useExtrinsicGuess = true;
        params.rvec = free.rvec + cv::Vec3d(0.1, -0.1, 0.05);
        params.tvec = free.tvec + cv::Vec3d(0.3, 0.2, -0.4);
        const Result guided = solved(scene.objectPoints, scene.rays, params);
        EXPECT_TRUE(poseNear(guided, poseOf(free.rvec, free.tvec), 2e-3, 1e-2));
    }
    // Another minimum: the mirrored pose of a small flat object, kept only because the guess lies there.
    const cv::Matx33d K = paperCamera();
    const std::vector<cv::Point3d> square = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    std::vector<cv::Point2d> pixels;
    const cv::Vec3d rvec(0.5, 0.1, 0), tvec(0, 0, 40);
    cv::projectPoints(square, rvec, tvec, K, cv::noArray(), pixels);
    Params params;
    params.useExtrinsicGuess = true;
    params.rvec = cv::Vec3d(-0.5, -0.1, 0);
    params.tvec = tvec;
    Result mirrored;
    ASSERT_TRUE(cv::gmlpnp::solve(square, pixels, K, cv::noArray(), mirrored, params));
    EXPECT_TRUE(poseNear(mirrored, poseOf(params.rvec, tvec), 0.2, 1));
    Result best;
    ASSERT_TRUE(cv::gmlpnp::solve(square, pixels, K, cv::noArray(), best));
    EXPECT_TRUE(poseNear(best, poseOf(rvec, tvec), 1e-7, 1e-6));
}

TEST(Gmlpnp_Solve, threePointsWithAGuess)
{
    cv::RNG rng = testRng();
    const Scene scene = exactScene(rng, boxPoints(rng, 3));
    Params params;
    params.useExtrinsicGuess = true;
    const Vector3d rvec = cv::gmlpnp::detail::logSO3(scene.truth.R);
    params.rvec = cv::Vec3d(rvec.x() + 0.02, rvec.y(), rvec.z());
    params.tvec = cv::Vec3d(scene.truth.t.x(), scene.truth.t.y(), scene.truth.t.z() + 0.05);
    const Result result = solved(scene.objectPoints, scene.rays, params);
    EXPECT_TRUE(poseNear(result, scene.truth, 1e-8, 1e-7));
    EXPECT_TRUE(result.poseCovariance.empty());
    Result without;
    EXPECT_FALSE(cv::gmlpnp::solveRays(scene.objectPoints, scene.rays, without));
    EXPECT_EQ(cv::gmlpnp::STATUS_TOO_FEW_POINTS, without.status);
}

TEST(Gmlpnp_Solve, knownNoiseIsReturnedAsGiven)
{
    cv::RNG rng = testRng();
    const Scene scene = paperScene(rng, 30, 0.1, 1);
    const cv::Mat_<double> Sigma = (cv::Mat_<double>(3, 3) << 0.02, 0.001, 0, 0.001, 0.01, 0, 0, 0, 0.005);
    const cv::Mat Gamma = cv::Mat::eye(3, 3, CV_64F) * 1e-6;
    for (int method : METHODS) {
        Params params = paramsOf(method);
        params.objectNoise = Sigma;
        params.bearingNoise = Gamma;
        const Result result = solved(scene.objectPoints, scene.rays, params);
        EXPECT_LT(cv::norm(result.objectNoise, Sigma), 1e-12);
        EXPECT_LT(cv::norm(result.bearingNoise, Gamma), 1e-18);
        EXPECT_EQ(cv::gmlpnp::STATUS_CONVERGED, result.status);
        // Twice the noise, the same pose, four times the covariance.
        params.objectNoise = Sigma * 4;
        params.bearingNoise = Gamma * 4;
        const Result doubled = solved(scene.objectPoints, scene.rays, params);
        EXPECT_TRUE(poseNear(doubled, poseOf(result.rvec, result.tvec), 1e-6, 1e-6));
        EXPECT_LT(cv::norm(doubled.poseCovariance, 4 * result.poseCovariance), 1e-4 * cv::norm(doubled.poseCovariance));
    }
}

// The marginal method estimates what is not given.
TEST(Gmlpnp_Solve, theOtherNoiseIsEstimated)
{
    cv::RNG rng = testRng();
    const Scene scene = paperScene(rng, 200, 0, 2);
    Params params;
    params.objectNoise = cv::Mat::zeros(3, 3, CV_64F);
    const Result result = solved(scene.objectPoints, scene.rays, params);
    EXPECT_LT(cv::norm(result.objectNoise), 1e-18);
    const double sigma = std::sqrt(result.bearingNoise.at<double>(0, 0)) * 800;
    EXPECT_GT(sigma, 0.2);
    EXPECT_LT(sigma, 3);
}

TEST(Gmlpnp_Solve, publishedRankIsReported)
{
    cv::RNG rng = testRng();
    const Scene scene = paperScene(rng, 50, 0.1, 1);
    EXPECT_EQ(2, solved(scene.objectPoints, scene.rays, paramsOf(cv::gmlpnp::SOLVEPNP_GMLPNP)).objectNoiseRank);
    EXPECT_EQ(3, solved(scene.objectPoints, scene.rays, Params()).objectNoiseRank);
}

TEST(Gmlpnp_Solve, badDataIsAStatusAndTouchesNothing)
{
    cv::RNG rng = testRng();
    const Scene scene = paperScene(rng, 10, 0.1, 1);
    const Result before = solved(scene.objectPoints, scene.rays, Params());
    cv::Mat_<double> nan = scene.objectPoints.clone(), line = scene.objectPoints.clone(), place(10, 3, 1.5),
                     zero = scene.rays.clone();
    nan(3, 1) = std::nan("");
    zero.row(4) = 0;
    cv::Mat_<double> huge = scene.objectPoints.clone(), tiny = huge.clone();
    huge *= 1e101;
    tiny *= 1e-101;
    for (int i = 0; i < 10; ++i)
        line(i, 0) = i, line(i, 1) = 2 * i, line(i, 2) = -i;
    cv::Mat_<double> threePlaces = scene.objectPoints.clone(), theirRays = scene.rays.clone();
    for (int i = 3; i < 10; ++i) {
        threePlaces.row(i % 3).copyTo(threePlaces.row(i));
        theirRays.row(i % 3).copyTo(theirRays.row(i));
    }
    const struct
    {
        cv::Mat_<double> points, rays;
        int status;
    } cases[] = {{nan, scene.rays, cv::gmlpnp::STATUS_NOT_FINITE},
                 {huge, scene.rays, cv::gmlpnp::STATUS_NOT_FINITE},
                 {scene.objectPoints, zero, cv::gmlpnp::STATUS_NOT_FINITE},
                 {line, scene.rays, cv::gmlpnp::STATUS_DEGENERATE},
                 {place, scene.rays, cv::gmlpnp::STATUS_DEGENERATE},
                 {tiny, scene.rays, cv::gmlpnp::STATUS_DEGENERATE},
                 {scene.objectPoints.rowRange(0, 3), scene.rays.rowRange(0, 3), cv::gmlpnp::STATUS_TOO_FEW_POINTS},
                 {threePlaces, theirRays, cv::gmlpnp::STATUS_TOO_FEW_POINTS}};
    for (int method : METHODS)
        for (const auto& bad : cases) {
            Result result = before;
            const cv::Mat points = bad.points.clone(), rays = bad.rays.clone();
            EXPECT_FALSE(cv::gmlpnp::solveRays(points, rays, result, paramsOf(method)));
            EXPECT_EQ(bad.status, result.status);
            EXPECT_EQ(before.rvec, result.rvec);
            EXPECT_EQ(before.tvec, result.tvec);
            EXPECT_EQ(before.cost, result.cost);
            EXPECT_EQ(before.poseCovariance.data, result.poseCovariance.data);
            EXPECT_EQ(0, std::memcmp(points.data, bad.points.data, points.total() * sizeof(double))) << "input written";
        }
}

TEST(Gmlpnp_Solve, guessesBeyondReasonAreNotFinite)
{
    cv::RNG rng = testRng();
    const Scene scene = paperScene(rng, 10, 0.1, 1);
    for (const double value : {std::nan(""), 1.01e100, -1e160}) {
        Params params;
        params.useExtrinsicGuess = true;
        (value < 0 ? params.rvec : params.tvec)[1] = value;
        Result result;
        EXPECT_FALSE(cv::gmlpnp::solveRays(scene.objectPoints, scene.rays, result, params));
        EXPECT_EQ(cv::gmlpnp::STATUS_NOT_FINITE, result.status);
    }
}

// One point is far more precise than the others: its residual at the isotropic pose is many of its standard deviations.
// The pose is the one that the truth as a guess leads to.
TEST(Gmlpnp_Solve, knownNoisesOfVeryDifferentSizes)
{
    cv::RNG rng = testRng();
    constexpr int N = 20;
    for (const double precise : {1e-2, 1e-4, 0.})  // of the others' standard deviation
        for (const bool pixels : {true, false})
            for (int k = 0; k < 20; ++k) {
                Scene scene = exactScene(rng, boxPoints(rng, N));
                const double sigma = pixels ? 5 : 0.3;
                Params params;
                params.objectNoise = params.bearingNoise = cv::Mat::zeros(3, 3, CV_64F);
                cv::Mat_<double> known(N, pixels ? 1 : 9, 0.);
                for (int i = 0; i < N; ++i) {
                    const double own = i == 7 ? precise * sigma : sigma;
                    cv::Mat_<double>& noisy = pixels ? scene.imagePoints : scene.objectPoints;
                    for (int axis = 0; axis < noisy.cols; ++axis)
                        noisy(i, axis) += own * rng.gaussian(1);
                    for (int entry = 0; entry < known.cols; entry += 4)
                        known(i, entry) = own * own;
                }
                (pixels ? params.pixelCovariances : params.objectCovariances) = known;
                SCOPED_TRACE(testing::Message() << precise << (pixels ? ", pixels " : ", points ") << k);
                Result result, fromTruth;
                ASSERT_TRUE(cv::gmlpnp::solve(scene.objectPoints, scene.imagePoints, paperCamera(), cv::noArray(),
                                              result, params));
                const Vector3d r = cv::gmlpnp::detail::logSO3(scene.truth.R), t = scene.truth.t;
                params.useExtrinsicGuess = true;
                params.rvec = {r.x(), r.y(), r.z()};
                params.tvec = {t.x(), t.y(), t.z()};
                ASSERT_TRUE(cv::gmlpnp::solve(scene.objectPoints, scene.imagePoints, paperCamera(), cv::noArray(),
                                              fromTruth, params));
                EXPECT_EQ(cv::gmlpnp::STATUS_CONVERGED, result.status);
                EXPECT_LT(result.cost, fromTruth.cost + 0.1);
            }
}

// What objectNoise may be, each point's covariance may be too: of rank one, or zero for some points.
TEST(Gmlpnp_Solve, singularCovariancesOfPointsAreNoReasonToRefuse)
{
    cv::RNG rng = testRng();
    constexpr int N = 20;
    for (const bool noisy : {false, true})
        for (const bool others : {false, true}) {  // whether the rest of the noise is estimated
            SCOPED_TRACE(testing::Message() << noisy << others);
            Scene scene = exactScene(rng, boxPoints(rng, N));
            Params params;
            if (!others)
                params.objectNoise = params.bearingNoise = cv::Mat::zeros(3, 3, CV_64F);
            params.objectCovariances = cv::Mat::zeros(N, 9, CV_64F);
            for (int i = 0; i < N; ++i) {
                params.objectCovariances.at<double>(i, 8) = 0.0025;
                scene.objectPoints(i, 2) += noisy ? rng.gaussian(0.05) : 0;
            }
            Result result;
            EXPECT_TRUE(cv::gmlpnp::solveRays(scene.objectPoints, scene.rays, result, params));
            EXPECT_TRUE(poseNear(result, scene.truth, noisy ? 0.05 : 1e-6, noisy ? 0.3 : 1e-5));
            params.objectCovariances = cv::Mat();
            params.pixelCovariances = cv::Mat(N, 1, CV_64F, cv::Scalar(0.25));
            params.pixelCovariances.at<double>(3) = 0;
            Scene seen = exactScene(rng, boxPoints(rng, N));
            for (int i = 0; i < N; ++i)
                seen.imagePoints(i, 0) += noisy && i != 3 ? rng.gaussian(0.5) : 0;
            EXPECT_TRUE(
                cv::gmlpnp::solve(seen.objectPoints, seen.imagePoints, paperCamera(), cv::noArray(), result, params));
            EXPECT_TRUE(poseNear(result, seen.truth, noisy ? 0.01 : 1e-6, noisy ? 0.05 : 1e-5));
        }
}

// Small and flat, thirty or sixty of its half sides away: the data hardly decide between two poses, and poseEvidence
// says how surely. If it is true, the other one is right in a share of  1 / (1 + e^evidence).
TEST(Gmlpnp_Solve, poseEvidenceTellsHowOftenTheOtherMinimumIsRight)
{
    cv::RNG rng = testRng();
    constexpr int PROBLEMS = 300;
    for (const int n : {4, 6, 12, 50})
        for (const bool known : {true, false}) {
            int wrong = 0;
            double expected = 0, variance = 0;
            for (int k = 0; k < PROBLEMS; ++k) {
                const Matrix3d R = randomRotation(rng);
                std::vector<Vector3d> points;
                for (int i = 0; i < n; ++i)
                    points.emplace_back(R * Vector3d(rng.uniform(-1., 1.), rng.uniform(-1., 1.), 0) +
                                        Vector3d(0, 0, n < 50 ? 30 : 60));
                Scene scene = exactScene(rng, points);
                for (double& coordinate : scene.imagePoints)
                    coordinate += rng.gaussian(0.5);
                Params params;
                if (known) {
                    params.objectNoise = cv::Mat::zeros(3, 3, CV_64F);
                    params.bearingNoise = cv::Mat::diag(cv::Mat(cv::Vec3d(1, 1, 0))) * (0.25 / 640000);
                }
                const auto camera = cv::gmlpnp::CameraModel::pinhole(paperCamera());
                Result result;
                std::vector<Result> all;
                if (!cv::gmlpnp::solve(scene.objectPoints, scene.imagePoints, camera, result, params))
                    continue;
                cv::gmlpnp::solveAll(scene.objectPoints, scene.imagePoints, camera, all, params);
                const auto error = [&](const Result& r) {
                    return rotationAngle(poseOf(r.rvec, r.tvec).R, scene.truth.R);
                };
                const bool isWrong = std::any_of(
                    all.begin(), all.end(), [&](const Result& other) { return error(other) < error(result) - 0.1; });
                wrong += isWrong;
                const double share = 1 / (1 + std::exp(result.poseEvidence));
                expected += share;
                variance += share * (1 - share);
            }
            const double deviation = std::sqrt(variance);
            std::cout << n << " points, noise " << (known ? "known" : "estimated") << ": " << wrong << " wrong, "
                      << expected << " +- " << deviation << " expected" << std::endl;
            // Six points have little left to tell their noise by, and its shape is fitted to that.
            EXPECT_NEAR(expected, wrong, 4 * deviation + (known ? 0 : 0.1 * wrong));
        }
}

TEST(Gmlpnp_Solve, misuseThrowsAndNamesTheArgument)
{
    cv::RNG rng = testRng();
    const Scene scene = paperScene(rng, 10, 0.1, 1);
    const auto message = [&](const Params& params) {
        Result result;
        try {
            cv::gmlpnp::solveRays(scene.objectPoints, scene.rays, result, params);
        } catch (const cv::Exception& e) {
            EXPECT_EQ(cv::Error::StsBadArg, e.code);
            return e.err;
        }
        return cv::String("no exception");
    };
    Params params;
    params.method = 42;
    EXPECT_NE(cv::String::npos, message(params).find("method"));
    params = Params();
    params.maxRounds = -1;
    EXPECT_NE(cv::String::npos, message(params).find("maxRounds"));
    params = Params();
    params.tolerance = std::nan("");
    EXPECT_NE(cv::String::npos, message(params).find("tolerance"));
    params = Params();
    params.objectNoise = (cv::Mat_<double>(3, 3) << 1, 2, 0, 2, 1, 0, 0, 0, 1);  // not positive semidefinite
    EXPECT_NE(cv::String::npos, message(params).find("objectNoise"));
    params = Params();
    params.bearingNoise = (cv::Mat_<double>(3, 3) << 1, 0, 0, 0.5, 1, 0, 0, 0, 1);  // not symmetric
    EXPECT_NE(cv::String::npos, message(params).find("bearingNoise"));
    params.bearingNoise = 1e61 * cv::Mat::eye(3, 3, CV_64F);  // the covariance of the pose would have no numbers
    EXPECT_NE(cv::String::npos, message(params).find("bearingNoise"));
    params = Params();
    params.objectNoise = params.bearingNoise = cv::Mat::zeros(3, 3, CV_64F);
    params.objectCovariances = cv::Mat(10, 9, CV_64F, cv::Scalar(std::nan("")));
    EXPECT_NE(cv::String::npos, message(params).find("objectCovariances"));
    Result result;
    params = Params();
    params.objectNoise = cv::Mat::eye(2, 2, CV_64F);
    EXPECT_THROW(cv::gmlpnp::solveRays(scene.objectPoints, scene.rays, result, params), cv::Exception);
    EXPECT_THROW(cv::gmlpnp::solveRays(scene.objectPoints, scene.rays.rowRange(0, 9), result), cv::Exception);
    EXPECT_THROW(cv::gmlpnp::solve(scene.objectPoints, scene.imagePoints, cv::Ptr<cv::gmlpnp::CameraModel>(), result),
                 cv::Exception);
}

// A lens that sees only the left half: masked points are left out and counted.
class LeftHalf : public cv::gmlpnp::CameraModel
{
public:
    bool unprojectPoint(const cv::Point2d& pixel, cv::Vec3d& ray, cv::Matx32d* jacobian) const override
    {
        return pixel.x < 320 && whole->unprojectPoint(pixel, ray, jacobian);
    }
    bool projectPoint(const cv::Vec3d& point, cv::Point2d& pixel) const override
    {
        return whole->projectPoint(point, pixel) && pixel.x < 320;
    }

private:
    cv::Ptr<cv::gmlpnp::CameraModel> whole = cv::gmlpnp::CameraModel::pinhole(paperCamera());
};

TEST(Gmlpnp_Solve, pixelsWithoutARayAreLeftOut)
{
    cv::RNG rng = testRng();
    const Scene scene = paperScene(rng, 60, 0.1, 1);
    cv::Mat_<double> points(0, 3), pixels(0, 2);
    for (int i = 0; i < 60; ++i)
        if (scene.imagePoints(i, 0) < 320) {
            points.push_back(scene.objectPoints.row(i));
            pixels.push_back(scene.imagePoints.row(i));
        }
    ASSERT_GT(points.rows, 10);
    Result masked, chosen;
    ASSERT_TRUE(cv::gmlpnp::solve(scene.objectPoints, scene.imagePoints, cv::makePtr<LeftHalf>(), masked));
    const cv::Ptr<CameraModel> pinhole = CameraModel::pinhole(paperCamera());
    ASSERT_TRUE(cv::gmlpnp::solve(points, pixels, cv::makePtr<PlainLens>(pinhole), chosen));
    EXPECT_EQ(points.rows, masked.usedPoints);
    EXPECT_EQ(chosen.rvec, masked.rvec);
    EXPECT_EQ(chosen.tvec, masked.tvec);
}

// Its rays are as long as the caller happened to make them.
class CarelessLens : public PlainLens
{
public:
    using PlainLens::PlainLens;
    bool unprojectPoint(const cv::Point2d& pixel, cv::Vec3d& ray, cv::Matx32d* jacobian) const override
    {
        const bool seen = PlainLens::unprojectPoint(pixel, ray, jacobian);
        ray *= 1 + 1e-3 * std::abs(pixel.x);
        return seen;
    }
};

TEST(Gmlpnp_Solve, theLengthOfALensesRaysDoesNotMatter)
{
    cv::RNG rng = testRng();
    const Scene scene = paperScene(rng, 30, 0.05, 1);
    const cv::Ptr<CameraModel> pinhole = CameraModel::pinhole(paperCamera());
    Result plain, careless;
    ASSERT_TRUE(cv::gmlpnp::solve(scene.objectPoints, scene.imagePoints, cv::makePtr<PlainLens>(pinhole), plain));
    ASSERT_TRUE(cv::gmlpnp::solve(scene.objectPoints, scene.imagePoints, cv::makePtr<CarelessLens>(pinhole), careless));
    EXPECT_TRUE(poseNear(careless, poseOf(plain.rvec, plain.tvec), 1e-9, 1e-9));
}

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
        const Result reference = solved(scene.objectPoints, scene.rays, paramsOf(method));
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

// Where only the pose is asked for, that of many points comes from a part of them and two passes over all: its mean
// error must be that of the estimate from all of them, within what pairs of the same problems can tell.
TEST(Gmlpnp_Solve, thePoseOfManyPointsIsAsGoodAsFromAllOfThem)
{
    struct Cell
    {
        int n;
        double sigma;
        int scenes;
    };
    cv::RNG rng = testRng();
    for (int method : METHODS)
        for (const Cell& cell : {Cell{1000, 0, 600}, Cell{1000, 0.01, 600}, Cell{1000, 0.1, 600}, Cell{1000, 0.5, 600},
                                 Cell{10000, 0.1, 400}, Cell{10000, 0.5, 400}}) {
            double all = 0, more = 0, more2 = 0;
            for (int k = 0; k < cell.scenes; ++k) {
                const Scene scene = paperScene(rng, cell.n, cell.sigma, 1);
                const Result result = solved(scene.objectPoints, scene.rays, paramsOf(method));
                cv::Vec3d rvec, tvec;
                ASSERT_TRUE(cv::gmlpnp::solvePnP(scene.objectPoints, scene.imagePoints, paperCamera(), cv::noArray(),
                                                 rvec, tvec, false, method));
                const double error = rotationAngle(poseOf(result.rvec, result.tvec).R, scene.truth.R);
                const double difference = rotationAngle(poseOf(rvec, tvec).R, scene.truth.R) - error;
                all += error / cell.scenes;
                more += difference / cell.scenes;
                more2 += difference * difference / cell.scenes;
            }
            const double deviation = std::sqrt((more2 - more * more) / cell.scenes);
            std::cout << cv::format("method %d, %d points, %g m: %.3f +- %.3f\n", method, cell.n, cell.sigma,
                                    1 + more / all, 1.96 * deviation / all);
            EXPECT_LT(more - 2.5 * deviation, 0.01 * all) << "method " << method << ", sigma " << cell.sigma;
            EXPECT_LT(2.5 * deviation, 0.1 * all) << "too few scenes to tell";
            EXPECT_GT(more2, 0) << "the part was not used";
        }
}

}  // namespace
}  // namespace opencv_test
