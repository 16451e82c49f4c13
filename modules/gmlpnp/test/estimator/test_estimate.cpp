// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../statistics.hpp"
#include "started.hpp"

// The alternation between pose and noise.

namespace opencv_test {
namespace {

using namespace started;

TEST(Gmlpnp_Estimate, publishedCovarianceCollapsesAndIsFinite)
{
    cv::RNG rng = testRng();
    for (int rounds : {1, 5, 30}) {
        const Problem p = problem(paperScene(rng, 50, 0.1, 1));
        const Estimate found = fitPublished(Subsets(p.data), p.start, {}, {}, {{rounds, 0}});
        EXPECT_EQ(rounds, found.rounds);
        EXPECT_TRUE(found.noise.Sigma.allFinite());
        EXPECT_TRUE(found.sums.H.allFinite());
        EXPECT_EQ(rounds == 1 ? 3 : 2, rank(found.noise.Sigma, 1e-6)) << rounds << " rounds";
    }
}

TEST(Gmlpnp_Estimate, knownNoiseEndsAtTheMinimum)
{
    cv::RNG rng = testRng();
    for (int k = 0; k < 20; ++k) {
        const Scene scene = paperScene(rng, 30, 0.2, 1);
        const Problem p = problem(scene);
        const Matrix3d Sigma = scene.Sigma / (p.data.scale * p.data.scale);
        const Estimate found = fitPublished(Subsets(p.data), p.start, Sigma, {}, {defaultLimits(false)});
        EXPECT_TRUE(found.converged);
        // A minimum: the gradient is small against its own spread, which is H.
        EXPECT_LT(found.sums.g.dot(found.sums.H.ldlt().solve(found.sums.g)), 1e-4);
    }
}

// A step that no halving makes fall ends the alternation; it is a minimum only where it promised nothing.
TEST(Gmlpnp_EstimateStatistics, aStepThatGoesWrongIsNoConvergence)
{
    cv::RNG rng = testRng();
    constexpr int N = 20;
    int misled = 0;
    for (int k = 0; k < 200; ++k) {
        const Scene scene = bearingScene(rng, N, 5);
        cv::Mat_<double> known(N, 9, 0.);
        for (int i = 0; i < N; ++i)
            for (int axis = 0; axis < 3; ++axis)
                known(i, 4 * axis) = (i == 0 ? 1e-12 : 1) * 25. / 640000;
        const Correspondences data(Observations{scene.objectPoints, scene.rays, {}, known});
        const Noise noise = isotropic(1e-24, 0);
        const FitOptions options{defaultLimits(false)};
        const Estimate found = alternate(data, initialPoses(data).at(0).pose, {noise, NoiseKind::FIXED}, options);
        const Estimate fromTruth = alternate(data, data.fromObject(scene.truth), {noise, NoiseKind::FIXED}, options);
        if (found.sums.L > fromTruth.sums.L + 1e3) {
            misled++;
            EXPECT_FALSE(found.converged) << k;
        }
    }
    EXPECT_GT(misled, 5) << "too few steps go wrong: the test tests nothing";
}

TEST(Gmlpnp_Estimate, zeroToleranceRunsAllRounds)
{
    cv::RNG rng = testRng();
    const Problem p = problem(paperScene(rng, 60, 0.1, 1));
    const Noise start{1e-3 * Matrix3d::Identity(), Matrix3d::Zero(), {}};
    EXPECT_EQ(13, alternate(p.data, p.start, {start, NoiseKind::OBJECT}, {{13, 0}}).rounds);
    EXPECT_LT(alternate(p.data, p.start, {start, NoiseKind::OBJECT}, {{100, 1}}).rounds, 13);
}

// A start far away: each step that does not fall is halved, so the isotropic cost comes down in the end, from every
// one.
TEST(Gmlpnp_EstimateStatistics, isotropicPoseConvergesFromAfar)
{
    cv::RNG rng = testRng();
    for (int k = 0; k < 100; ++k) {
        const Scene scene = exactScene(rng, boxPoints(rng, 20));
        const Correspondences data(scene.objectPoints, scene.rays);
        Vector6d off;
        off << 0.5 * gaussian3(rng).normalized(), gaussian3(rng).normalized();
        const Pose found = isotropicPose(data, perturbed(data.fromObject(scene.truth), off));
        EXPECT_TRUE(poseNear(data.toObject(found), scene.truth, 1e-7, 1e-6)) << "start " << k;
    }
}

}  // namespace
}  // namespace opencv_test
