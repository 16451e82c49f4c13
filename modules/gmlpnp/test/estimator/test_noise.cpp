// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../scenes.hpp"

// Heavy tails, known uncertainties, and whether the pose covariance holds what it promises.

namespace opencv_test {
namespace {

using cv::gmlpnp::Params;
using cv::gmlpnp::Result;
using namespace cv::gmlpnp::detail;

constexpr double CHI2_6_95 = 12.592;

Result solved(const Scene& scene, const Params& params)
{
    Result result;
    EXPECT_TRUE(cv::gmlpnp::solve(scene.objectPoints, scene.imagePoints, paperCamera(), cv::noArray(), result, params));
    return result;
}

double distance(const Result& result, const Scene& scene)
{
    return (poseOf(result.rvec, result.tvec).t - scene.truth.t).norm();
}

// The first `count` points get five times the noise in all.
void contaminate(cv::RNG& rng, Scene& scene, int count)
{
    const Matrix3d root = Eigen3d(24 * scene.Sigma).operatorSqrt();
    for (int i = 0; i < count; ++i) {
        const Vector3d e = root * gaussian3(rng);
        for (int k = 0; k < 3; ++k)
            scene.objectPoints(i, k) += e(k);
    }
}

TEST(Gmlpnp_Noise, tailsCostNothingOnGaussianDataAndSaveTheRest)
{
    cv::RNG rng = testRng();
    for (int bad : {0, 5}) {
        double robust = 0, gaussian = 0;
        int tails = 0;
        for (int k = 0; k < 400; ++k) {
            Scene scene = paperScene(rng, 50, 0.1, 1);
            contaminate(rng, scene, bad);
            Params params;
            const Result withTails = solved(scene, params);
            params.robust = false;
            const Result without = solved(scene, params);
            EXPECT_TRUE(std::isinf(without.tailDof));
            robust += distance(withTails, scene);
            gaussian += distance(without, scene);
            tails += std::isfinite(withTails.tailDof);
        }
        if (bad == 0) {
            EXPECT_LT(robust / gaussian, 1.01);
            EXPECT_LT(tails, 40);
        } else {
            EXPECT_LT(robust / gaussian, 0.8);
            EXPECT_GT(tails, 320);
        }
    }
}

// A Gaussian fitted to 20 points of which four are wild is so wide that none looks wild: the tails must show all the
// same.
TEST(Gmlpnp_Noise, tailsShowAmongFewPoints)
{
    cv::RNG rng = testRng();
    for (int bad : {0, 4}) {
        double robust = 0, gaussian = 0;
        for (int k = 0; k < 1000; ++k) {
            Scene scene = paperScene(rng, 20, 0.1, 1);
            contaminate(rng, scene, bad);
            Params params;
            robust += distance(solved(scene, params), scene);
            params.robust = false;
            gaussian += distance(solved(scene, params), scene);
        }
        EXPECT_LT(robust / gaussian, bad == 0 ? 1.02 : 0.7) << bad;
    }
}

// Pixels that are sharp in one direction and seen of a small object: the noise is all but singular, and scoring alone,
// which takes the expected curvature for the true one, ran away from it.
TEST(Gmlpnp_Noise, isFoundWhereItIsAllButSingular)
{
    cv::RNG rng = testRng();
    const cv::Matx33d K = paperCamera();
    double marginal = 0, published = 0;
    for (int k = 0; k < 100; ++k) {
        Scene scene = paperScene(rng, 400, 0, 0);
        scene.objectPoints *= 0.1;  // 60 px
        for (int i = 0; i < 400; ++i) {
            const double sharp = rng.gaussian(0.02), blurred = rng.gaussian(1);
            const Vector3d p(scene.objectPoints(i, 0), scene.objectPoints(i, 1), scene.objectPoints(i, 2));
            const Vector3d x = scene.truth * p / (scene.truth * p).z();
            scene.imagePoints(i, 0) = K(0, 0) * x(0) + K(0, 2) + std::cos(k) * sharp - std::sin(k) * blurred;
            scene.imagePoints(i, 1) = K(1, 1) * x(1) + K(1, 2) + std::sin(k) * sharp + std::cos(k) * blurred;
        }
        Params params;
        const Result found = solved(scene, params);
        EXPECT_TRUE(std::isinf(found.tailDof)) << k;
        marginal += distance(found, scene);
        params.method = cv::gmlpnp::SOLVEPNP_GMLPNP;
        published += distance(solved(scene, params), scene);
    }
    EXPECT_LT(marginal / published, 1.05);  // at one depth the two are the same estimate
}

TEST(Gmlpnp_Noise, weightsNameTheOutliers)
{
    cv::RNG rng = testRng();
    Scene scene = paperScene(rng, 60, 0.05, 1);
    for (int i = 0; i < 3; ++i)
        scene.imagePoints(i, 0) += 200;
    const Result result = solved(scene, Params());
    ASSERT_EQ(cv::Size(1, 60), result.weights.size());
    double mean = 0;
    for (int i = 3; i < 60; ++i)
        mean += result.weights.at<double>(i) / 57;
    EXPECT_GT(mean, 0.9);
    for (int i = 0; i < 3; ++i)
        EXPECT_LT(result.weights.at<double>(i), 0.1);
    EXPECT_TRUE(poseNear(result, scene.truth, 0.02, 0.1));
}

cv::Mat_<double> asRow(const Matrix3d& C)
{
    cv::Mat_<double> row(1, 9);
    for (int k = 0; k < 9; ++k)
        row(k) = C(k / 3, k % 3);
    return row;
}

TEST(Gmlpnp_Noise, covariancesOfAllPointsAlikeAreKnownNoise)
{
    cv::RNG rng = testRng();
    const Scene scene = paperScene(rng, 40, 0.1, 1);
    const cv::Mat zero = cv::Mat::zeros(3, 3, CV_64F);
    Params known, each;
    known.bearingNoise = each.bearingNoise = zero;
    each.objectNoise = zero;
    known.objectNoise = asRow(scene.Sigma + 1e-3 * Matrix3d::Identity()).reshape(1, 3);
    cv::repeat(known.objectNoise.reshape(1, 1), 40, 1, each.objectCovariances);
    const Result a = solved(scene, known), b = solved(scene, each);
    EXPECT_TRUE(poseNear(b, poseOf(a.rvec, a.tvec), 1e-7, 1e-7));
    EXPECT_NEAR(a.cost, b.cost, 1e-6);
    EXPECT_LT(cv::norm(a.poseCovariance, b.poseCovariance), 1e-6 * cv::norm(a.poseCovariance));
}

// Half of the points ten times worse, and known to be: the estimate uses it.
TEST(Gmlpnp_Noise, objectCovariancesHelp)
{
    cv::RNG rng = testRng();
    double with = 0, without = 0;
    for (int k = 0; k < 100; ++k) {
        Scene scene = exactScene(rng, boxPoints(rng, 40));
        cv::Mat_<double> rows(0, 9);
        for (int i = 0; i < 40; ++i) {
            const double sigma = i % 2 ? 0.2 : 0.02;
            const Vector3d e = sigma * gaussian3(rng);
            for (int a = 0; a < 3; ++a)
                scene.objectPoints(i, a) += e(a);
            rows.push_back(asRow(sigma * sigma * Matrix3d::Identity()));
        }
        Params params;
        params.robust = false;
        without += distance(solved(scene, params), scene);
        params.objectCovariances = rows;
        with += distance(solved(scene, params), scene);
    }
    EXPECT_LT(with / without, 0.6);
}

TEST(Gmlpnp_Noise, pixelCovariancesHelpInEitherForm)
{
    cv::RNG rng = testRng();
    double with = 0, without = 0;
    for (int k = 0; k < 100; ++k) {
        Scene scene = exactScene(rng, boxPoints(rng, 40));
        cv::Mat_<double> variances(40, 1), matrices(40, 4, 0.0);
        for (int i = 0; i < 40; ++i) {
            const double sigma = i % 2 ? 10 : 1;
            scene.imagePoints(i, 0) += rng.gaussian(sigma);
            scene.imagePoints(i, 1) += rng.gaussian(sigma);
            variances(i) = matrices(i, 0) = matrices(i, 3) = sigma * sigma;
        }
        Params params;
        params.robust = false;
        without += distance(solved(scene, params), scene);
        params.pixelCovariances = variances;
        const Result a = solved(scene, params);
        with += distance(a, scene);
        params.pixelCovariances = matrices;
        EXPECT_TRUE(poseNear(solved(scene, params), poseOf(a.rvec, a.tvec), 1e-12, 1e-12));
    }
    EXPECT_LT(with / without, 0.6);
}

TEST(Gmlpnp_Noise, wrongCovariancesAreRefusedAndThePointNamed)
{
    cv::RNG rng = testRng();
    const Scene scene = paperScene(rng, 10, 0.1, 1);
    const auto message = [&](const Params& params) {
        Result result;
        try {
            cv::gmlpnp::solve(scene.objectPoints, scene.imagePoints, paperCamera(), cv::noArray(), result, params);
        } catch (const cv::Exception& e) {
            return e.err;
        }
        return cv::String("no exception");
    };
    const auto names = [](const cv::String& text, const char* a, const char* b) {
        return text.find(a) != cv::String::npos && text.find(b) != cv::String::npos;
    };
    Params params;
    cv::repeat(asRow(Matrix3d::Identity()), 10, 1, params.objectCovariances);
    params.objectCovariances.at<double>(7, 4) = -1;
    EXPECT_TRUE(names(message(params), "objectCovariances", "point 7")) << message(params);
    params.objectCovariances = cv::Mat::ones(10, 6, CV_64F);
    EXPECT_TRUE(names(message(params), "objectCovariances", "9")) << message(params);
    params.objectCovariances = cv::Mat::zeros(9, 9, CV_64F);
    EXPECT_TRUE(names(message(params), "objectCovariances", "10")) << message(params);
    params.objectCovariances = cv::Mat::zeros(9, 10, CV_64F);  // transposed
    EXPECT_TRUE(names(message(params), "objectCovariances", "10")) << message(params);
    params.objectCovariances = cv::Mat(90, 20, CV_64F, cv::Scalar(0)).colRange(0, 1);
    EXPECT_TRUE(names(message(params), "objectCovariances", "10")) << message(params);
    params = Params();
    params.objectNoise = -1e160 * cv::Mat::eye(3, 3, CV_64F);
    EXPECT_TRUE(names(message(params), "objectNoise", "semidefinite")) << message(params);
    params = Params();
    params.method = cv::gmlpnp::SOLVEPNP_GMLPNP;
    params.objectNoise = cv::Mat::zeros(3, 3, CV_64F);
    EXPECT_TRUE(names(message(params), "objectNoise", "zero")) << message(params);
    params = Params();
    params.pixelCovariances = cv::Mat::ones(10, 1, CV_32F);
    params.pixelCovariances.at<float>(3) = -2;
    EXPECT_TRUE(names(message(params), "pixelCovariances", "point 3")) << message(params);
    params.pixelCovariances.at<float>(3) = std::nanf("");
    EXPECT_TRUE(names(message(params), "pixelCovariances", "point 3")) << message(params);
    params.pixelCovariances = cv::Mat::ones(10, 2, CV_64F);
    EXPECT_TRUE(names(message(params), "pixelCovariances", "1 or 4")) << message(params);
    params.pixelCovariances = cv::Mat::ones(10, 1, CV_64F);
    Result result;
    EXPECT_THROW(cv::gmlpnp::solveRays(scene.objectPoints, scene.rays, result, params), cv::Exception);
}

enum class Made
{
    OBJECT,
    PIXELS,
    BOTH
};

// The first `noisy` points have five times the noise.
Scene sceneOf(cv::RNG& rng, Made made, int n, double halfField, int noisy)
{
    const double slope = std::tan(halfField);
    std::vector<Vector3d> points(n);
    for (Vector3d& X : points) {
        const double x = rng.uniform(-slope, slope), y = rng.uniform(-slope, slope);
        X = rng.uniform(4., 8.) * Vector3d(x, y, 1);
    }
    Scene scene = exactScene(rng, points);
    const Matrix3d root =
        made == Made::PIXELS ? Matrix3d(Matrix3d::Zero()) : Eigen3d(randomNoise(rng, 0.1)).operatorSqrt();
    const double px = made == Made::OBJECT ? 0 : 2;
    for (int i = 0; i < n; ++i) {
        const double times = i < noisy ? 5 : 1;
        const Vector3d e = times * root * gaussian3(rng);
        for (int k = 0; k < 3; ++k)
            scene.objectPoints(i, k) += e(k);
        scene.imagePoints(i, 0) += times * px * rng.gaussian(1);
        scene.imagePoints(i, 1) += times * px * rng.gaussian(0.5);
    }
    return scene;
}

double covered(cv::RNG& rng, Made made, int n, double halfField, double noisy, int trials)
{
    int inside = 0;
    for (int k = 0; k < trials; ++k) {
        const Scene scene = sceneOf(rng, made, n, halfField, cvRound(noisy * n));
        const Result result = solved(scene, Params());
        inside += mahalanobis2(scene.truth, poseOf(result.rvec, result.tvec), result.poseCovariance) < CHI2_6_95;
    }
    return inside / double(trials);
}

// The 95 % ellipsoid of the pose holds the truth in 93 to 97 %, give or take three binomial standard errors.
void expectCovers(int trials, const std::vector<int>& counts, double noisy)
{
    cv::RNG rng = testRng();
    const double error = 3 * std::sqrt(0.95 * 0.05 / trials);
    for (Made made : {Made::OBJECT, Made::PIXELS, Made::BOTH})
        for (double degrees : {15., 60.})
            for (int n : counts) {
                const double share = covered(rng, made, n, degrees * CV_PI / 180, noisy, trials);
                std::cout << "noise " << static_cast<int>(made) << ", half field " << degrees << ", n " << n << ": "
                          << share << std::endl;
                EXPECT_GE(share, 0.93 - error);
                EXPECT_LE(share, 0.97 + error);
            }
}

TEST(Gmlpnp_Noise, poseCovarianceCovers)
{
    expectCovers(300, {15, 50}, 0);
}

TEST(SlowGmlpnp_Noise, poseCovarianceCovers)
{
    expectCovers(2000, {15, 20, 50, 100, 200}, 0);
}

TEST(SlowGmlpnp_Noise, poseCovarianceCoversWithTails)
{
    expectCovers(2000, {15, 20, 50, 200}, 0.1);
}

TEST(SlowGmlpnp_Noise, poseCovarianceCoversWithHeavyTails)
{
    expectCovers(2000, {15, 20, 50, 200}, 0.2);
}

}  // namespace
}  // namespace opencv_test
