// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_TEST_SYNTHETIC_HPP
#define OPENCV_GMLPNP_TEST_SYNTHETIC_HPP

#include "../src/math/lie.hpp"

/** Synthetic problems and error measures: of the module's tests, and of programs that measure solvers. */
namespace synthetic {

using cv::gmlpnp::detail::Matrix3d;
using cv::gmlpnp::detail::Pose;
using cv::gmlpnp::detail::Vector3d;
using Eigen::Matrix2d;

/** 95 % quantile of chi-squared with 6 degrees of freedom: of the squared deviation of a true pose. */
constexpr double CHI2_6_95 = 12.591587;

Pose poseOf(const cv::Vec3d& rvec, const cv::Vec3d& tvec);

Vector3d gaussian3(cv::RNG& rng);
Matrix3d randomRotation(cv::RNG& rng);
/** Random symmetric positive definite matrix with standard deviations up to `sigma`, as in the paper: one is sigma. */
Matrix3d randomNoise(cv::RNG& rng, double sigma);

struct Scene
{
    cv::Mat_<double> objectPoints, imagePoints, rays;  // Nx3, Nx2, Nx3 unit
    Pose truth;
    Matrix3d Sigma = Matrix3d::Zero();            // object noise, object frame, length^2
    Matrix2d pixelCovariance = Matrix2d::Zero();  // px^2
};

/** f = 800 px, centre (320, 240). */
cv::Matx33d paperCamera();

/** The paper's synthetic protocol: points in [-2,2] x [-2,2] x [4,8] before the camera, world origin at their mean,
random rotation; object noise of largest standard deviation `sigma`, pixel noise likewise `px`, both anisotropic. */
Scene paperScene(cv::RNG& rng, int n, double sigma, double px);

/** Exact data: the points given in the camera frame, seen from a random pose by paperCamera(). */
Scene exactScene(cv::RNG& rng, const std::vector<Vector3d>& cameraPoints);

/** Adds noise to exact data, drawn as in paperScene(); the pixels become those of `camera`, and the rays theirs. */
void disturb(cv::RNG& rng, Scene& scene, double sigma, double px, const cv::gmlpnp::CameraModel& camera);

/** Points of the paper's box, exact; flat: all on one oblique plane through it. */
std::vector<Vector3d> boxPoints(cv::RNG& rng, int n, bool flat = false);

/** Points all around the camera, also behind it, at depths 2 to 8. */
std::vector<Vector3d> surroundingPoints(cv::RNG& rng, int n);

/** Angle of A^T B, rad: precise also for tiny angles, and not a number when either is. */
double rotationAngle(const Matrix3d& A, const Matrix3d& B);
/** The paper's rotation metric: largest angle between matching columns, degrees. */
double columnAngle(const Matrix3d& A, const Matrix3d& B);

}  // namespace synthetic

#endif  // OPENCV_GMLPNP_TEST_SYNTHETIC_HPP
