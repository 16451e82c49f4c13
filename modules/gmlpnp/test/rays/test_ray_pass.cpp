// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../../src/rays/ray_pass.hpp"
#include "../scenes.hpp"

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

Correspondences makeData(const Scene& scene)
{
    return Correspondences(scene.objectPoints, scene.rays);
}

RaySums sumsByPointTerms(const Correspondences& data, const Pose& pose, const Noise& noise)
{
    RaySums sums;
    sums.H.setZero(), sums.g.setZero();
    sums.Zo.setZero(), sums.Go.setZero(), sums.Zb.setZero(), sums.Gb.setZero();
    sums.L = sums.misfit = sums.c = sums.c2 = sums.inFront = 0;
    for (int i = 0; i < data.size(); ++i) {
        const PointTerms at = pointTerms(data, i, pose, noise);
        Eigen::Matrix<double, 3, 6> J;
        J << -hat(at.Xhat), Matrix3d::Identity();
        sums.H += at.w * J.transpose() * at.Q * J;
        sums.g += at.w * J.transpose() * at.zTilde;
        sums.Zo += at.w * at.z * at.z.transpose();
        sums.Go += at.Q;
        sums.Zb += at.w * at.s * at.s * at.z * at.z.transpose();
        sums.Gb += at.s * at.s * at.Q;
        const double misfit = noise.tails.share > 0 ? -std::log(tailTerms(noise.tails, at.c).g) : 0.5 * at.c;
        sums.c += at.c;
        sums.c2 += at.c * at.c;
        sums.misfit += misfit;
        sums.L += 0.5 * std::log(at.D) + misfit;
        sums.inFront += at.s > 0;
    }
    return sums;
}

void expectSameSums(const RaySums& ours, const RaySums& theirs)
{
    const double relative = 1e-11;
    EXPECT_TRUE(matrixNear(ours.H, theirs.H, relative * theirs.H.norm()));
    EXPECT_TRUE(matrixNear(ours.g, theirs.g, relative * theirs.H.norm()));
    EXPECT_TRUE(matrixNear(ours.Zo, theirs.Zo, relative * theirs.Zo.norm()));
    EXPECT_TRUE(matrixNear(ours.Go, theirs.Go, relative * theirs.Go.norm()));
    EXPECT_TRUE(matrixNear(ours.Zb, theirs.Zb, relative * theirs.Zb.norm()));
    EXPECT_TRUE(matrixNear(ours.Gb, theirs.Gb, relative * theirs.Gb.norm()));
    EXPECT_NEAR(ours.L, theirs.L, relative * std::abs(theirs.L));
    EXPECT_NEAR(ours.misfit, theirs.misfit, relative * theirs.misfit);
    EXPECT_NEAR(ours.c, theirs.c, relative * theirs.c);
    EXPECT_NEAR(ours.c2, theirs.c2, relative * theirs.c2);
    EXPECT_EQ(ours.inFront, theirs.inFront);
}

cv::Mat_<double> randomCovariances(cv::RNG& rng, int n, double sigma)
{
    cv::Mat_<double> rows(n, 9);
    for (int i = 0; i < n; ++i) {
        const Matrix3d C = randomNoise(rng, sigma);
        for (int k = 0; k < 9; ++k)
            rows(i, k) = C(k / 3, k % 3);
    }
    return rows;
}

TEST(Gmlpnp_RayPass, addsThePointTerms)
{
    cv::RNG rng = testRng();
    const Scene scene = exactScene(rng, surroundingPoints(rng, 37));
    const cv::Mat_<double> P = randomCovariances(rng, 37, 0.5), B = randomCovariances(rng, 37, 0.1);
    for (const Correspondences& data :
         {Correspondences(scene.objectPoints, scene.rays), Correspondences(scene.objectPoints, scene.rays, P),
          Correspondences(scene.objectPoints, scene.rays, {}, B),
          Correspondences(scene.objectPoints, scene.rays, P, B)})
        for (const Tails& tails : {Tails{}, Tails{0.02}, Tails{0.5, 9, 3}, Tails{1, 1, 2}}) {
            const Pose pose{randomRotation(rng), gaussian3(rng)};
            const Noise noise{randomNoise(rng, 0.2), randomNoise(rng, 0.05), tails};
            expectSameSums(rayPass(data, pose, noise), sumsByPointTerms(data, pose, noise));
        }
}

