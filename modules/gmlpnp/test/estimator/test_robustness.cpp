// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../scenes.hpp"
#include "../statistics.hpp"

// Heavy tails: what they cost and what they save.

namespace opencv_test {
namespace {

using namespace cv::gmlpnp::detail;
using cv::gmlpnp::Params;
using cv::gmlpnp::Result;

// The first `count` points get five times the noise in all.
void contaminate(cv::RNG& rng, Scene& scene, int count)
{
    const Matrix3d root = Eigen3d(24 * scene.Sigma).operatorSqrt();
    for (int i = 0; i < count; ++i) {
        const Vector3d e = root * gaussian3(rng);
        for (int k = 0; k < 3; ++k)
            scene.objectPoints(i, k) += e(k);
    }
}

struct Contaminated
{
    int n, bad, scenes;
    double ratio;  // of the errors with tails to those without, at most

    std::string name() const { return cv::format("%dOf%dPoints", bad, n); }
    friend void PrintTo(const Contaminated& cell, std::ostream* out) { *out << cell.name(); }
};

class Gmlpnp_RobustStatistics : public testing::TestWithParam<Contaminated>
{};

// A Gaussian fitted to 20 points of which four are wild is so wide that none looks wild: the tails must show all the
// same.
TEST_P(Gmlpnp_RobustStatistics, tailsCostNothingOnGaussianDataAndSaveTheRest)
{
    const Contaminated& cell = GetParam();
    cv::RNG rng = testRng();
    RatioOfMeans ratio;
    int tails = 0;
    for (int k = 0; k < cell.scenes; ++k) {
        Scene scene = paperScene(rng, cell.n, 0.1, 1);
        contaminate(rng, scene, cell.bad);
        Params params;
        const Result withTails = solvedPixels(scene, params);
        params.robust = false;
        const Result without = solvedPixels(scene, params);
        EXPECT_TRUE(std::isinf(without.tailDof)) << "scene " << k;
        ratio.add(distance(withTails, scene), distance(without, scene));
        tails += std::isfinite(withTails.tailDof);
    }
    EXPECT_TRUE(atMost(ratio.value(), cell.ratio, ratio.deviation()));
    if (cell.n < 50)
        return;
    EXPECT_TRUE(cell.bad ? shareAtLeast(tails, cell.scenes, 0.87) : shareAtMost(tails, cell.scenes, 0.05));
}

INSTANTIATE_TEST_SUITE_P(/**/, Gmlpnp_RobustStatistics,
                         testing::Values(Contaminated{50, 0, 400, 1.00}, Contaminated{50, 5, 400, 0.75},
                                         Contaminated{20, 0, 1000, 1.01}, Contaminated{20, 4, 1000, 0.65}),
                         nameOf<Contaminated>);

// Pixels that are sharp in one direction and seen of a small object: the noise is all but singular, and scoring alone,
// which takes the expected curvature for the true one, ran away from it.
TEST(Gmlpnp_NoiseStatistics, isFoundWhereItIsAllButSingular)
{
    cv::RNG rng = testRng();
    const cv::Matx33d K = paperCamera();
    RatioOfMeans ratio;
    for (int k = 0; k < 100; ++k) {
        Scene scene = paperScene(rng, 400, 0, 0);
        scene.objectPoints *= 0.1;  // 60 px
        for (int i = 0; i < 400; ++i) {
            const double sharp = rng.gaussian(0.02), blurred = rng.gaussian(1);
            const Vector3d p(scene.objectPoints(i, 0), scene.objectPoints(i, 1), scene.objectPoints(i, 2));
            const Vector3d x = scene.truth * p / (scene.truth * p).z();
            scene.imagePoints(i, 0) = K(0, 0) * x(0) + K(0, 2) + std::cos(k) * sharp - std::sin(k) * blurred;
            scene.imagePoints(i, 1) = K(1, 1) * x(1) + K(1, 2) + std::sin(k) * sharp + std::cos(k) * blurred;
        }
        Params params;
        const Result found = solvedPixels(scene, params);
        EXPECT_TRUE(std::isinf(found.tailDof)) << k;
        params.method = cv::gmlpnp::SOLVEPNP_GMLPNP;
        ratio.add(distance(found, scene), distance(solvedPixels(scene, params), scene));
    }
    EXPECT_TRUE(atMost(ratio.value(), 1.01, ratio.deviation()));  // at one depth the two are the same estimate
}

TEST(Gmlpnp_Noise, weightsNameTheOutliers)
{
    cv::RNG rng = testRng();
    Scene scene = paperScene(rng, 60, 0.05, 1);
    for (int i = 0; i < 3; ++i)
        scene.imagePoints(i, 0) += 200;
    const Result result = solvedPixels(scene, Params());
    ASSERT_EQ(cv::Size(1, 60), result.weights.size());
    double mean = 0;
    for (int i = 3; i < 60; ++i)
        mean += result.weights.at<double>(i) / 57;
    EXPECT_GT(mean, 0.9);
    for (int i = 0; i < 3; ++i)
        EXPECT_LT(result.weights.at<double>(i), 0.1);
    EXPECT_TRUE(poseNear(result, scene.truth, 0.02, 0.1));
}

}  // namespace
}  // namespace opencv_test
