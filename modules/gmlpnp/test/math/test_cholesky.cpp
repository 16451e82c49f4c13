// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../../src/math/cholesky.hpp"
#include "../scenes.hpp"

namespace opencv_test {
namespace {

using namespace cv::gmlpnp::detail;

TEST(Gmlpnp_Cholesky, solvesAndTellsWhatItCannot)
{
    cv::RNG rng = testRng();
    Matrix6d A = Matrix6d::Zero();
    for (int k = 0; k < 6; ++k) {
        Vector6d v;
        v << gaussian3(rng), gaussian3(rng);
        A += v * v.transpose();
    }
    const CholeskyFactor<6> cholesky(A);
    ASSERT_TRUE(cholesky.positiveDefinite());
    const Vector6d b = Vector6d::LinSpaced(-1, 3);
    EXPECT_TRUE(matrixNear(A * cholesky.solve(b), b, 1e-9));
    A(3, 3) = std::nan("");
    EXPECT_FALSE(CholeskyFactor<6>(A).positiveDefinite());
    EXPECT_FALSE(CholeskyFactor<6>(Matrix6d::Zero()).positiveDefinite());
    EXPECT_FALSE(CholeskyFactor<6>(Matrix6d::Ones()).positiveDefinite());
    EXPECT_FALSE(CholeskyFactor<6>(-Matrix6d::Identity()).positiveDefinite());
}

}  // namespace
}  // namespace opencv_test
