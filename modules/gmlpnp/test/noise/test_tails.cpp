// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../../src/noise/tails.hpp"
#include "../scenes.hpp"
#include "../statistics.hpp"

namespace opencv_test {
namespace {

using namespace cv::gmlpnp::detail;

// Squared residuals of the default tails.
std::vector<double> drawn(cv::RNG& rng, int n, double share)
{
    const Tails tails{share};
    std::vector<double> c(n);
    for (double& entry : c) {
        const double chance = rng.uniform(1e-300, 1.);
        entry = rng.uniform(0., 1.) < share ? tails.dof * tails.spread2 * (std::pow(chance, -2. / tails.dof) - 1)
                                            : -2 * std::log(chance);
    }
    return c;
}

RaySums sumsOf(const std::vector<double>& c)
{
    RaySums sums;
    sums.c = sums.c2 = 0;
    for (double entry : c) {
        sums.c += entry;
        sums.c2 += entry * entry;
    }
    return sums;
}

TEST(Gmlpnp_Tails, densityAndWeightBelongTogether)
{
    for (const Tails& tails : {Tails{}, Tails{0.1}, Tails{0.3, 9, 3}, Tails{1, 1, 5}}) {
        double mass = 0;
        constexpr int STEPS = 10000;
        for (int k = 0; k < STEPS; ++k) {
            const double u = (k + 0.5) / STEPS;  // c = (1 - u) / u
            mass += tailTerms(tails, (1 - u) / u).g / 2 / (u * u) / STEPS;
        }
        EXPECT_NEAR(mass, 1, 1e-5);
        for (double c : {0.1, 2., 30.}) {
            const double h = 1e-5 * c;
            const double slope = std::log(tailTerms(tails, c + h).g / tailTerms(tails, c - h).g) / (2 * h);
            EXPECT_NEAR(tailTerms(tails, c).w, -2 * slope, 1e-8);
        }
    }
    EXPECT_NEAR(tailTerms({1, 1, 5}, 3).w, 7. / 8, 1e-12);  // (nu + 2) / (nu + c)
    EXPECT_EQ(tailTerms({}, 1e5).w, 1);
    EXPECT_LT(tailTerms({0.1}, 1e200).w, 1e-190);
}

TEST(Gmlpnp_Tails, informationIsThatOfTheDensity)
{
    for (int nu : {2, 3, 10}) {
        const TailInformation at = tailInformation({1, 1, nu});
        EXPECT_NEAR(at.pose, (nu + 2.) / (nu + 4), 1e-9);
        EXPECT_NEAR(at.noise, (nu + 2.) / (nu + 4), 1e-9);
    }
    EXPECT_EQ(tailInformation({}).pose, 1);
}

class Gmlpnp_TailsStatistics : public testing::TestWithParam<double>
{};

TEST_P(Gmlpnp_TailsStatistics, informationIsThatOfTheDraws)
{
    const Tails tails{GetParam()};
    cv::RNG rng = testRng();
    RatioOfMeans pose;
    Mean noise;
    for (const double c : drawn(rng, 1000000, tails.share)) {
        const double w = tailTerms(tails, c).w;
        pose.add(w * w * c / 2, w);
        noise.add(w * w * c * c / 8);
    }
    EXPECT_TRUE(withinSigma(pose.value(), tailInformation(tails).pose, pose.deviation()));
    EXPECT_TRUE(withinSigma(noise.value(), tailInformation(tails).noise, noise.deviation()));
}

// In turn with the noise, from that of a Gaussian with the same mean square, which is too large for most points. The
// share is a mean over steps of 2^(1/4), so with many points it may come out one step off, and the noise with it.
TEST_P(Gmlpnp_TailsStatistics, findsTheShareAndTheNoiseOfTheOthers)
{
    constexpr int N = 20000;
    const double share = GetParam();
    cv::RNG rng = testRng();
    const std::vector<double> c = drawn(rng, N, share);
    Noise noise{sumsOf(c).c / (2 * N) * Matrix3d::Identity(), Matrix3d::Identity(), {}};
    TailSearch search(false, N);
    for (int k = 0; k < 20; ++k) {
        std::vector<double> now = c;
        double wc = 0;
        for (double& entry : now) {
            entry /= noise.Sigma(0, 0);
            wc += entry * tailTerms(noise.tails, entry).w;
        }
        noise.Sigma *= wc / (2 * N);
        search.update(noise, now.data(), sumsOf(now));
    }
    constexpr double ONE_STEP = 0.19, ITS_NOISE = 0.06;
    EXPECT_NEAR(noise.tails.share, share, ONE_STEP * share);
    EXPECT_NEAR(noise.Sigma(0, 0), 1, ITS_NOISE);
    Noise known{Matrix3d::Identity(), Matrix3d::Identity(), {}};
    TailSearch(true, N).update(known, c.data(), sumsOf(c));
    EXPECT_NEAR(known.tails.share, share, ONE_STEP * share);
    EXPECT_EQ(known.Sigma, Matrix3d::Identity());
}

TEST(Gmlpnp_Tails, exactDataHaveNone)
{
    cv::RNG rng = testRng();
    for (int n : {8, 20, 50, 300}) {
        const Scene scene = exactScene(rng, surroundingPoints(rng, n));
        cv::gmlpnp::Result result;
        ASSERT_TRUE(cv::gmlpnp::solveRays(scene.objectPoints, scene.rays, result));
        EXPECT_EQ(result.tailShare, 0) << n;
        EXPECT_EQ(result.status, cv::gmlpnp::STATUS_CONVERGED) << n;
    }
}

TEST(Gmlpnp_Tails, noneIsAGaussian)
{
    EXPECT_EQ(nearestStudentT({}), std::numeric_limits<double>::infinity());
}

// Minus the logarithm of the likelihood of a Student-t, its scale fitted.
double studentCost(const std::vector<double>& c, double nu)
{
    double scale = 1, sum = 0;
    for (int k = 0; k < 20; ++k) {
        double w = 0, wc = 0;
        for (double entry : c) {
            const double wi = 1 / (nu + entry / scale);
            w += wi, wc += wi * entry;
        }
        scale = 0.5 * wc / w;
    }
    for (double entry : c)
        sum += std::log(scale) + (nu / 2 + 1) * std::log1p(entry / (nu * scale));
    return sum;
}

// The divergence to a Student-t of more or fewer degrees of freedom is larger.
TEST_P(Gmlpnp_TailsStatistics, theNearestStudentTIsNear)
{
    const double share = GetParam();
    if (share == 0)
        return;
    cv::RNG rng = testRng();
    const std::vector<double> c = drawn(rng, 100000, share);
    const double nu = nearestStudentT({share});
    EXPECT_LT(studentCost(c, nu), studentCost(c, 1.2 * nu));
    EXPECT_LT(studentCost(c, nu), studentCost(c, nu / 1.2));
}

INSTANTIATE_TEST_SUITE_P(/**/, Gmlpnp_TailsStatistics, testing::Values(0., 0.05, 0.1, 0.15, 0.2, 0.3, 0.4),
                         nameOfNumber);

// Before the first round the noise is isotropic, and only tails that cannot be its shape may count.
TEST(Gmlpnp_WildTailsStatistics, noShapeOfTheNoiseIsWild)
{
    constexpr int N = 100, TRIALS = 100;
    cv::RNG rng = testRng();
    int wild = 0;
    for (int k = 0; k < TRIALS; ++k) {
        std::vector<double> c(N);
        for (double& entry : c) {
            const double inOneDirection = rng.gaussian(std::sqrt(2.));
            entry = inOneDirection * inOneDirection;
        }
        wild += TailSearch(false, N).areWild(sumsOf(c));
        c[0] = 4 * N;  // as far as one point takes the scale along
        EXPECT_TRUE(TailSearch(false, N).areWild(sumsOf(c)));
        EXPECT_FALSE(TailSearch(true, N).areWild(sumsOf(c)));
    }
    EXPECT_TRUE(shareAtMost(wild, TRIALS, 0.003));
}

}  // namespace
}  // namespace opencv_test
