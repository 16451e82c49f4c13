// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include <functional>

#include "../../src/noise/model.hpp"
#include "../../src/noise/scoring.hpp"
#include "fixed_pose.hpp"

namespace opencv_test {
namespace {

using namespace cv::gmlpnp::detail;

using Update = std::function<Matrix3d(const Matrix3d& Sigma, const RaySums& sums, const Matrix3d& R)>;

// Updates Sigma alone until it settles, and asserts on the way that L never rises.
Matrix3d settle(const FixedPose& at, const Update& update, int rounds)
{
    Noise noise{0.01 * Matrix3d::Identity(), Matrix3d::Zero(), {}};
    double before = HUGE_VAL;
    for (int k = 0; k < rounds; ++k) {
        const RaySums sums = rayPass(at.data, at.pose, noise);
        EXPECT_LE(sums.L, before + 1e-9 * std::abs(sums.L)) << "round " << k;
        before = sums.L;
        noise.Sigma = update(noise.Sigma, sums, at.pose.R);
    }
    return noise.Sigma;
}

TEST(Gmlpnp_NoiseModel, emAndMmNeverRaiseTheCostAndAgree)
{
    cv::RNG rng = testRng();
    const FixedPose at = fixedPose(rng, 1000);
    const auto toObject = [](const Matrix3d& M, const Matrix3d& R) { return Matrix3d(R.transpose() * M * R); };
    const Matrix3d em = settle(
        at,
        [&](const Matrix3d& Sigma, const RaySums& sums, const Matrix3d& R) {
            return emUpdate(Sigma, toObject(sums.Zo, R), toObject(sums.Go, R), at.data.size());
        },
        600);
    const Matrix3d mm = settle(
        at,
        [&](const Matrix3d& Sigma, const RaySums& sums, const Matrix3d& R) {
            return mmUpdate(Sigma, toObject(sums.Zo, R), toObject(sums.Go, R));
        },
        200);
    EXPECT_TRUE(matrixNear(em, mm, 1e-3 * mm.norm()));
}

TEST(Gmlpnp_NoiseModel, mmSolvesItsEquation)
{
    cv::RNG rng = testRng();
    const Matrix3d C = randomNoise(rng, 0.3), Z = 50 * randomNoise(rng, 2), G = 40 * randomNoise(rng, 3);
    const Matrix3d next = mmUpdate(C, Z, G);
    const Matrix3d CZC = C * Z * C;
    EXPECT_TRUE(matrixNear(next * G * next, CZC, 1e-10 * CZC.norm()));
}

// Twice the way along the geodesic: with C^(-1/2) . C^(-1/2) as the coordinates, the square of the MM step.
TEST(Gmlpnp_NoiseModel, accelerationSquaresTheStep)
{
    cv::RNG rng = testRng();
    const Matrix3d C = randomNoise(rng, 0.3), Z = 50 * randomNoise(rng, 2), G = 40 * randomNoise(rng, 3);
    const Matrix3d W = Eigen3d(C).operatorInverseSqrt();
    const Matrix3d one = W * mmUpdate(C, Z, G) * W, two = W * acceleratedMm(C, Z, G) * W;
    EXPECT_TRUE(matrixNear(two, one * one, 1e-9 * two.norm()));
}

TEST(Gmlpnp_NoiseModel, emUpdateIsThePublishedOnePlusWhatTheFreeDepthHides)
{
    cv::RNG rng = testRng();
    const Matrix3d C = randomNoise(rng, 0.3), Z = randomNoise(rng, 2), G = randomNoise(rng, 3);
    EXPECT_TRUE(matrixNear(emUpdate(C, Z, G, 7), publishedUpdate(C, Z, 7) + C - C * G * C / 7, 1e-14));
}

// Sigma of Algorithm 1 is the mean of e e^T with e = p - R^T (s m - t) at the best depth of each point.
TEST(Gmlpnp_NoiseModel, publishedUpdateIsTheCovarianceOfTheObjectResiduals)
{
    cv::RNG rng = testRng();
    const FixedPose at = fixedPose(rng, 30);
    const Noise noise{randomNoise(rng, 0.2), Matrix3d::Zero(), {}};
    const Matrix3d& R = at.pose.R;
    const Matrix3d information = noise.Sigma.inverse();
    Matrix3d mean = Matrix3d::Zero();
    for (int i = 0; i < at.data.size(); ++i) {
        const Vector3d q = at.data.pointAt(i) + R.transpose() * at.pose.t, m = R.transpose() * at.data.scaledRayAt(i);
        const double s = q.dot(information * m) / m.dot(information * m);  // Eq. (6)
        const Vector3d e = q - s * m;
        mean += e * e.transpose() / at.data.size();
    }
    const RaySums sums = rayPass(at.data, at.pose, noise);
    EXPECT_TRUE(matrixNear(publishedUpdate(noise.Sigma, R.transpose() * sums.Zo * R, at.data.size()), mean,
                           1e-9 * mean.norm()));
}

TEST(Gmlpnp_NoiseModel, shrinkageKeepsTheTraceAndFloors)
{
    const Matrix3d C = Vector3d(3, 1, 0).asDiagonal();
    const Matrix3d drawn = shrunk(C, 10, 2);
    EXPECT_NEAR(drawn.trace(), 4, 1e-12);
    EXPECT_NEAR(drawn(2, 2), 2 * (4. / 3) / 12, 1e-12);
    EXPECT_GT(Eigen3d(shrunk(Matrix3d::Zero(), 10, 2)).eigenvalues()(0), 0);
}

// Residuals made of known isotropic noises, at depths that tell them apart.
TEST(Gmlpnp_NoiseModel, splitFindsBothVariances)
{
    cv::RNG rng = testRng();
    const int n = 20000;
    const double object = 0.02, bearing = 0.004;
    cv::Mat_<double> points(n, 3), rays(n, 3);
    for (int i = 0; i < n; ++i) {
        const double s = std::exp(rng.uniform(std::log(2.), std::log(20.)));
        const Vector3d m = Vector3d(rng.uniform(-.7, .7), rng.uniform(-.7, .7), 1).normalized();
        const Vector3d p = s * m + object * gaussian3(rng), ray = m + bearing * gaussian3(rng);
        for (int k = 0; k < 3; ++k)
            points(i, k) = p(k), rays(i, k) = ray(k);
    }
    const Correspondences data(points, rays);
    const IsotropicSplit split = splitResiduals(data, data.fromObject(Pose{}));
    EXPECT_NEAR(std::sqrt(split.both.a) * data.scale, object, 0.05 * object);
    EXPECT_NEAR(std::sqrt(split.both.b), bearing, 0.05 * bearing);
}

// At one depth only the sum means anything; it must come out right, not doubled.
TEST(Gmlpnp_NoiseModel, splitAtOneDepthKeepsTheSum)
{
    cv::RNG rng = testRng();
    const int n = 5000;
    const double object = 0.02, depth = 5;
    cv::Mat_<double> points(n, 3), rays(n, 3);
    for (int i = 0; i < n; ++i) {
        const Vector3d m = Vector3d(rng.uniform(-.7, .7), rng.uniform(-.7, .7), 1).normalized();
        const Vector3d p = depth * m + object * gaussian3(rng);
        for (int k = 0; k < 3; ++k)
            points(i, k) = p(k), rays(i, k) = m(k);
    }
    const Correspondences data(points, rays);
    const IsotropicSplit split = splitResiduals(data, data.fromObject(Pose{}));
    const double total = (split.both.a + split.both.b * split.meanDepth2) * data.scale * data.scale;
    EXPECT_NEAR(std::sqrt(total), object, 0.03 * object);
}

}  // namespace
}  // namespace opencv_test