// What is known of every point alike is the same as so much more noise.
TEST(Gmlpnp_RayPass, knownCovariancesAdd)
{
    cv::RNG rng = testRng();
    const Scene scene = exactScene(rng, surroundingPoints(rng, 20));
    const Matrix3d P = randomNoise(rng, 0.3), B = randomNoise(rng, 0.1);
    cv::Mat_<double> rowsP(20, 9), rowsB(20, 9);
    for (int i = 0; i < 20; ++i)
        for (int k = 0; k < 9; ++k)
            rowsP(i, k) = P(k / 3, k % 3), rowsB(i, k) = B(k / 3, k % 3);
    const Correspondences without(scene.objectPoints, scene.rays), with(scene.objectPoints, scene.rays, rowsP, rowsB);
    const Pose pose{randomRotation(rng), gaussian3(rng)};
    const Noise some{randomNoise(rng, 0.2), randomNoise(rng, 0.05), {0.1}};
    const double unit = 1 / (with.scale * with.scale);
    expectSameSums(rayPass(with, pose, some),
                   rayPass(without, pose, {some.Sigma + unit * P, some.Gamma + B, some.tails}));
}

// A Gamma that differs from ray to ray by the squares of angular scales is the same as covariances known of each ray.
TEST(Gmlpnp_RayPass, angularScalesScaleGamma)
{
    constexpr int N = 21;
    cv::RNG rng = testRng();
    const Scene scene = exactScene(rng, surroundingPoints(rng, N));
    const Pose pose{randomRotation(rng), gaussian3(rng)};
    const Noise noise{randomNoise(rng, 0.2), randomNoise(rng, 0.05), {0.1}};
    cv::Mat_<double> rays = scene.rays.clone(), covariances(N, 9), known(N, 9);
    double logScales = 0;
    for (int i = 0; i < N; ++i) {
        const double scale = rng.uniform(0.2, 1.5);
        rays.row(i) *= scale;
        logScales += std::log(scale);
        const Matrix3d B = randomNoise(rng, 0.1);
        for (int k = 0; k < 9; ++k) {
            known(i, k) = B(k / 3, k % 3);
            covariances(i, k) = scale * scale * noise.Gamma(k / 3, k % 3) + known(i, k);
        }
    }
    const Correspondences scaled(scene.objectPoints, rays, {}, known, true);
    const Correspondences apart(scene.objectPoints, scene.rays, {}, covariances);
    EXPECT_NEAR(logScales, scaled.logAngularScales(), 1e-12);
    EXPECT_EQ(0, apart.logAngularScales());
    const RaySums a = rayPass(scaled, pose, noise);
    const RaySums b = rayPass(apart, pose, {noise.Sigma, Matrix3d::Zero(), noise.tails});
    EXPECT_TRUE(matrixNear(a.H, b.H, 1e-11 * b.H.norm()));
    EXPECT_TRUE(matrixNear(a.g, b.g, 1e-11 * b.g.norm()));
    EXPECT_TRUE(matrixNear(a.Zo, b.Zo, 1e-11 * b.Zo.norm()));
    EXPECT_TRUE(matrixNear(a.Go, b.Go, 1e-11 * b.Go.norm()));
    EXPECT_NEAR(a.misfit, b.misfit, 1e-11 * b.misfit);
    EXPECT_NEAR(a.L - logScales, b.L, 1e-10);
}

