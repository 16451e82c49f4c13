// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../scenes.hpp"

// Accuracy on the paper's protocol: ratios of mean errors to cv::SOLVEPNP_SQPNP on the same problems, with bootstrap
// deviations. The figures to reach were measured with the prototypes of the two estimators.

namespace opencv_test {
namespace {

struct Errors
{
    std::vector<double> rotation, translation;
};

enum
{
    SQPNP,
    PUBLISHED,
    MARGINAL,
    METHOD_COUNT
};
constexpr int FLAGS[METHOD_COUNT] = {cv::gmlpnp::SOLVEPNP_SQPNP, cv::gmlpnp::SOLVEPNP_GMLPNP,
                                     cv::gmlpnp::SOLVEPNP_GMLPNP_MARGINAL};

std::array<Errors, METHOD_COUNT> run(cv::RNG& rng, int problems, int n)
{
    std::array<Errors, METHOD_COUNT> errors;
    for (int k = 0; k < problems; ++k) {
        const Scene scene = paperScene(rng, n, 0.1, 1);
        for (int method = 0; method < METHOD_COUNT; ++method) {
            cv::Vec3d rvec, tvec;
            EXPECT_TRUE(cv::gmlpnp::solvePnP(scene.objectPoints, scene.imagePoints, paperCamera(), cv::noArray(), rvec,
                                             tvec, false, FLAGS[method]));
            const Pose pose = poseOf(rvec, tvec);
            errors[method].rotation.push_back(columnAngle(pose.R, scene.truth.R));
            errors[method].translation.push_back((pose.t - scene.truth.t).norm() / scene.truth.t.norm());
        }
    }
    return errors;
}

constexpr int PROBLEMS = 10000;
constexpr int FIGURE_PROBLEMS = 5000;  // the figures are themselves means over so many, with other seeds

struct Ratio
{
    double value, deviation;
};

Ratio ratioOfMeans(const std::vector<double>& ours, const std::vector<double>& theirs)
{
    cv::RNG rng(20240519);
    const int n = static_cast<int>(ours.size()), resamples = 200;
    const auto ratio = [&](const auto& index) {
        double a = 0, b = 0;
        for (int k = 0; k < n; ++k) {
            const int i = index(k);
            a += ours[i];
            b += theirs[i];
        }
        return a / b;
    };
    const double value = ratio([](int k) { return k; });
    double square = 0;
    for (int k = 0; k < resamples; ++k) {
        const double off = ratio([&](int) { return rng.uniform(0, n); }) - value;
        square += off * off / resamples;
    }
    return {value, std::sqrt(square)};
}

// Eight figures are compared, so each gets the interval with which all eight hold in 95 % of cases (Bonferroni).
constexpr double QUANTILE = 2.73;

// The figure lies in the interval of the difference, or we are better.
void expectReaches(const char* what, const std::vector<double>& ours, const std::vector<double>& theirs, double figure)
{
    const Ratio ratio = ratioOfMeans(ours, theirs);
    const double deviation = ratio.deviation * std::sqrt(1 + double(PROBLEMS) / FIGURE_PROBLEMS);
    std::cout << what << ": " << ratio.value << " +- " << ratio.deviation << ", to reach " << figure << std::endl;
    EXPECT_LE(ratio.value - QUANTILE * deviation, figure) << what;
}

void compare(cv::RNG& rng, int n, const double (&published)[2], const double (&marginal)[2])
{
    const std::array<Errors, METHOD_COUNT> errors = run(rng, PROBLEMS, n);
    expectReaches("published rotation", errors[PUBLISHED].rotation, errors[SQPNP].rotation, published[0]);
    expectReaches("published translation", errors[PUBLISHED].translation, errors[SQPNP].translation, published[1]);
    expectReaches("marginal rotation", errors[MARGINAL].rotation, errors[SQPNP].rotation, marginal[0]);
    expectReaches("marginal translation", errors[MARGINAL].translation, errors[SQPNP].translation, marginal[1]);
}

TEST(Gmlpnp_Accuracy, fiftyPoints)
{
    cv::RNG rng = testRng();
    compare(rng, 50, {.936, .873}, {.931, .876});
}

TEST(Gmlpnp_Accuracy, twoHundredPoints)
{
    cv::RNG rng = testRng();
    compare(rng, 200, {.923, .882}, {.909, .873});
}

}  // namespace
}  // namespace opencv_test
