// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../../src/noise/model.hpp"
#include "../../src/noise/scoring.hpp"
#include "fixed_pose.hpp"

namespace opencv_test {
namespace {

using namespace cv::gmlpnp::detail;

// Sums as a pass leaves them, of random Q: the score is half of G - Z, the curvature sum 1/2 tr(Q E Q E').
struct Sums
{
    std::vector<Matrix3d> Q;
    RaySums sums;
};

Sums randomSums(cv::RNG& rng, int n, const Matrix3d& excess)
{
    Sums out;
    out.sums.QQ.setZero();
    out.sums.Go.setZero();
    for (int i = 0; i < n; ++i) {
        const Matrix3d Q = randomNoise(rng, 3);
        Vector6d q;
        q << Q(0, 0), Q(0, 1), Q(0, 2), Q(1, 1), Q(1, 2), Q(2, 2);
        out.Q.push_back(Q);
        out.sums.QQ += q * q.transpose();
        out.sums.Go += Q;
    }
    out.sums.Zo = out.sums.Go + excess;
    out.sums.Gb = out.sums.Go;
    out.sums.Zb = out.sums.Zo;
    return out;
}

Matrix3d symmetricUnit(int i, int j)
{
    Matrix3d E = Matrix3d::Zero();
    E(i, j) = E(j, i) = 1;
    return E;
}

// Of an isotropic noise the prior asks nothing either.
TEST(Gmlpnp_Scoring, isotropicNoiseStaysWhereTheLikelihoodIsFlat)
{
    cv::RNG rng = testRng();
    const Matrix3d R = randomRotation(rng), C = 0.04 * Matrix3d::Identity();
    const RaySums sums = randomSums(rng, 20, Matrix3d::Zero()).sums;
    EXPECT_TRUE(matrixNear(scoredNoise(NoiseKind::OBJECT, {C, Matrix3d::Zero(), {}}, sums, R).Sigma, C, 1e-12));
    EXPECT_TRUE(matrixNear(scoredNoise(NoiseKind::BEARING, {Matrix3d::Zero(), C, {}}, sums, R).Gamma, C, 1e-12));
}

// sum 1/2 tr(Q X Q E) + kappa/2 tr(W X W E) = 1/2 tr((Z - G) E) for every E, W the inverse of an isotropic noise.
TEST(Gmlpnp_Scoring, aSmallStepSolvesItsEquation)
{
    cv::RNG rng = testRng();
    const Matrix3d C = 0.5 * Matrix3d::Identity(), W = C.inverse(), R = Matrix3d::Identity();
    // The step is small, but far above the floor by which the noise is lifted.
    const Matrix3d excess = 1e-4 * (randomNoise(rng, 1) - 0.5 * randomNoise(rng, 1));
    const Sums at = randomSums(rng, 20, excess);
    const Matrix3d X = scoredNoise(NoiseKind::BEARING, {Matrix3d::Zero(), C, {}}, at.sums, R).Gamma - C;
    for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j) {
            const Matrix3d E = symmetricUnit(i, j);
            double curved = 0.5 * SHRINKAGE * (W * X * W * E).trace();
            for (const Matrix3d& Q : at.Q)
                curved += 0.5 * (Q * X * Q * E).trace();
            EXPECT_NEAR(curved, 0.5 * (excess * E).trace(), 1e-4 * excess.norm()) << i << j;
        }
}

// Sigma lies in the frame of the object, the sums in that of the camera.
TEST(Gmlpnp_Scoring, objectNoiseTurnsWithTheObject)
{
    cv::RNG rng = testRng();
    const Matrix3d C = randomNoise(rng, 1) + 0.1 * Matrix3d::Identity(), R = randomRotation(rng);
    const RaySums sums = randomSums(rng, 20, randomNoise(rng, 1)).sums;
    const Matrix3d bearing = scoredNoise(NoiseKind::BEARING, {Matrix3d::Zero(), C, {}}, sums, R).Gamma;
    const Noise object{R.transpose() * C * R, Matrix3d::Zero(), {}};
    const Matrix3d turned = scoredNoise(NoiseKind::OBJECT, object, sums, R).Sigma;
    EXPECT_TRUE(matrixNear(R * turned * R.transpose(), bearing, 1e-12));
}

// However large the score, a round stays positive definite and within the region it knows: e^-2.5 to e^1.5.
TEST(Gmlpnp_Scoring, aRoundIsBoundedAndPositiveDefinite)
{
    cv::RNG rng = testRng();
    for (const double size : {-1e9, -10., 10., 1e9}) {
        const Matrix3d C = randomNoise(rng, 1) + 0.1 * Matrix3d::Identity(), W = Eigen3d(C).operatorInverseSqrt();
        const RaySums sums = randomSums(rng, 20, size * randomNoise(rng, 1)).sums;
        const Matrix3d next =
            scoredNoise(NoiseKind::BEARING, {Matrix3d::Zero(), C, {}}, sums, Matrix3d::Identity()).Gamma;
        const Vector3d factors = Eigen3d(W * next * W).eigenvalues();
        EXPECT_GE(factors(0), std::exp(-2.5) * (1 - 1e-9)) << size;
        EXPECT_LE(factors(2), std::exp(1.5) * (1 + 1e-9)) << size;
    }
}

// Scoring ends where the likelihood with its prior is flat: the numerical gradient vanishes in all directions.
TEST(Gmlpnp_Scoring, endsAtTheMaximumWithItsPrior)
{
    cv::RNG rng = testRng();
    const FixedPose at = fixedPose(rng, 1000);
    for (NoiseKind kind : {NoiseKind::OBJECT, NoiseKind::BEARING}) {
        const bool object = kind == NoiseKind::OBJECT;
        Noise noise;
        Matrix3d& C = object ? noise.Sigma : noise.Gamma;
        C = randomNoise(rng, 0.05);
        if (!object)
            noise.Sigma = 1e-9 * Matrix3d::Identity();
        const PassOptions options{LeverArm::CORRECTED, object ? OF_OBJECT : OF_BEARING, nullptr};
        for (int k = 0; k < 30; ++k)
            noise = scoredNoise(kind, noise, rayPass(at.data, at.pose, noise, options), at.pose.R);

        const Matrix3d found = C, root = C.llt().matrixL(), target = C.trace() / 3 * Matrix3d::Identity();
        const auto cost = [&](const Matrix3d& step) {
            C = found + root * step * root.transpose();
            return rayPass(at.data, at.pose, noise).L +
                   0.5 * SHRINKAGE * (std::log(C.determinant()) + (target * C.inverse()).trace());
        };
        for (int i = 0; i < 3; ++i)
            for (int j = i; j < 3; ++j) {
                constexpr double h = 1e-4;
                Matrix3d E = Matrix3d::Zero();
                E(i, j) = E(j, i) = h;
                EXPECT_NEAR((cost(E) - cost(-E)) / (2 * h), 0, 0.02) << object << ": " << i << j;  // of 1000 points
            }
    }
}

}  // namespace
}  // namespace opencv_test
