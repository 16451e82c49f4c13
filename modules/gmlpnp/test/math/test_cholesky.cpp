// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../../src/math/cholesky.hpp"
#include "../scenes.hpp"

namespace opencv_test {
namespace {

using namespace cv::gmlpnp::detail;

Matrix6d randomSpd(cv::RNG& rng)
{
    Matrix6d A = Matrix6d::Zero();
    for (int k = 0; k < 12; ++k) {
        Vector6d v;
        v << gaussian3(rng), gaussian3(rng);
        A += v * v.transpose();
    }
    return A;
}

TEST(Gmlpnp_Cholesky, solvesAsEigenDoes)
{
    cv::RNG rng = testRng();
    for (int k = 0; k < 100; ++k) {
        const Matrix6d A = randomSpd(rng);
        Vector6d b;
        b << gaussian3(rng), gaussian3(rng);
        const CholeskyFactor<6> cholesky(A);
        ASSERT_TRUE(cholesky.positiveDefinite());
        const Vector6d x = cholesky.solve(b);
        EXPECT_TRUE(matrixNear(x, Vector6d(A.ldlt().solve(b)), 1e-10 * x.norm()));
        EXPECT_TRUE(matrixNear(A * x, b, 1e-12 * A.norm() * x.norm()));
    }
}

TEST(Gmlpnp_Cholesky, solvesForTheInverse)
{
    cv::RNG rng = testRng();
    const Matrix3d A = randomNoise(rng, 2) + 0.1 * Matrix3d::Identity();
    const CholeskyFactor<3> cholesky(A);
    ASSERT_TRUE(cholesky.positiveDefinite());
    Matrix3d inverse;
    for (int k = 0; k < 3; ++k)
        inverse.col(k) = cholesky.solve(Vector3d::Unit(k));
    EXPECT_TRUE(matrixNear(A * inverse, Matrix3d::Identity(), 1e-13));
    EXPECT_TRUE(matrixNear(inverse, inverse.transpose(), 1e-13 * inverse.norm()));
}

// Radians and metres in one matrix: another unit of a row, a power of two, is another unit of the solution to the bit.
TEST(Gmlpnp_Cholesky, unitsOfTheRowsDoNotMatter)
{
    cv::RNG rng = testRng();
    const Matrix6d A = randomSpd(rng);
    const Vector6d b = Vector6d::LinSpaced(-1, 3);
    Vector6d units;
    units << 1, 0x1p-200, 0x1p40, 1, 0x1p120, 0x1p-3;
    const Matrix6d scaled = units.asDiagonal() * A * units.asDiagonal();
    const CholeskyFactor<6> cholesky(A), ofScaled(scaled);
    ASSERT_TRUE(ofScaled.positiveDefinite());
    const Vector6d x = cholesky.solve(b), y = ofScaled.solve(units.cwiseProduct(b));
    EXPECT_EQ(x, Vector6d(units.cwiseProduct(y)));
}

// It reads the lower triangle alone.
TEST(Gmlpnp_Cholesky, theUpperTriangleIsNotRead)
{
    cv::RNG rng = testRng();
    const Matrix6d A = randomSpd(rng);
    Matrix6d lower = A.triangularView<Eigen::Lower>();
    lower.triangularView<Eigen::StrictlyUpper>().setConstant(std::nan(""));
    const Vector6d b = Vector6d::Ones();
    EXPECT_EQ(CholeskyFactor<6>(A).solve(b), CholeskyFactor<6>(lower).solve(b));
}

TEST(Gmlpnp_Cholesky, tellsWhatItCannotSolve)
{
    cv::RNG rng = testRng();
    Matrix6d A = randomSpd(rng);
    ASSERT_TRUE(CholeskyFactor<6>(A).positiveDefinite());
    A(3, 3) = std::nan("");
    EXPECT_FALSE(CholeskyFactor<6>(A).positiveDefinite());
    EXPECT_FALSE(CholeskyFactor<6>(Matrix6d::Zero()).positiveDefinite());
    EXPECT_FALSE(CholeskyFactor<6>(Matrix6d::Ones()).positiveDefinite());
    EXPECT_FALSE(CholeskyFactor<6>(-Matrix6d::Identity()).positiveDefinite());
}

}  // namespace
}  // namespace opencv_test
