// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../../src/estimator/pose_covariance.hpp"
#include "../scenes.hpp"
#include "../statistics.hpp"

namespace opencv_test {
namespace {

using namespace cv::gmlpnp::detail;

Matrix6d someCovariance(cv::RNG& rng)
{
    Matrix6d A;
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j)
            A(i, j) = rng.gaussian(1e-3);
    return A * A.transpose();
}

// Conversions against numeric differentiation of what they convert to.
TEST(Gmlpnp_PoseCovariance, conversionsAreTheirDerivatives)
{
    cv::RNG rng = testRng();
    for (double angle : {1e-8, 1.0, 3.0}) {
        const Pose pose{expSO3(angle * gaussian3(rng).normalized()), 3 * gaussian3(rng)};
        constexpr double h = 1e-6;
        Matrix6d Jrt;
        Eigen::Matrix<double, 3, 6> Jc;
        for (int k = 0; k < 6; ++k) {
            const Pose plus = perturbed(pose, h * Vector6d::Unit(k)), minus = perturbed(pose, -h * Vector6d::Unit(k));
            Jrt.col(k) << (logSO3(plus.R) - logSO3(minus.R)) / (2 * h), (plus.t - minus.t) / (2 * h);
            Jc.col(k) = (minus.R.transpose() * minus.t - plus.R.transpose() * plus.t) / (2 * h);
        }
        const Matrix6d P = someCovariance(rng);
        EXPECT_TRUE(matrixNear(toRvecTvec(P, pose), Jrt * P * Jrt.transpose(), 1e-7 * P.norm()));
        EXPECT_TRUE(matrixNear(toCameraCenter(P, pose), Jc * P * Jc.transpose(), 1e-7 * P.norm()));
    }
}

TEST(Gmlpnp_PoseCovariance, determinedRefusesSingularInformation)
{
    Matrix6d H = Matrix6d::Identity();
    EXPECT_TRUE(determined(H));
    H(0, 0) = 1e-40;
    EXPECT_TRUE(determined(H)) << "a unit is no reason";
    H.row(5) = H.row(4);
    H.col(5) = H.col(4);
    EXPECT_FALSE(determined(H));
    H(0, 0) = std::nan("");
    EXPECT_FALSE(determined(H));
}

// With the noise known the covariance is H^-1 and must hold: NEES is chi-squared with 6 degrees of freedom.
TEST(Gmlpnp_PoseCovarianceStatistics, knownNoiseIsCovered)
{
    cv::RNG rng = testRng();
    Consistency consistency;
    for (int k = 0; k < 500; ++k) {
        const Scene scene = paperScene(rng, 40, 0.1, 0);
        cv::gmlpnp::Params params;
        params.method = cv::gmlpnp::SOLVEPNP_GMLPNP;
        cv::Mat_<double> Sigma(3, 3);
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                Sigma(i, j) = scene.Sigma(i, j);
        params.objectNoise = Sigma;
        cv::gmlpnp::Result result;
        ASSERT_TRUE(cv::gmlpnp::solveRays(scene.objectPoints, scene.rays, result, params));
        consistency.add(mahalanobis2(scene.truth, poseOf(result), result.poseCovariance));
    }
    EXPECT_TRUE(withinSigma(consistency.mean(), 6, consistency.deviation()));
    EXPECT_TRUE(shareWithin(consistency.inside(), consistency.trials(), 0.95, 0.95));
}

}  // namespace
}  // namespace opencv_test
