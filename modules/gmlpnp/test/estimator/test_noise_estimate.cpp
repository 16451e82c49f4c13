// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../../src/estimator/noise_estimate.hpp"
#include "../scenes.hpp"
#include "../statistics.hpp"

// Whether the noise that comes out is the noise that went in, and its standard errors say how surely.

namespace opencv_test {
namespace {

using cv::gmlpnp::Params;
using cv::gmlpnp::Result;
using namespace cv::gmlpnp::detail;

// Log-uniform depths, a field of half the given slope to either side.
struct View
{
    double nearest, farthest, slope;

    double depth() const { return std::sqrt(nearest * farthest); }
};

constexpr View WIDE{3, 60, 1}, NARROW{4, 16, 0.1}, EQUAL_DEPTHS{5.99, 6.01, 0.2};

Matrix3d trueSigma()
{
    return Vector3d(0.01, 0.0025, 0.000625).asDiagonal();
}

// As large as Sigma at mean depth, and not along the axes of the camera.
Matrix3d trueGamma(const View& view)
{
    Matrix3d shape;
    shape << 1, 0.3, 0, 0.3, 0.5, 0, 0, 0, 0.5;
    return 0.01 / (view.depth() * view.depth()) * shape;
}

void addTo(cv::Mat_<double>& rows, int i, const Vector3d& v)
{
    for (int k = 0; k < 3; ++k)
        rows(i, k) += v(k);
}

Scene sceneOf(cv::RNG& rng, const View& view, int n, const Matrix3d& Sigma, const Matrix3d& Gamma)
{
    std::vector<Vector3d> points(n);
    for (Vector3d& X : points) {
        const double x = rng.uniform(-view.slope, view.slope), y = rng.uniform(-view.slope, view.slope);
        X = std::exp(rng.uniform(std::log(view.nearest), std::log(view.farthest))) * Vector3d(x, y, 1);
    }
    Scene scene = exactScene(rng, points);
    const Matrix3d ofObject = Eigen3d(Sigma).operatorSqrt(), ofBearing = Eigen3d(Gamma).operatorSqrt();
    for (int i = 0; i < n; ++i) {
        addTo(scene.objectPoints, i, ofObject * gaussian3(rng));
        addTo(scene.rays, i, ofBearing * gaussian3(rng));  // solveRays() normalises
    }
    return scene;
}

TEST(Gmlpnp_NoiseEstimate, informationIsThatOfEachPoint)
{
    cv::RNG rng = testRng();
    const Scene scene = sceneOf(rng, WIDE, 31, trueSigma(), trueGamma(WIDE));
    const Correspondences data(scene.objectPoints, scene.rays);
    const Noise noise{randomNoise(rng, 0.1), randomNoise(rng, 0.1), {1, 1, 5}};
    const Pose pose = data.fromObject(scene.truth);
    Matrix12d expected = Matrix12d::Zero();
    for (int i = 0; i < data.size(); ++i) {
        const PointTerms at = pointTerms(data, i, pose, noise);
        for (int a = 0; a < 12; ++a)
            for (int b = 0; b < 12; ++b) {
                const Vector6d unitA = Vector6d::Unit(a % 6), unitB = Vector6d::Unit(b % 6);
                const double depths = (a < 6 ? 1 : at.s * at.s) * (b < 6 ? 1 : at.s * at.s);
                const Matrix3d product = at.Q * symmetric(unitA.data()) * at.Q * symmetric(unitB.data());
                expected(a, b) +=
                    (0.2 + 0.2 + 1) / (0.8 + 1) * 0.5 * depths * product.trace();  // (nu+2)/(nu+4), nu = 5
            }
    }
    EXPECT_TRUE(matrixNear(noiseInformation(data, pose, noise), expected, 1e-9 * expected.norm()));
}

// The mean of each entry's error over many problems, and of the square of error over standard error. Known to be left
// are 2 % of the largest variance (doc/lab/noise.md), and 20 % of the squares: errors of a variance are not quite
// Gaussian.
TEST(Gmlpnp_NoiseEstimateStatistics, bothNoisesAreUnbiasedAndTheirErrorsCalibrated)
{
    constexpr int PROBLEMS = 300;
    cv::RNG rng = testRng();
    const Matrix3d truth[2] = {trueSigma(), trueGamma(WIDE)};
    Matrix3d error[2], square[2], score[2], score2[2];
    for (int k = 0; k < 2; ++k)
        error[k] = square[k] = score[k] = score2[k] = Matrix3d::Zero();
    for (int problem = 0; problem < PROBLEMS; ++problem) {
        const Result result = solved(sceneOf(rng, WIDE, 200, truth[0], truth[1]));
        EXPECT_EQ(cv::gmlpnp::NOISE_BOTH, result.noiseModel);
        const Matrix3d found[2] = {matrix3(result.objectNoise), matrix3(result.bearingNoise)};
        const Matrix3d deviation[2] = {matrix3(result.objectNoiseStdErr), matrix3(result.bearingNoiseStdErr)};
        for (int k = 0; k < 2; ++k) {
            const Matrix3d e = (found[k] - truth[k]) / truth[k](0, 0), d = deviation[k] / truth[k](0, 0);
            error[k] += e / PROBLEMS;
            square[k] += e.cwiseAbs2() / PROBLEMS;
            const Matrix3d squares = e.cwiseQuotient(d).cwiseAbs2();
            score[k] += squares / PROBLEMS;
            score2[k] += squares.cwiseAbs2() / PROBLEMS;
        }
    }
    for (int k = 0; k < 2; ++k)
        for (int a = 0; a < 3; ++a)
            for (int b = a; b < 3; ++b) {
                const double deviation = std::sqrt(square[k](a, b) / PROBLEMS);
                EXPECT_TRUE(within(error[k](a, b), -0.02, 0.02, deviation)) << k << a << b;
                const double mean = score[k](a, b), variance = score2[k](a, b) - mean * mean;
                EXPECT_TRUE(within(mean, 0.8, 1.2, std::sqrt(variance / PROBLEMS))) << k << a << b;
            }
}

TEST(Gmlpnp_NoiseEstimate, whatTheDataDoNotTellHasALargeError)
{
    cv::RNG rng = testRng();
    const auto largest = [](const cv::Mat& errors, const Matrix3d& noise) {
        return matrix3(errors).maxCoeff() / noise.trace();
    };
    const Result wide = solved(sceneOf(rng, WIDE, 200, trueSigma(), trueGamma(WIDE)));
    EXPECT_LT(largest(wide.objectNoiseStdErr, trueSigma()), 0.5);
    EXPECT_LT(largest(wide.bearingNoiseStdErr, trueGamma(WIDE)), 0.5);
    // Along the rays: of the object noise in the camera's frame, zz.
    const Result narrow = solved(sceneOf(rng, NARROW, 200, trueSigma(), trueGamma(NARROW)));
    EXPECT_GT(largest(narrow.objectNoiseStdErr, trueSigma()), 2);
    EXPECT_GT(matrix3(narrow.bearingNoiseStdErr)(2, 2), 2 * trueGamma(NARROW).trace());
    EXPECT_LT(matrix3(narrow.bearingNoiseStdErr)(0, 0), 0.5 * trueGamma(NARROW).trace());
    // One noise from the other.
    const Result equal = solved(sceneOf(rng, EQUAL_DEPTHS, 200, trueSigma(), trueGamma(EQUAL_DEPTHS)));
    EXPECT_GT(largest(equal.objectNoiseStdErr, trueSigma()), 2);
    EXPECT_GT(largest(equal.bearingNoiseStdErr, trueGamma(EQUAL_DEPTHS)), 2);
}

// At one depth their sum is known all the same, to 3 %.
TEST(Gmlpnp_NoiseEstimateStatistics, atOneDepthTheSumIsRight)
{
    constexpr int PROBLEMS = 200;
    cv::RNG rng = testRng();
    const View& view = EQUAL_DEPTHS;
    Mean ratio;
    for (int problem = 0; problem < PROBLEMS; ++problem) {
        const Scene scene = sceneOf(rng, view, 100, trueSigma(), trueGamma(view));
        const Result result = solved(scene);
        const auto across = [&](const Pose& pose, const Matrix3d& Sigma, const Matrix3d& Gamma) {
            const Matrix3d S = pose.R * Sigma * pose.R.transpose() + view.depth() * view.depth() * Gamma;
            return S(0, 0) + S(1, 1);
        };
        ratio.add(across(poseOf(result), matrix3(result.objectNoise), matrix3(result.bearingNoise)) /
                  across(scene.truth, trueSigma(), trueGamma(view)));
    }
    EXPECT_TRUE(within(ratio.value(), 0.97, 1.03, ratio.deviation()));
}

TEST(Gmlpnp_NoiseEstimate, whatWasGivenHasNoError)
{
    cv::RNG rng = testRng();
    const Scene scene = sceneOf(rng, WIDE, 60, trueSigma(), trueGamma(WIDE));
    Params params;
    params.objectNoise = 0.01 * cv::Mat::eye(3, 3, CV_64F);
    const Result object = solved(scene, params);
    EXPECT_TRUE(object.objectNoiseStdErr.empty());
    EXPECT_EQ(cv::Size(3, 3), object.bearingNoiseStdErr.size());
    params.bearingNoise = 1e-4 * cv::Mat::eye(3, 3, CV_64F);
    const Result both = solved(scene, params);
    EXPECT_TRUE(both.objectNoiseStdErr.empty() && both.bearingNoiseStdErr.empty());
    params = Params();
    params.method = cv::gmlpnp::SOLVEPNP_GMLPNP;
    const Result published = solved(scene, params);
    EXPECT_TRUE(published.objectNoiseStdErr.empty() && published.bearingNoiseStdErr.empty());
}

// Units and frames: a scene k times as large has k^2 times the object noise and its errors, the same bearing noise.
TEST(Gmlpnp_NoiseEstimate, errorsHaveTheUnitsOfTheNoise)
{
    cv::RNG rng = testRng();
    Scene scene = sceneOf(rng, WIDE, 80, trueSigma(), trueGamma(WIDE));
    const Result a = solved(scene);
    const double k = 1000;
    scene.objectPoints *= k;
    const Result b = solved(scene);
    const auto near = [](const cv::Mat& x, const cv::Mat& y) {
        return matrixNear(matrix3(x), matrix3(y), 1e-6 * cv::norm(x));
    };
    EXPECT_TRUE(near(k * k * a.objectNoise, b.objectNoise));
    EXPECT_TRUE(near(k * k * a.objectNoiseStdErr, b.objectNoiseStdErr));
    EXPECT_TRUE(near(a.bearingNoise, b.bearingNoise));
    EXPECT_TRUE(near(a.bearingNoiseStdErr, b.bearingNoiseStdErr));
}

// An object of 60 px in pixel noise: neither kind of noise can be told from its data, and taking it for noise of the
// points would pull the pose towards the camera by half its standard deviation.
TEST(Gmlpnp_NoiseEstimateStatistics, smallObjectsAreNotPulledTowardsTheCamera)
{
    constexpr int PROBLEMS = 400, POINTS = 100;
    cv::RNG rng = testRng();
    const cv::Ptr<cv::gmlpnp::CameraModel> camera = cv::gmlpnp::CameraModel::pinhole(paperCamera());
    Mean off, evidence;
    for (int problem = 0; problem < PROBLEMS; ++problem) {
        std::vector<Vector3d> points(POINTS);
        for (Vector3d& X : points) {
            const double x = rng.uniform(-0.225, 0.225), y = rng.uniform(-0.225, 0.225);
            X = Vector3d(x, y, rng.uniform(5.775, 6.225));
        }
        Scene scene = exactScene(rng, points);
        disturb(rng, scene, 0, 1, *camera);
        const Result result = solved(scene);
        off.add((poseOf(result).t - scene.truth.t).dot(scene.truth.t.normalized()));
        evidence.add(result.noiseEvidence);
    }
    EXPECT_TRUE(withinSigma(off.value(), 0, off.deviation(), 3.5));
    EXPECT_LT(evidence.value(), 3);  // it is the prior that decides, and the result does not claim otherwise
}

}  // namespace
}  // namespace opencv_test
