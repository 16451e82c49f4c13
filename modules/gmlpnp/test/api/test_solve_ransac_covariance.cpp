// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "observed.hpp"

namespace opencv_test {
namespace {

using namespace ransac;

TEST(Gmlpnp_SolveRansac, covarianceHoldsWhereTheThresholdCutsIntoTheNoise)
{
    cv::RNG rng = testRng();
    const Ptr<CameraModel> lens = paperLens();
    for (const bool known : {false, true})
        for (const double threshold : {1.5, 2., 3., 8.}) {  // px, at a noise of 1 px
            Params params;
            if (known) {
                params.objectNoise = Mat::zeros(3, 3, CV_64F);
                params.bearingNoise = Mat::zeros(3, 3, CV_64F);
                params.pixelCovariances = Mat(140, 1, CV_64F, Scalar(1));
            }
            RansacParams ransac;
            ransac.threshold = threshold;
            constexpr int TRIALS = 200;
            double sum = 0;
            int inside = 0;
            for (int trial = 0; trial < TRIALS; ++trial) {
                const Observed data = observed(rng, *lens, 140, 0.3, 1, true);
                Result result;
                ASSERT_TRUE(solveRansac(data.scene.objectPoints, data.pixels, lens, result, noArray(), ransac, params));
                const double nees = mahalanobis2(data.scene.truth, poseOf(result), result.poseCovariance);
                sum += nees;
                inside += nees < 12.592;  // 95 % quantile
            }
            // The mean of so many has a standard deviation of .25, the share one of .016. Where residuals are nearly
            // uniform they tell less of the noise: the tails are longer.
            SCOPED_TRACE(testing::Message() << threshold << " px, " << (known ? "known" : "estimated") << " noise");
            EXPECT_GT(sum / TRIALS, 5.2);
            EXPECT_LT(sum / TRIALS, threshold < 2 ? 7.8 : 6.8);
            EXPECT_GE(inside, TRIALS * (threshold < 2 ? 0.85 : 0.91));
        }
}

}  // namespace
}  // namespace opencv_test
