// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "synthetic.hpp"

namespace synthetic {

using cv::gmlpnp::detail::logSO3;

Pose poseOf(const cv::Vec3d& rvec, const cv::Vec3d& tvec)
{
    return {cv::gmlpnp::detail::expSO3(Vector3d(rvec.val)), Vector3d(tvec.val)};
}

Vector3d gaussian3(cv::RNG& rng)
{
    const double x = rng.gaussian(1), y = rng.gaussian(1), z = rng.gaussian(1);
    return {x, y, z};
}

Matrix3d randomRotation(cv::RNG& rng)
{
    const Vector3d v = gaussian3(rng);
    return Eigen::Quaterniond(rng.gaussian(1), v.x(), v.y(), v.z()).normalized().toRotationMatrix();
}

namespace {

Vector3d randomDeviations(cv::RNG& rng, double sigma)
{
    const double s1 = rng.uniform(0., sigma), s2 = rng.uniform(0., sigma);
    return {sigma, s1, s2};
}

}  // namespace

Matrix3d randomNoise(cv::RNG& rng, double sigma)
{
    const Matrix3d R = randomRotation(rng);
    return R * randomDeviations(rng, sigma).cwiseAbs2().asDiagonal() * R.transpose();
}

cv::Matx33d paperCamera()
{
    return {800, 0, 320, 0, 800, 240, 0, 0, 1};
}

namespace {

void setRow(cv::Mat_<double>& m, int row, const Vector3d& v)
{
    for (int k = 0; k < 3; ++k)
        m(row, k) = v(k);
}

}  // namespace

Scene exactScene(cv::RNG& rng, const std::vector<Vector3d>& cameraPoints)
{
    const int n = static_cast<int>(cameraPoints.size());
    Scene scene{cv::Mat_<double>(n, 3), cv::Mat_<double>(n, 2), cv::Mat_<double>(n, 3), {}, Matrix3d::Zero()};
    Vector3d centre = Vector3d::Zero();
    for (const Vector3d& X : cameraPoints)
        centre += X / n;
    scene.truth = {randomRotation(rng), centre};
    for (int i = 0; i < n; ++i) {
        const Vector3d& X = cameraPoints[i];
        setRow(scene.objectPoints, i, scene.truth.R.transpose() * (X - centre));
        setRow(scene.rays, i, X.normalized());
        scene.imagePoints(i, 0) = 800 * X.x() / X.z() + 320;
        scene.imagePoints(i, 1) = 800 * X.y() / X.z() + 240;
    }
    return scene;
}

std::vector<Vector3d> boxPoints(cv::RNG& rng, int n, bool flat)
{
    const double slopeY = rng.uniform(-0.4, 0.4), slopeX = rng.uniform(-0.4, 0.4);
    std::vector<Vector3d> points(n);
    for (Vector3d& X : points) {
        X.x() = rng.uniform(-2., 2.);
        X.y() = rng.uniform(-2., 2.);
        X.z() = flat ? 6 + (slopeX * X.x() + slopeY * X.y()) : rng.uniform(4., 8.);
    }
    return points;
}

std::vector<Vector3d> surroundingPoints(cv::RNG& rng, int n)
{
    std::vector<Vector3d> points(n);
    for (Vector3d& X : points) {
        X = gaussian3(rng).normalized();
        X *= rng.uniform(2., 8.);
    }
    return points;
}

Scene paperScene(cv::RNG& rng, int n, double sigma, double px)
{
    static const cv::Ptr<cv::gmlpnp::CameraModel> camera = cv::gmlpnp::CameraModel::pinhole(paperCamera());
    Scene scene = exactScene(rng, boxPoints(rng, n));
    disturb(rng, scene, sigma, px, *camera);
    return scene;
}

void disturb(cv::RNG& rng, Scene& scene, double sigma, double px, const cv::gmlpnp::CameraModel& camera)
{
    const Matrix3d Ro = randomRotation(rng);
    const Vector3d deviations = randomDeviations(rng, sigma);
    scene.Sigma = Ro * deviations.cwiseAbs2().asDiagonal() * Ro.transpose();
    const double turn = rng.uniform(0., CV_PI), across = rng.uniform(0., px);
    const Matrix2d turned = Eigen::Rotation2Dd(turn).toRotationMatrix();
    scene.pixelCovariance = turned * Eigen::Vector2d(px * px, across * across).asDiagonal() * turned.transpose();
    for (int i = 0; i < scene.objectPoints.rows; ++i) {
        const Vector3d e = Ro * deviations.cwiseProduct(gaussian3(rng));
        for (int k = 0; k < 3; ++k)
            scene.objectPoints(i, k) += e(k);
        cv::Point2d pixel;
        cv::Vec3d ray(scene.rays.ptr<double>(i));
        CV_Assert(camera.projectPoint(ray, pixel));
        const double u = rng.gaussian(px), v = rng.gaussian(across);
        pixel += cv::Point2d(turned(0, 0) * u + turned(0, 1) * v, turned(1, 0) * u + turned(1, 1) * v);
        CV_Assert(camera.unprojectPoint(pixel, ray));
        scene.imagePoints(i, 0) = pixel.x;
        scene.imagePoints(i, 1) = pixel.y;
        setRow(scene.rays, i, {ray[0], ray[1], ray[2]});
    }
}

double rotationAngle(const Matrix3d& A, const Matrix3d& B)
{
    const Matrix3d difference = A.transpose() * B;
    return difference.allFinite() ? logSO3(difference).norm() : std::numeric_limits<double>::quiet_NaN();
}

double columnAngle(const Matrix3d& A, const Matrix3d& B)
{
    double largest = 0;
    for (int k = 0; k < 3; ++k)
        largest = std::max(largest, std::atan2(A.col(k).cross(B.col(k)).norm(), A.col(k).dot(B.col(k))));
    return largest * 180 / CV_PI;
}

}  // namespace synthetic