// The rays of a scene turned so that R is the true rotation.
Correspondences turnedTo(const Matrix3d& R, const Scene& scene, Pose& truth)
{
    const Matrix3d turn = R * scene.truth.R.transpose();
    cv::Mat_<double> rays(scene.rays.rows, 3);
    for (int i = 0; i < rays.rows; ++i) {
        const Vector3d m = turn * Vector3d(scene.rays(i, 0), scene.rays(i, 1), scene.rays(i, 2));
        for (int k = 0; k < 3; ++k)
            rays(i, k) = m(k);
    }
    Correspondences data(scene.objectPoints, rays);
    truth = data.fromObject({R, turn * scene.truth.t});
    return data;
}

Vector6d numericGradient(const Correspondences& data, const Pose& pose, const Noise& noise)
{
    constexpr double h = 1e-6;
    Vector6d gradient;
    for (int k = 0; k < 6; ++k) {
        const Vector6d step = h * Vector6d::Unit(k);
        gradient(k) =
            (rayPass(data, perturbed(pose, step), noise).misfit - rayPass(data, perturbed(pose, -step), noise).misfit) /
            (2 * h);
    }
    return gradient;
}

Matrix6d numericHessian(const Correspondences& data, const Pose& pose, const Noise& noise)
{
    constexpr double h = 1e-6;
    Matrix6d hessian;
    for (int k = 0; k < 6; ++k) {
        const Vector6d step = h * Vector6d::Unit(k);
        hessian.col(k) =
            (rayPass(data, perturbed(pose, step), noise).g - rayPass(data, perturbed(pose, -step), noise).g) / (2 * h);
    }
    return hessian;
}

// At the identity, 1e-8 from it, at random and near a rotation of pi: g is the derivative of sum c/2 with Sigma fixed
// in the object frame and Gamma in the camera frame; without residuals H is its Hessian.
TEST(Gmlpnp_RayPass, gradientAndHessianAreNumericDerivatives)
{
    cv::RNG rng = testRng();
    const Vector3d axis = gaussian3(rng).normalized();
    const std::vector<Matrix3d> rotations = {Matrix3d::Identity(), expSO3(1e-8 * axis), randomRotation(rng),
                                             expSO3((CV_PI - 1e-8) * axis)};
    const Matrix3d some = randomNoise(rng, 0.2) + 0.01 * Matrix3d::Identity(), none = Matrix3d::Zero();
    for (const Matrix3d& R : rotations)
        for (const Noise& noise :
             {Noise{some, none, {0}}, Noise{some, none, {0.2}}, Noise{1e-8 * Matrix3d::Identity(), some, {0}}}) {
            Pose truth;
            const Correspondences data = turnedTo(R, exactScene(rng, surroundingPoints(rng, 30)), truth);
            Vector6d xi;
            xi << 0.03 * gaussian3(rng), 0.03 * gaussian3(rng);
            const Pose off = perturbed(truth, xi);
            const Vector6d gradient = numericGradient(data, off, noise);
            EXPECT_TRUE(matrixNear(rayPass(data, off, noise).g, gradient, 1e-6 * gradient.norm()));
            const RaySums exact = rayPass(data, truth, noise);
            EXPECT_TRUE(matrixNear(exact.H, numericHessian(data, truth, noise), 1e-6 * exact.H.norm()));
            EXPECT_TRUE(matrixNear(exact.H, exact.H.transpose(), 0));
            EXPECT_GT(Eigen::SelfAdjointEigenSolver<Matrix6d>(exact.H).eigenvalues()(0), 0);
        }
}

