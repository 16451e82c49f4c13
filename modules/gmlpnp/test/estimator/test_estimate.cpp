// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../../src/estimator/initial_pose.hpp"
#include "../../src/estimator/kinds_of_noise.hpp"
#include "../scenes.hpp"

namespace opencv_test {
namespace {

using namespace cv::gmlpnp::detail;

struct Problem
{
    Correspondences data;
    Pose start;
};

Problem problem(const Scene& scene)
{
    const Correspondences data(scene.objectPoints, scene.rays);
    return {data, initialPoses(data).at(0).pose};
}

// Pixels of a flat-on object of +-30 px, or of depth 0.5 to 5 m, or object noise: what the data are made of is chosen.
Scene bearingScene(cv::RNG& rng, int n, double pixels)
{
    std::vector<Vector3d> points(n);
    for (Vector3d& X : points) {
        const double z = 0.5 * std::pow(10., rng.uniform(0., 1.));
        X = z * Vector3d(rng.uniform(-1., 1.), rng.uniform(-1., 1.), 1);
    }
    Scene scene = exactScene(rng, points);
    for (int i = 0; i < n; ++i) {
        scene.imagePoints(i, 0) += rng.gaussian(pixels);
        scene.imagePoints(i, 1) += rng.gaussian(pixels);
        const Vector3d m((scene.imagePoints(i, 0) - 320) / 800, (scene.imagePoints(i, 1) - 240) / 800, 1);
        for (int k = 0; k < 3; ++k)
            scene.rays(i, k) = m(k) / m.norm();
    }
    return scene;
}

// Rays, in radians, to a cube 75 times its side away.
Scene farScene(cv::RNG& rng, int n, double noise)
{
    std::vector<Vector3d> points(n);
    for (Vector3d& X : points)
        X = Vector3d(rng.uniform(-1., 1.), rng.uniform(-1., 1.), rng.uniform(-1., 1.)) + Vector3d(0, 0, 150);
    Scene scene = exactScene(rng, points);
    for (int i = 0; i < n; ++i)
        for (int a = 0; a < 2; ++a)
            scene.rays(i, a) += rng.gaussian(noise);
    return scene;
}

// A small object with much noise: the kinds of noise may end in minima far apart, and the mean of two poses is then
// none. What comes out is about as likely as one of the fits it is made of.
TEST(Gmlpnp_Estimate, farMinimaAreNotAveraged)
{
    cv::RNG rng = testRng();
    const FitOptions options{defaultLimits(false)};
    for (int k = 0; k < 200; ++k) {
        const int n = 20 + k;
        const Scene scene = farScene(rng, n, 0.0025);
        const Problem at = problem(scene);
        const IsotropicSplit split = splitResiduals(at.data, at.start);
        const auto costOf = [&](NoiseKind kind, const IsotropicNoise& noise, double b) {
            const Noise start{noise.a * Matrix3d::Identity(), b * Matrix3d::Identity(), {}};
            return alternate(at.data, at.start, {start, kind}, options).sums.L;
        };
        const double worst = std::max({costOf(NoiseKind::OBJECT, split.object, 0),
                                       costOf(NoiseKind::BEARING, split.bearing, split.bearing.b),
                                       costOf(NoiseKind::BOTH, split.both, split.both.b)});
        const Estimate found = fitMarginal(Subsets(at.data), at.start, {}, {}, options);
        EXPECT_LE(found.sums.L, worst + std::max(5., 0.05 * n)) << "problem " << k;
    }
}

// Object noise as large as the object explains any rays, once the camera is inside it: L is least where no pose is.
TEST(Gmlpnp_Estimate, doesNotRunAwayFromTheIsotropicPose)
{
    cv::RNG rng = testRng();
    const double noise = 0.0025, known = 0.001;  // rad; less than there is leaves the rest to object noise
    int near = 0, nearWithKnown = 0;
    for (int k = 0; k < 300; ++k) {
        const Problem at = problem(farScene(rng, 150, noise));
        const auto staysNear = [&](const KnownNoise& Gamma) {
            const Pose pose = fitMarginal(Subsets(at.data), at.start, {}, Gamma, {defaultLimits(false)}).pose;
            return (pose.R - at.start.R).norm() < 0.3;
        };
        near += staysNear({});
        nearWithKnown += staysNear(known * known * Matrix3d::Identity());
    }
    EXPECT_EQ(300, near);
    EXPECT_EQ(300, nearWithKnown);
}

// Wrong points spoil the isotropic pose: the way from there to the truth is no running away.
TEST(Gmlpnp_Estimate, leavesAnIsotropicPoseThatWrongPointsSpoil)
{
    cv::RNG rng = testRng();
    FitOptions options{defaultLimits(false)};
    options.tails = true;
    int spoilt = 0;
    for (int k = 0; k < 100; ++k) {
        Scene scene = paperScene(rng, 60, 0.02, 0);
        for (int i = 0; i < 6; ++i)
            for (int a = 0; a < 3; ++a)
                scene.objectPoints(i, a) += rng.gaussian(3);
        const Problem at = problem(scene);
        const Pose truth = at.data.fromObject(scene.truth);
        if (rotationAngle(at.start.R, truth.R) < 0.3)
            continue;
        spoilt++;
        const Pose pose = fitMarginal(Subsets(at.data), at.start, {}, {}, options).pose;
        EXPECT_LT(rotationAngle(pose.R, truth.R), 0.05) << k;
    }
    EXPECT_GT(spoilt, 5);
}

// It is a sum of squares. Found by libFuzzer, where nonsense had led the camera 1e60 object sizes away: rounding of the
// difference of squares that it had been was a variance of -1e103. Here all kinds of noise end where they start.
TEST(Gmlpnp_Estimate, theSpreadOfFarPosesIsNotNegative)
{
    cv::RNG rng = testRng();
    FitOptions options{defaultLimits(false)};
    options.limits.rounds = 0;
    for (int k = 0; k < 300; ++k) {
        Problem at = problem(paperScene(rng, 30, 0.02, 0));
        at.start.t *= std::exp(rng.uniform(0., 100.));
        EXPECT_GE(fitMarginal(Subsets(at.data), at.start, {}, {}, options).spread.diagonal().minCoeff(), 0);
    }
}

TEST(Gmlpnp_Estimate, choosesTheNoiseThatIsThere)
{
    cv::RNG rng = testRng();
    int bearing = 0, object = 0, both = 0;
    for (int k = 0; k < 40; ++k) {
        const Problem pixels = problem(bearingScene(rng, 100, 1));
        bearing +=
            fitMarginal(Subsets(pixels.data), pixels.start, {}, {}, {defaultLimits(false)}).kind != NoiseKind::OBJECT;
        const Problem points = problem(paperScene(rng, 200, 0.2, 0));
        object +=
            fitMarginal(Subsets(points.data), points.start, {}, {}, {defaultLimits(false)}).kind != NoiseKind::BEARING;
        Scene mixed = bearingScene(rng, 100, 1);
        for (int i = 0; i < 100; ++i)
            for (int a = 0; a < 3; ++a)
                mixed.objectPoints(i, a) += rng.gaussian(0.002);
        const Problem mix = problem(mixed);
        both += fitMarginal(Subsets(mix.data), mix.start, {}, {}, {defaultLimits(false)}).kind == NoiseKind::BOTH;
    }
    EXPECT_EQ(40, bearing);
    EXPECT_GE(object, 37);  // at depths of 4 to 8 the likelihood itself prefers bearings in 1 of 100
    EXPECT_GE(both, 36);
}

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
TEST(Gmlpnp_Estimate, aStepThatGoesWrongIsNoConvergence)
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
    EXPECT_GT(misled, 5) << "the test tests nothing";
}

TEST(Gmlpnp_Estimate, zeroToleranceRunsAllRounds)
{
    cv::RNG rng = testRng();
    const Problem p = problem(paperScene(rng, 60, 0.1, 1));
    const Noise start{1e-3 * Matrix3d::Identity(), Matrix3d::Zero(), {}};
    EXPECT_EQ(13, alternate(p.data, p.start, {start, NoiseKind::OBJECT}, {{13, 0}}).rounds);
    EXPECT_LT(alternate(p.data, p.start, {start, NoiseKind::OBJECT}, {{100, 1}}).rounds, 13);
}

// A start far away: each step that does not fall is halved, so the isotropic cost comes down in the end.
TEST(Gmlpnp_Estimate, isotropicPoseConvergesFromAfar)
{
    cv::RNG rng = testRng();
    int converged = 0;
    for (int k = 0; k < 100; ++k) {
        const Scene scene = exactScene(rng, boxPoints(rng, 20));
        const Correspondences data(scene.objectPoints, scene.rays);
        Vector6d off;
        off << 0.5 * gaussian3(rng).normalized(), gaussian3(rng).normalized();
        const Pose found = isotropicPose(data, perturbed(data.fromObject(scene.truth), off));
        converged += bool(poseNear(data.toObject(found), scene.truth, 1e-7, 1e-6));
    }
    EXPECT_EQ(100, converged);
}

}  // namespace
}  // namespace opencv_test
