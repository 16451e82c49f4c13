// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../../src/rays/ray_pass.hpp"
#include "../scenes.hpp"

// The sums of a pass against the terms of its points, written out.

namespace opencv_test {
namespace {

using namespace cv::gmlpnp::detail;

RaySums sumsByPointTerms(const Correspondences& data, const Pose& pose, const Noise& noise)
{
    RaySums sums;
    sums.H.setZero(), sums.g.setZero();
    sums.Zo.setZero(), sums.Go.setZero(), sums.Zb.setZero(), sums.Gb.setZero();
    sums.L = sums.misfit = sums.c = sums.c2 = sums.inFront = 0;
    for (int i = 0; i < data.size(); ++i) {
        const PointTerms at = pointTerms(data, i, pose, noise);
        Eigen::Matrix<double, 3, 6> J;
        J << -hat(at.Xhat), Matrix3d::Identity();
        sums.H += at.w * J.transpose() * at.Q * J;
        sums.g += at.w * J.transpose() * at.zTilde;
        sums.Zo += at.w * at.z * at.z.transpose();
        sums.Go += at.Q;
        sums.Zb += at.w * at.s * at.s * at.z * at.z.transpose();
        sums.Gb += at.s * at.s * at.Q;
        const double misfit = noise.tails.share > 0 ? -std::log(tailTerms(noise.tails, at.c).g) : 0.5 * at.c;
        sums.c += at.c;
        sums.c2 += at.c * at.c;
        sums.misfit += misfit;
        sums.L += 0.5 * std::log(at.D) + misfit;
        sums.inFront += at.s > 0;
    }
    return sums;
}

void expectSameSums(const RaySums& ours, const RaySums& theirs)
{
    const double relative = 1e-11;
    EXPECT_TRUE(matrixNear(ours.H, theirs.H, relative * theirs.H.norm()));
    EXPECT_TRUE(matrixNear(ours.g, theirs.g, relative * theirs.H.norm()));
    EXPECT_TRUE(matrixNear(ours.Zo, theirs.Zo, relative * theirs.Zo.norm()));
    EXPECT_TRUE(matrixNear(ours.Go, theirs.Go, relative * theirs.Go.norm()));
    EXPECT_TRUE(matrixNear(ours.Zb, theirs.Zb, relative * theirs.Zb.norm()));
    EXPECT_TRUE(matrixNear(ours.Gb, theirs.Gb, relative * theirs.Gb.norm()));
    EXPECT_NEAR(ours.L, theirs.L, relative * std::abs(theirs.L));
    EXPECT_NEAR(ours.misfit, theirs.misfit, relative * theirs.misfit);
    EXPECT_NEAR(ours.c, theirs.c, relative * theirs.c);
    EXPECT_NEAR(ours.c2, theirs.c2, relative * theirs.c2);
    EXPECT_EQ(ours.inFront, theirs.inFront);
}

cv::Mat_<double> randomCovariances(cv::RNG& rng, int n, double sigma)
{
    cv::Mat_<double> rows(n, 9);
    for (int i = 0; i < n; ++i) {
        const Matrix3d C = randomNoise(rng, sigma);
        for (int k = 0; k < 9; ++k)
            rows(i, k) = C(k / 3, k % 3);
    }
    return rows;
}

TEST(Gmlpnp_RayPass, addsThePointTerms)
{
    cv::RNG rng = testRng();
    const Scene scene = exactScene(rng, surroundingPoints(rng, 37));
    const cv::Mat_<double> P = randomCovariances(rng, 37, 0.5), B = randomCovariances(rng, 37, 0.1);
    for (const Correspondences& data : {Correspondences(scene.objectPoints, scene.rays),
                                        Correspondences(Observations{scene.objectPoints, scene.rays, P, {}}),
                                        Correspondences(Observations{scene.objectPoints, scene.rays, {}, B}),
                                        Correspondences(Observations{scene.objectPoints, scene.rays, P, B})})
        for (const Tails& tails : {Tails{}, Tails{0.02}, Tails{0.5, 9, 3}, Tails{1, 1, 2}}) {
            const Pose pose{randomRotation(rng), gaussian3(rng)};
            const Noise noise{randomNoise(rng, 0.2), randomNoise(rng, 0.05), tails};
            expectSameSums(rayPass(data, pose, noise), sumsByPointTerms(data, pose, noise));
        }
}

// What is known of every point alike is the same as so much more noise.
TEST(Gmlpnp_RayPass, knownCovariancesAdd)
{
    cv::RNG rng = testRng();
    const Scene scene = exactScene(rng, surroundingPoints(rng, 20));
    const Matrix3d P = randomNoise(rng, 0.3), B = randomNoise(rng, 0.1);
    cv::Mat_<double> rowsP(20, 9), rowsB(20, 9);
    for (int i = 0; i < 20; ++i)
        for (int k = 0; k < 9; ++k)
            rowsP(i, k) = P(k / 3, k % 3), rowsB(i, k) = B(k / 3, k % 3);
    const Correspondences without(scene.objectPoints, scene.rays),
        with(Observations{scene.objectPoints, scene.rays, rowsP, rowsB});
    const Pose pose{randomRotation(rng), gaussian3(rng)};
    const Noise some{randomNoise(rng, 0.2), randomNoise(rng, 0.05), {0.1}};
    const double unit = 1 / (with.scale * with.scale);
    expectSameSums(rayPass(with, pose, some),
                   rayPass(without, pose, {some.Sigma + unit * P, some.Gamma + B, some.tails}));
}

// A Gamma that differs from ray to ray by the squares of angular scales is the same as covariances known of each ray.
TEST(Gmlpnp_RayPass, angularScalesScaleGamma)
{
    constexpr int N = 21;
    cv::RNG rng = testRng();
    const Scene scene = exactScene(rng, surroundingPoints(rng, N));
    const Pose pose{randomRotation(rng), gaussian3(rng)};
    const Noise noise{randomNoise(rng, 0.2), randomNoise(rng, 0.05), {0.1}};
    cv::Mat_<double> rays = scene.rays.clone(), covariances(N, 9), known(N, 9);
    double logScales = 0;
    for (int i = 0; i < N; ++i) {
        const double scale = rng.uniform(0.2, 1.5);
        rays.row(i) *= scale;
        logScales += std::log(scale);
        const Matrix3d B = randomNoise(rng, 0.1);
        for (int k = 0; k < 9; ++k) {
            known(i, k) = B(k / 3, k % 3);
            covariances(i, k) = scale * scale * noise.Gamma(k / 3, k % 3) + known(i, k);
        }
    }
    const Correspondences scaled(Observations{scene.objectPoints, rays, {}, known, true});
    const Correspondences apart(Observations{scene.objectPoints, scene.rays, {}, covariances});
    EXPECT_NEAR(logScales, scaled.logAngularScales(), 1e-12);
    EXPECT_EQ(0, apart.logAngularScales());
    const RaySums a = rayPass(scaled, pose, noise);
    const RaySums b = rayPass(apart, pose, {noise.Sigma, Matrix3d::Zero(), noise.tails});
    EXPECT_TRUE(matrixNear(a.H, b.H, 1e-11 * b.H.norm()));
    EXPECT_TRUE(matrixNear(a.g, b.g, 1e-11 * b.g.norm()));
    EXPECT_TRUE(matrixNear(a.Zo, b.Zo, 1e-11 * b.Zo.norm()));
    EXPECT_TRUE(matrixNear(a.Go, b.Go, 1e-11 * b.Go.norm()));
    EXPECT_NEAR(a.misfit, b.misfit, 1e-11 * b.misfit);
    EXPECT_NEAR(a.L - logScales, b.L, 1e-10);
}

TEST(Gmlpnp_RayPass, countsPointsInFront)
{
    cv::RNG rng = testRng();
    const Scene scene = exactScene(rng, surroundingPoints(rng, 25));
    const Correspondences data(scene.objectPoints, scene.rays);
    Pose pose = data.fromObject(scene.truth);
    const Noise noise{Matrix3d::Identity(), Matrix3d::Zero(), {}};
    EXPECT_EQ(25, rayPass(data, pose, noise).inFront);
    const Correspondences opposite(scene.objectPoints, cv::Mat_<double>(cv::Mat(-scene.rays)));
    EXPECT_EQ(0, rayPass(opposite, pose, noise).inFront);
}

}  // namespace
}  // namespace opencv_test