// Published: the noise stays as it lies in the camera frame while the pose moves.
TEST(Gmlpnp_RayPass, leverArmAsGivenHoldsTheNoiseInTheCameraFrame)
{
    cv::RNG rng = testRng();
    const Correspondences data = makeData(paperScene(rng, 20, 0.3, 3));
    const Pose pose{randomRotation(rng), Vector3d(0, 0, 3)};
    const Noise noise{randomNoise(rng, 0.2) + 0.01 * Matrix3d::Identity(), Matrix3d::Zero(), {}};
    constexpr double h = 1e-6;
    Vector6d gradient;
    for (int k = 0; k < 6; ++k) {
        double c[2];
        for (int side : {0, 1}) {
            const Pose moved = perturbed(pose, (side ? h : -h) * Vector6d::Unit(k));
            const Matrix3d turn = moved.R.transpose() * pose.R;
            c[side] = rayPass(data, moved, {turn * noise.Sigma * turn.transpose(), noise.Gamma, {0}}).misfit;
        }
        gradient(k) = (c[1] - c[0]) / (2 * h);
    }
    EXPECT_TRUE(matrixNear(rayPass(data, pose, noise, {LeverArm::AS_GIVEN, NO_PRODUCTS, nullptr}).g, gradient,
                           1e-6 * gradient.norm()));
}

// The mean of the gradient at the truth vanishes for either noise: what makes the estimate consistent.
TEST(Gmlpnp_RayPass, gradientHasNoMeanAtTheTruth)
{
    cv::RNG rng = testRng();
    const Scene scene = exactScene(rng, boxPoints(rng, 40));
    const Matrix3d object = randomNoise(rng, 0.3);
    const double bearing = 0.02;
    for (bool isObject : {true, false}) {
        const Noise noise{isObject ? object : Matrix3d(1e-12 * Matrix3d::Identity()),
                          isObject ? Matrix3d(Matrix3d::Zero()) : Matrix3d(bearing * bearing * Matrix3d::Identity()),
                          {0}};
        const Matrix3d root = Eigen3d(object).operatorSqrt();
        Vector6d sum = Vector6d::Zero();
        Matrix6d information = Matrix6d::Zero();
        const int trials = 4000;
        for (int trial = 0; trial < trials; ++trial) {
            cv::Mat_<double> points = scene.objectPoints.clone(), rays = scene.rays.clone();
            for (int i = 0; i < points.rows; ++i) {
                const Vector3d e = isObject ? Vector3d(root * gaussian3(rng)) : Vector3d(bearing * gaussian3(rng));
                for (int k = 0; k < 3; ++k)
                    (isObject ? points : rays)(i, k) += e(k);
            }
            const Correspondences data(points, rays);
            const double unit = 1 / (data.scale * data.scale);
            const RaySums sums = rayPass(data, data.fromObject(scene.truth), {unit * noise.Sigma, noise.Gamma, {0}});
            // In the caller's units, so that trials add up: delta' = delta / scale.
            Vector6d units;
            units << 1, 1, 1, Vector3d::Constant(1 / data.scale);
            sum += units.cwiseProduct(sums.g);
            information += units.asDiagonal() * sums.H * units.asDiagonal();
        }
        // g ~ (0, H) per trial, so this is chi-squared with 6 degrees of freedom; its 99.99 % quantile is 27.9.
        EXPECT_LT(sum.dot(information.ldlt().solve(sum)), 27.9) << (isObject ? "object" : "bearing") << " noise";
    }
}

TEST(Gmlpnp_RayPass, countsPointsInFront)
{
    cv::RNG rng = testRng();
    const Scene scene = exactScene(rng, surroundingPoints(rng, 25));
    const Correspondences data = makeData(scene);
    Pose pose = data.fromObject(scene.truth);
    const Noise noise{Matrix3d::Identity(), Matrix3d::Zero(), {}};
    EXPECT_EQ(25, rayPass(data, pose, noise).inFront);
    const Correspondences opposite(scene.objectPoints, cv::Mat_<double>(cv::Mat(-scene.rays)));
    EXPECT_EQ(0, rayPass(opposite, pose, noise).inFront);
}

}  // namespace
}  // namespace opencv_test
