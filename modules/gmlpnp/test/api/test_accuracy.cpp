// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../scenes.hpp"
#include "../statistics.hpp"

// Accuracy on the paper's protocol: ratios of mean errors to cv::SOLVEPNP_SQPNP on the same problems. The figures to
// reach were measured with the prototypes of the two estimators.

namespace opencv_test {
namespace {

constexpr int PROBLEMS = 10000;
constexpr int FIGURE_PROBLEMS = 5000;  // the figures are themselves means over so many, with other seeds

struct Figures
{
    int method, n;
    double rotation, translation;  // ratios to reach

    std::string name() const { return methodName(method) + cv::format("%dPoints", n); }
    friend void PrintTo(const Figures& cell, std::ostream* out) { *out << cell.name(); }
};

class Gmlpnp_AccuracyStatistics : public testing::TestWithParam<Figures>
{};

struct Errors
{
    double rotation, translation;
};

Errors errorsOf(const Scene& scene, int method)
{
    cv::Vec3d rvec, tvec;
    EXPECT_TRUE(cv::gmlpnp::solvePnP(scene.objectPoints, scene.imagePoints, paperCamera(), cv::noArray(), rvec, tvec,
                                     false, method));
    const Pose pose = poseOf(rvec, tvec);
    return {columnAngle(pose.R, scene.truth.R), (pose.t - scene.truth.t).norm() / scene.truth.t.norm()};
}

// The figure lies in the interval of the difference, or we are better.
testing::AssertionResult reaches(const RatioOfMeans& ratio, double figure)
{
    // Eight figures are compared, so each gets the interval with which all eight hold in 95 % of cases (Bonferroni).
    constexpr double QUANTILE = 2.73;
    return atMost(ratio.value(), figure, ratio.deviation() * std::sqrt(1 + double(PROBLEMS) / FIGURE_PROBLEMS),
                  QUANTILE);
}

TEST_P(Gmlpnp_AccuracyStatistics, reachesTheFiguresOfThePrototype)
{
    cv::RNG rng = testRng();
    RatioOfMeans rotation, translation;
    for (int k = 0; k < PROBLEMS; ++k) {
        const Scene scene = paperScene(rng, GetParam().n, 0.1, 1);
        const Errors ours = errorsOf(scene, GetParam().method), sqpnp = errorsOf(scene, cv::gmlpnp::SOLVEPNP_SQPNP);
        rotation.add(ours.rotation, sqpnp.rotation);
        translation.add(ours.translation, sqpnp.translation);
    }
    EXPECT_TRUE(reaches(rotation, GetParam().rotation)) << "rotation";
    EXPECT_TRUE(reaches(translation, GetParam().translation)) << "translation";
}

INSTANTIATE_TEST_SUITE_P(/**/, Gmlpnp_AccuracyStatistics,
                         testing::Values(Figures{cv::gmlpnp::SOLVEPNP_GMLPNP, 50, .936, .873},
                                         Figures{cv::gmlpnp::SOLVEPNP_GMLPNP_MARGINAL, 50, .931, .876},
                                         Figures{cv::gmlpnp::SOLVEPNP_GMLPNP, 200, .923, .882},
                                         Figures{cv::gmlpnp::SOLVEPNP_GMLPNP_MARGINAL, 200, .909, .873}),
                         nameOf<Figures>);

}  // namespace
}  // namespace opencv_test
