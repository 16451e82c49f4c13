// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../../src/noise/model.hpp"
#include "../../src/noise/scoring.hpp"
#include "fixed_pose.hpp"

namespace opencv_test {
namespace {

using namespace cv::gmlpnp::detail;

// Scoring ends where the likelihood with its prior is flat: the numerical gradient vanishes in all directions.
TEST(Gmlpnp_NoiseModel, scoringEndsAtTheMaximumWithItsPrior)
{
    cv::RNG rng = testRng();
    const FixedPose at = fixedPose(rng, 1000);
    for (NoiseKind kind : {NoiseKind::OBJECT, NoiseKind::BEARING}) {
        const bool object = kind == NoiseKind::OBJECT;
        Noise noise;
        Matrix3d& C = object ? noise.Sigma : noise.Gamma;
        C = randomNoise(rng, 0.05);
        if (!object)
            noise.Sigma = 1e-9 * Matrix3d::Identity();
        const PassOptions options{LeverArm::CORRECTED, object ? OF_OBJECT : OF_BEARING, nullptr};
        for (int k = 0; k < 30; ++k)
            noise = scoredNoise(kind, noise, rayPass(at.data, at.pose, noise, options), at.pose.R);

        const Matrix3d found = C, root = C.llt().matrixL(), target = C.trace() / 3 * Matrix3d::Identity();
        const auto cost = [&](const Matrix3d& step) {
            C = found + root * step * root.transpose();
            return rayPass(at.data, at.pose, noise).L +
                   0.5 * SHRINKAGE * (std::log(C.determinant()) + (target * C.inverse()).trace());
        };
        for (int i = 0; i < 3; ++i)
            for (int j = i; j < 3; ++j) {
                constexpr double h = 1e-4;
                Matrix3d E = Matrix3d::Zero();
                E(i, j) = E(j, i) = h;
                EXPECT_NEAR((cost(E) - cost(-E)) / (2 * h), 0, 0.02) << object << ": " << i << j;  // of 1000 points
            }
    }
}

}  // namespace
}  // namespace opencv_test
