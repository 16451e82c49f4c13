// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../../src/math/spd3.hpp"
#include "../scenes.hpp"

namespace opencv_test {
namespace {

using namespace cv::gmlpnp::detail;

TEST(Gmlpnp_Spd3, adjugateOfRegularAndSingularMatrices)
{
    cv::RNG rng = testRng();
    const Matrix3d S = randomNoise(rng, 2.0);
    EXPECT_TRUE(matrixNear(S * adjugate(S), S.determinant() * Matrix3d::Identity(), 1e-13));
    const Vector3d v = gaussian3(rng), w = gaussian3(rng);
    const Matrix3d rankTwo = v * v.transpose() + w * w.transpose();
    const Vector3d normal = v.cross(w);
    EXPECT_TRUE(matrixNear(adjugate(rankTwo), normal * normal.transpose(), 1e-13));
}

// X B X = A, whatever the sizes of A and B.
TEST(Gmlpnp_Spd3, geometricMeanSolvesItsEquation)
{
    cv::RNG rng = testRng();
    for (double size : {1e-12, 1e-3, 1., 1e9}) {
        const Matrix3d A = size * randomNoise(rng, 3.0), B = randomNoise(rng, 2.0), X = geometricMean(A, B);
        EXPECT_TRUE(matrixNear(X * B * X, A, 1e-9 * A.norm())) << size;
        EXPECT_GT(Eigen3d(X).eigenvalues()(0), 0);
    }
    const Matrix3d S = randomNoise(rng, 1.0);
    EXPECT_TRUE(matrixNear(geometricMean(S, Matrix3d::Identity()), Eigen3d(S).operatorSqrt(), 1e-12));
}

TEST(Gmlpnp_Spd3, liftedIsRegular)
{
    const Matrix3d S = Vector3d(3, 0, 0).asDiagonal();
    EXPECT_TRUE(matrixNear(lifted(S, 1e-3), Matrix3d(Vector3d(3.003, .003, .003).asDiagonal()), 1e-15));
}

TEST(Gmlpnp_Spd3, floorRaisesOnlyWhatIsBelowIt)
{
    const Matrix3d S = Vector3d(1, 1e-3, 1e-12).asDiagonal();
    EXPECT_TRUE(matrixNear(floored(S, 1e-8), Matrix3d(Vector3d(1, 1e-3, 1e-8).asDiagonal()), 1e-16));
    EXPECT_TRUE(matrixNear(floored(-S, 1e-8), Matrix3d::Zero(), 0));
}

TEST(Gmlpnp_Spd3, rankIsRelative)
{
    EXPECT_EQ(3, rank(1e-20 * Matrix3d::Identity(), 1e-6));
    EXPECT_EQ(2, rank(Vector3d(1, 1e-3, 1e-12).asDiagonal(), 1e-6));
    EXPECT_EQ(0, rank(Matrix3d::Zero(), 1e-6));
}

}  // namespace
}  // namespace opencv_test
