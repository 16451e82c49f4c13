// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../scenes.hpp"

namespace opencv_test {
namespace {

using namespace cv::gmlpnp::detail;

// The regimes where rotation formulas break: identity, tiny, ordinary, near and at pi.
std::vector<Vector3d> rotationVectors()
{
    cv::RNG rng = testRng();
    std::vector<Vector3d> vectors = {Vector3d::Zero()};
    for (double angle : {1e-12, 1e-8, 9e-5, 1.1e-4, 1e-2, 1.0, 3.0, CV_PI - 1e-4, CV_PI - 1e-8, CV_PI - 1e-12})
        for (int k = 0; k < 5; ++k)
            vectors.emplace_back(angle * gaussian3(rng).normalized());
    return vectors;
}

TEST(Gmlpnp_Lie, exponentialIsARotationAndMatchesRodrigues)
{
    for (const Vector3d& phi : rotationVectors()) {
        SCOPED_TRACE(phi.transpose());
        const Matrix3d R = expSO3(phi);
        EXPECT_TRUE(matrixNear(R * R.transpose(), Matrix3d::Identity(), 1e-14));
        cv::Matx33d theirs;
        cv::Rodrigues(cv::Vec3d(phi.x(), phi.y(), phi.z()), theirs);
        EXPECT_TRUE(matrixNear(R, matrix3(cv::Mat(theirs)), 1e-14));
    }
}

TEST(Gmlpnp_Lie, logarithmUndoesExponential)
{
    for (const Vector3d& phi : rotationVectors()) {
        SCOPED_TRACE(phi.transpose());
        EXPECT_TRUE(matrixNear(logSO3(expSO3(phi)), phi, 1e-15 + 4e-15 * phi.norm()));
    }
    const Matrix3d half = Vector3d(1, -1, -1).asDiagonal();  // exactly pi: either sign is right
    EXPECT_NEAR(logSO3(half).norm(), CV_PI, 1e-15);
}

TEST(Gmlpnp_Lie, leftJacobianInverseIsTheDerivativeOfTheLogarithm)
{
    constexpr double h = 1e-6;
    for (const Vector3d& phi : rotationVectors()) {
        if (phi.norm() > 3.1)
            continue;  // the difference would step over pi, where the logarithm jumps
        SCOPED_TRACE(phi.transpose());
        Matrix3d numeric;
        for (int k = 0; k < 3; ++k) {
            const Vector3d d = h * Vector3d::Unit(k);
            numeric.col(k) = (logSO3(expSO3(d) * expSO3(phi)) - logSO3(expSO3(-d) * expSO3(phi))) / (2 * h);
        }
        EXPECT_TRUE(matrixNear(leftJacobianInverse(phi), numeric, 1e-8));
    }
}

TEST(Gmlpnp_Lie, perturbationActsOnTheLeft)
{
    cv::RNG rng = testRng();
    const Pose pose{randomRotation(rng), gaussian3(rng)};
    Vector6d xi;
    xi << gaussian3(rng), gaussian3(rng);
    const Vector3d p = gaussian3(rng);
    EXPECT_TRUE(matrixNear(perturbed(pose, xi) * p, expSO3(xi.head<3>()) * (pose * p) + xi.tail<3>(), 1e-14));
}

TEST(Gmlpnp_Lie, differenceUndoesThePerturbation)
{
    cv::RNG rng = testRng();
    const Pose pose{randomRotation(rng), gaussian3(rng)};
    Vector6d xi;
    xi << 0.5 * gaussian3(rng), gaussian3(rng);
    EXPECT_TRUE(matrixNear(difference(perturbed(pose, xi), pose), xi, 1e-14));
}

TEST(Gmlpnp_Lie, nearestRotationKeepsRotationsAndMirrorsNone)
{
    cv::RNG rng = testRng();
    for (int k = 0; k < 20; ++k) {
        const Matrix3d R = randomRotation(rng);
        EXPECT_TRUE(matrixNear(nearestRotation(2.5 * R), R, 1e-14));
        EXPECT_NEAR(nearestRotation(-R).determinant(), 1, 1e-14);
    }
    EXPECT_NEAR(nearestRotation(Matrix3d::Zero()).determinant(), 1, 1e-14);
}

}  // namespace
}  // namespace opencv_test
