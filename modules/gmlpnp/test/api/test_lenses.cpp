// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../test_data.hpp"
#include "wide_lens.hpp"

// The solver behind every lens: it must see rays, whatever the pixels were.

namespace opencv_test {
namespace {

using namespace wide;
using gmlpnp::Result;

class Gmlpnp_SolveWideLens : public testing::TestWithParam<WideLens>
{};

// 220 degrees: one third of the pixels is behind the image plane.
TEST_P(Gmlpnp_SolveWideLens, equalsSolveRaysOnRaysComputedApart)
{
    const WideLens& lens = GetParam();
    cv::RNG rng = testRng();
    for (int method : {gmlpnp::SOLVEPNP_GMLPNP, gmlpnp::SOLVEPNP_GMLPNP_MARGINAL}) {
        const WideScene scene = wideScene(rng, lens, 120);
        ASSERT_GT(scene.behind, 20);
        gmlpnp::Params params;
        params.method = method;
        Result byPixels, byRays;
        ASSERT_TRUE(gmlpnp::solve(scene.points, scene.pixels, makePtr<PlainLens>(lens.camera), byPixels, params));
        ASSERT_TRUE(gmlpnp::solveRays(scene.points, scene.rays, byRays, params));
        EXPECT_EQ(scene.points.rows, byPixels.usedPoints);
        EXPECT_EQ(byRays.status, byPixels.status);
        EXPECT_TRUE(poseNear(byPixels, poseOf(byRays), 1e-9, 1e-9));
        EXPECT_TRUE(matrixNear(matrix3(byPixels.objectNoise), matrix3(byRays.objectNoise), 1e-9));
        EXPECT_TRUE(matrixNear(matrix3(byPixels.bearingNoise), matrix3(byRays.bearingNoise), 1e-9));
        EXPECT_TRUE(matrixNear(matrix6(byPixels.poseCovariance), matrix6(byRays.poseCovariance), 1e-9));
        // And the lens itself finds the right pose: 1 px is 8 mrad at most, over the root of 120 points and with the
        // translation free.
        ASSERT_TRUE(gmlpnp::solve(scene.points, scene.pixels, lens.camera, byPixels, params));
        EXPECT_TRUE(poseNear(byPixels, scene.truth, 6e-3, 2e-2));
    }
}

INSTANTIATE_TEST_SUITE_P(Lenses, Gmlpnp_SolveWideLens, testing::Values(wideFisheye(), wideOmnidir(), wideEucm()));

// Real pixels of a real catadioptric camera. The calibration minimises the sum of squared pixel errors, so nothing can
// be below it by much. The estimated noise weighs the pixels otherwise, tails more so; that must cost little.
TEST(Gmlpnp_SolveLenses, chessboardsOfAnOmnidirectionalCamera)
{
    const BoardCalibration boards = omnidirChessboard();
    if (boards.views.empty())
        GMLPNP_SKIP(kNoData);
    for (const bool robust : {false, true}) {
        gmlpnp::Params params;
        params.robust = robust;
        double ours = 0, calibrated = 0;
        for (size_t i = 0; i < boards.views.size(); ++i) {
            SCOPED_TRACE(testing::Message() << "view " << i << (robust ? " robust" : ""));
            const BoardView& view = boards.views[i];
            Result result;
            ASSERT_TRUE(gmlpnp::solve(view.corners, view.pixels, boards.camera, result, params));
            EXPECT_EQ(view.corners.rows, result.usedPoints);
            const double here = squaredPixelErrors(*boards.camera, view, result.rvec, result.tvec);
            const double there = squaredPixelErrors(*boards.camera, view, view.rvec, view.tvec);
            EXPECT_NEAR(std::sqrt(here / there), 1, robust ? 0.06 : 0.02);
            ours += here;
            calibrated += there;
        }
        EXPECT_NEAR(std::sqrt(ours / calibrated), 1, 0.02);  // all 810 corners
    }
}

}  // namespace
}  // namespace opencv_test
