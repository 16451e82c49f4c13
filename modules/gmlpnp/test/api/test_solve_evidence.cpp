// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../scenes.hpp"

namespace opencv_test {
namespace {

using cv::gmlpnp::Params;
using cv::gmlpnp::Result;

// Small and flat, thirty or sixty of its half sides away: the data hardly decide between two poses, and poseEvidence
// says how surely. If it is true, the other one is right in a share of  1 / (1 + e^evidence).
TEST(Gmlpnp_Solve, poseEvidenceTellsHowOftenTheOtherMinimumIsRight)
{
    cv::RNG rng = testRng();
    constexpr int PROBLEMS = 300;
    for (const int n : {4, 6, 12, 50})
        for (const bool known : {true, false}) {
            int wrong = 0;
            double expected = 0, variance = 0;
            for (int k = 0; k < PROBLEMS; ++k) {
                const Matrix3d R = randomRotation(rng);
                std::vector<Vector3d> points;
                for (int i = 0; i < n; ++i)
                    points.emplace_back(R * Vector3d(rng.uniform(-1., 1.), rng.uniform(-1., 1.), 0) +
                                        Vector3d(0, 0, n < 50 ? 30 : 60));
                Scene scene = exactScene(rng, points);
                for (double& coordinate : scene.imagePoints)
                    coordinate += rng.gaussian(0.5);
                Params params;
                if (known) {
                    params.objectNoise = cv::Mat::zeros(3, 3, CV_64F);
                    params.bearingNoise = cv::Mat::diag(cv::Mat(cv::Vec3d(1, 1, 0))) * (0.25 / 640000);
                }
                const auto camera = cv::gmlpnp::CameraModel::pinhole(paperCamera());
                Result result;
                std::vector<Result> all;
                if (!cv::gmlpnp::solve(scene.objectPoints, scene.imagePoints, camera, result, params))
                    continue;
                cv::gmlpnp::solveAll(scene.objectPoints, scene.imagePoints, camera, all, params);
                const auto error = [&](const Result& r) { return rotationAngle(poseOf(r).R, scene.truth.R); };
                const bool isWrong = std::any_of(
                    all.begin(), all.end(), [&](const Result& other) { return error(other) < error(result) - 0.1; });
                wrong += isWrong;
                const double share = 1 / (1 + std::exp(result.poseEvidence));
                expected += share;
                variance += share * (1 - share);
            }
            const double deviation = std::sqrt(variance);
            std::cout << n << " points, noise " << (known ? "known" : "estimated") << ": " << wrong << " wrong, "
                      << expected << " +- " << deviation << " expected" << std::endl;
            // Six points have little left to tell their noise by, and its shape is fitted to that.
            EXPECT_NEAR(expected, wrong, 4 * deviation + (known ? 0 : 0.1 * wrong));
        }
}

}  // namespace
}  // namespace opencv_test
