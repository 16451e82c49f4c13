// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../../src/rays/ray_pass.hpp"
#include "../scenes.hpp"
#include "../statistics.hpp"

// The gradient and the Hessian that a pass sums: derivatives of what it minimises.

namespace opencv_test {
namespace {

using namespace cv::gmlpnp::detail;

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
    const Scene scene = paperScene(rng, 20, 0.3, 3);
    const Correspondences data(scene.objectPoints, scene.rays);
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

std::string nameOfNoise(const testing::TestParamInfo<const char*>& info)
{
    return info.param;
}

class Gmlpnp_RayPassStatistics : public testing::TestWithParam<const char*>
{};

// The mean of the gradient at the truth vanishes for either noise: what makes the estimate consistent.
TEST_P(Gmlpnp_RayPassStatistics, gradientHasNoMeanAtTheTruth)
{
    const bool isObject = GetParam() == std::string("object");
    cv::RNG rng = testRng();
    const Scene scene = exactScene(rng, boxPoints(rng, 40));
    const Matrix3d object = randomNoise(rng, 0.3), root = Eigen3d(object).operatorSqrt();
    const double bearing = 0.02;
    const Noise noise{isObject ? object : Matrix3d(1e-12 * Matrix3d::Identity()),
                      isObject ? Matrix3d(Matrix3d::Zero()) : Matrix3d(bearing * bearing * Matrix3d::Identity()),
                      {0}};
    Vector6d sum = Vector6d::Zero();
    Matrix6d information = Matrix6d::Zero();
    for (int trial = 0; trial < 4000; ++trial) {
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
    // g ~ (0, H) per trial.
    EXPECT_TRUE(asChiSquared6(sum.dot(information.ldlt().solve(sum))));
}

INSTANTIATE_TEST_SUITE_P(/**/, Gmlpnp_RayPassStatistics, testing::Values("object", "bearing"), nameOfNoise);

}  // namespace
}  // namespace opencv_test
