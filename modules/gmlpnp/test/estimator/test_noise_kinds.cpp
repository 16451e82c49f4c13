// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include <functional>

#include "../statistics.hpp"
#include "started.hpp"

// Which kinds of noise are fitted, which one is chosen, and that none leads astray.

namespace opencv_test {
namespace {

using namespace started;

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

class Gmlpnp_RunawayStatistics : public testing::TestWithParam<double>
{};

// Object noise as large as the object explains any rays, once the camera is inside it: L is least where no pose is.
// The promise is that none runs away, so a single one is a fault and no chance.
TEST_P(Gmlpnp_RunawayStatistics, doesNotRunAwayFromTheIsotropicPose)
{
    cv::RNG rng = testRng();
    const double noise = 0.0025, known = GetParam();  // rad; less than there is leaves the rest to object noise
    const KnownNoise Gamma = known > 0 ? KnownNoise(known * known * Matrix3d::Identity()) : KnownNoise();
    for (int k = 0; k < 300; ++k) {
        const Problem at = problem(farScene(rng, 150, noise));
        const Pose pose = fitMarginal(Subsets(at.data), at.start, {}, Gamma, {defaultLimits(false)}).pose;
        EXPECT_LT((pose.R - at.start.R).norm(), 0.3) << "problem " << k;
    }
}

INSTANTIATE_TEST_SUITE_P(/**/, Gmlpnp_RunawayStatistics, testing::Values(0., 0.001), nameOfNumber);

// Wrong points spoil the isotropic pose: the way from there to the truth is no running away.
TEST(Gmlpnp_EstimateStatistics, leavesAnIsotropicPoseThatWrongPointsSpoil)
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
    EXPECT_GT(spoilt, 5) << "too few isotropic poses are spoilt: the test tests nothing";
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

// What the data are made of, and in which share of problems another kind of noise may be chosen.
struct Made
{
    const char* of;
    double otherwise;
    std::function<Scene(cv::RNG&)> scene;
    std::function<bool(NoiseKind)> fits;

    std::string name() const { return of; }
    friend void PrintTo(const Made& cell, std::ostream* out) { *out << cell.name(); }
};

Scene mixedScene(cv::RNG& rng)
{
    Scene scene = bearingScene(rng, 100, 1);
    for (double& coordinate : scene.objectPoints)
        coordinate += rng.gaussian(0.002);
    return scene;
}

class Gmlpnp_NoiseKindStatistics : public testing::TestWithParam<Made>
{};

TEST_P(Gmlpnp_NoiseKindStatistics, choosesTheNoiseThatIsThere)
{
    constexpr int PROBLEMS = 200;
    cv::RNG rng = testRng();
    int others = 0;
    for (int k = 0; k < PROBLEMS; ++k) {
        const Problem at = problem(GetParam().scene(rng));
        others += !GetParam().fits(fitMarginal(Subsets(at.data), at.start, {}, {}, {defaultLimits(false)}).kind);
    }
    EXPECT_TRUE(shareAtMost(others, PROBLEMS, GetParam().otherwise));
}

const Made NOISES[] = {
    {"pixels", 0, [](cv::RNG& rng) { return bearingScene(rng, 100, 1); },
     [](NoiseKind kind) { return kind != NoiseKind::OBJECT; }},
    // At depths of 4 to 8 the likelihood itself prefers bearings in 1 of 100.
    {"object", 0.01, [](cv::RNG& rng) { return paperScene(rng, 200, 0.2, 0); },
     [](NoiseKind kind) { return kind != NoiseKind::BEARING; }},
    {"both", 0.01, mixedScene, [](NoiseKind kind) { return kind == NoiseKind::BOTH; }},
};

INSTANTIATE_TEST_SUITE_P(/**/, Gmlpnp_NoiseKindStatistics, testing::ValuesIn(NOISES), nameOf<Made>);

}  // namespace
}  // namespace opencv_test
