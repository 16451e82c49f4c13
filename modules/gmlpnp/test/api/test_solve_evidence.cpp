// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../scenes.hpp"
#include "../statistics.hpp"

namespace opencv_test {
namespace {

using cv::gmlpnp::Params;
using cv::gmlpnp::Result;

struct Cell
{
    int n;
    bool known;

    std::string name() const { return cv::format("%dPointsNoise%s", n, known ? "Known" : "Estimated"); }
    friend void PrintTo(const Cell& cell, std::ostream* out) { *out << cell.name(); }
};

class Gmlpnp_PoseEvidenceStatistics : public testing::TestWithParam<Cell>
{};

// A small flat object whose half side is a thirtieth or a sixtieth of its distance, seen with half a pixel of noise.
Scene ambiguousScene(cv::RNG& rng, int n)
{
    const Matrix3d R = randomRotation(rng);
    std::vector<Vector3d> points;
    for (int i = 0; i < n; ++i)
        points.emplace_back(R * Vector3d(rng.uniform(-1., 1.), rng.uniform(-1., 1.), 0) +
                            Vector3d(0, 0, n < 50 ? 30 : 60));
    Scene scene = exactScene(rng, points);
    for (double& coordinate : scene.imagePoints)
        coordinate += rng.gaussian(0.5);
    return scene;
}

// The data hardly decide between two poses, and poseEvidence says how surely. If it is true, the other one is right in
// a share of  1 / (1 + e^evidence).
TEST_P(Gmlpnp_PoseEvidenceStatistics, tellsHowOftenTheOtherMinimumIsRight)
{
    cv::RNG rng = testRng();
    Params params;
    if (GetParam().known) {
        params.objectNoise = cv::Mat::zeros(3, 3, CV_64F);
        params.bearingNoise = cv::Mat::diag(cv::Mat(cv::Vec3d(1, 1, 0))) * (0.25 / 640000);
    }
    const auto camera = cv::gmlpnp::CameraModel::pinhole(paperCamera());
    int wrong = 0;
    double expected = 0, variance = 0;
    for (int k = 0; k < 300; ++k) {
        const Scene scene = ambiguousScene(rng, GetParam().n);
        Result result;
        std::vector<Result> all;
        if (!cv::gmlpnp::solve(scene.objectPoints, scene.imagePoints, camera, result, params))
            continue;
        cv::gmlpnp::solveAll(scene.objectPoints, scene.imagePoints, camera, all, params);
        const auto error = [&](const Result& r) { return rotationAngle(poseOf(r).R, scene.truth.R); };
        wrong += std::any_of(all.begin(), all.end(),
                             [&](const Result& other) { return error(other) < error(result) - 0.1; });
        const double share = 1 / (1 + std::exp(result.poseEvidence));
        expected += share;
        variance += share * (1 - share);
    }
    // Six points have little left to tell their noise by, and its shape is fitted to that.
    const double allowed = GetParam().known ? 0 : 0.1 * wrong;
    EXPECT_TRUE(within(wrong, expected - allowed, expected + allowed, std::sqrt(variance)));
}

std::vector<Cell> cells()
{
    std::vector<Cell> all;
    for (const int n : {4, 6, 12, 50})
        for (const bool known : {true, false})
            all.push_back({n, known});
    return all;
}

INSTANTIATE_TEST_SUITE_P(/**/, Gmlpnp_PoseEvidenceStatistics, testing::ValuesIn(cells()), nameOf<Cell>);

}  // namespace
}  // namespace opencv_test
