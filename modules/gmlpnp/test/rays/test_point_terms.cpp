// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../../src/rays/ray_pass.hpp"
#include "../scenes.hpp"

// One point with its depth eliminated: the terms that the pass adds.

namespace opencv_test {
namespace {

using namespace cv::gmlpnp::detail;

struct OneRay
{
    Vector3d p, m;
    Pose pose;
    Matrix3d S_o, Gamma;
};

OneRay randomRay(cv::RNG& rng)
{
    OneRay s;
    s.p = gaussian3(rng);
    s.m = gaussian3(rng).normalized();
    s.pose = {randomRotation(rng), 3 * gaussian3(rng)};
    s.S_o = randomNoise(rng, 0.3);
    s.Gamma = randomNoise(rng, 0.1);
    return s;
}

PointTerms terms(const OneRay& s)
{
    return pointTerms(s.p, s.m, s.pose, s.S_o, s.Gamma);
}

// doc: the free identities of the eliminated depth.
TEST(Gmlpnp_RayPass, identities)
{
    cv::RNG rng = testRng();
    for (int k = 0; k < 100; ++k) {
        const OneRay s = randomRay(rng);
        const PointTerms at = terms(s);
        const double size = at.Q.norm();
        EXPECT_TRUE(matrixNear(at.Q * s.m, Vector3d::Zero(), 1e-12 * size));
        EXPECT_NEAR(s.m.dot(at.z), 0, 1e-12 * at.z.norm());
        EXPECT_NEAR(at.c, at.X.dot(at.z), 1e-10 * (1 + at.c));
        EXPECT_TRUE(matrixNear(at.z, at.Q * at.X, 1e-10 * (1 + at.z.norm())));
        EXPECT_TRUE(matrixNear(at.Q, at.Q.transpose(), 1e-12 * size));
        EXPECT_GE(Eigen3d(at.Q).eigenvalues()(0), -1e-12 * size);
        EXPECT_NEAR(at.D, s.m.dot(adjugate(s.S_o + at.s * at.s * s.Gamma) * s.m), 1e-15);
    }
}

TEST(Gmlpnp_RayPass, isotropicNoiseGivesTheProjector)
{
    cv::RNG rng = testRng();
    OneRay s = randomRay(rng);
    s.S_o = 0.04 * Matrix3d::Identity();
    s.Gamma.setZero();
    EXPECT_TRUE(matrixNear(terms(s).Q, (Matrix3d::Identity() - s.m * s.m.transpose()) / 0.04, 1e-12));
}

// The tangent plane formula, written out with a basis, is an independent way to c and D.
TEST(Gmlpnp_RayPass, agreesWithATangentBasis)
{
    cv::RNG rng = testRng();
    for (int k = 0; k < 50; ++k) {
        const OneRay s = randomRay(rng);
        const PointTerms at = terms(s);
        Eigen::Matrix<double, 3, 2> B;
        B.col(0) = s.m.unitOrthogonal();
        B.col(1) = s.m.cross(B.col(0));
        const Eigen::Matrix2d S2 = B.transpose() * (s.S_o + at.s * at.s * s.Gamma) * B;
        const Eigen::Vector2d r = B.transpose() * at.X;
        EXPECT_NEAR(at.c, r.dot(S2.inverse() * r), 1e-9 * (1 + at.c));
        EXPECT_NEAR(at.D, S2.determinant(), 1e-12 * S2.determinant());
    }
}

// zTilde is d(c/2)/dX with everything that depends on X: also S through the depth.
TEST(Gmlpnp_RayPass, correctedGradientIsTheDerivativeOfHalfC)
{
    cv::RNG rng = testRng();
    constexpr double h = 1e-6;
    for (int k = 0; k < 50; ++k) {
        const OneRay s = randomRay(rng);
        Vector3d numeric;
        for (int a = 0; a < 3; ++a) {
            OneRay plus = s, minus = s;
            plus.pose.t(a) += h;
            minus.pose.t(a) -= h;
            numeric(a) = (terms(plus).c - terms(minus).c) / (4 * h);
        }
        const PointTerms at = terms(s);
        EXPECT_TRUE(matrixNear(at.zTilde, numeric, 1e-6 * (1 + numeric.norm())));
    }
}

}  // namespace
}  // namespace opencv_test
