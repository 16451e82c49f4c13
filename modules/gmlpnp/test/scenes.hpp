// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_TEST_SCENES_HPP
#define OPENCV_GMLPNP_TEST_SCENES_HPP

#include "test_precomp.hpp"

#include "../src/solve.hpp"

// Synthetic problems and pose assertions, once for all tests.

namespace opencv_test {

using cv::gmlpnp::detail::Matrix3d;
using cv::gmlpnp::detail::Matrix6d;
using cv::gmlpnp::detail::Pose;
using cv::gmlpnp::detail::Vector3d;
using cv::gmlpnp::detail::Vector6d;

/** A generator seeded from the name of the running test: fixed, and another for each test. */
cv::RNG testRng();

Vector3d gaussian3(cv::RNG& rng);
Matrix3d randomRotation(cv::RNG& rng);
/** Random symmetric positive definite matrix with standard deviations up to `sigma`, as in the paper: one is sigma. */
Matrix3d randomNoise(cv::RNG& rng, double sigma);

struct Scene
{
    cv::Mat_<double> objectPoints, imagePoints, rays;  // Nx3, Nx2, Nx3 unit
    Pose truth;
    Matrix3d Sigma = Matrix3d::Zero();
};

/** f = 800 px, centre (320, 240). */
cv::Matx33d paperCamera();

/** The paper's synthetic protocol: points in [-2,2] x [-2,2] x [4,8] before the camera, world origin at their mean,
random rotation; object noise of largest standard deviation `sigma`, pixel noise likewise `px`, both anisotropic. */
Scene paperScene(cv::RNG& rng, int n, double sigma, double px);

/** Exact data: the points given in the camera frame, seen from a random pose. */
Scene exactScene(cv::RNG& rng, const std::vector<Vector3d>& cameraPoints);

/** Points of the paper's box, exact; flat: all on one oblique plane through it. */
std::vector<Vector3d> boxPoints(cv::RNG& rng, int n, bool flat = false);

/** Points all around the camera, also behind it, at depths 2 to 8. */
std::vector<Vector3d> surroundingPoints(cv::RNG& rng, int n);

/** Angle of A^T B, rad: precise also for tiny angles, and not a number when either is. */
double rotationAngle(const Matrix3d& A, const Matrix3d& B);
/** The paper's rotation metric: largest angle between matching columns, degrees. */
double columnAngle(const Matrix3d& A, const Matrix3d& B);

Pose poseOf(const cv::Vec3d& rvec, const cv::Vec3d& tvec);

/** Both errors at most the bounds [rad, length]; fails on NaN. */
testing::AssertionResult poseNear(const Pose& pose, const Pose& truth, double angle, double distance);
testing::AssertionResult poseNear(const cv::gmlpnp::Result& result, const Pose& truth, double angle, double distance);

/** Largest difference of entries at most `bound`; fails on NaN and on other shapes. */
template <class A, class B>
testing::AssertionResult matrixNear(const Eigen::MatrixBase<A>& a, const Eigen::MatrixBase<B>& b, double bound)
{
    const double worst = (a - b).cwiseAbs().maxCoeff();
    if (a.allFinite() && b.allFinite() && worst <= bound)
        return testing::AssertionSuccess();
    return testing::AssertionFailure() << "differ by " << worst << " > " << bound << "\n" << a << "\nand\n" << b;
}

Matrix3d matrix3(const cv::Mat& m);
Matrix6d matrix6(const cv::Mat& m);

}  // namespace opencv_test

#endif  // OPENCV_GMLPNP_TEST_SCENES_HPP
