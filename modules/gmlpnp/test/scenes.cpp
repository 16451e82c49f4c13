// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "test_precomp.hpp"

#include "scenes.hpp"

namespace opencv_test {

using namespace cv::gmlpnp::detail;

cv::RNG testRng()
{
    const testing::TestInfo* info = testing::UnitTest::GetInstance()->current_test_info();
    uint64_t hash = 1469598103934665603ull;  // FNV-1a
    for (const char* c = info->name(); *c; ++c)
        hash = (hash ^ static_cast<unsigned char>(*c)) * 1099511628211ull;
    return cv::RNG(hash);
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
    const Vector3d slope(rng.uniform(-0.4, 0.4), rng.uniform(-0.4, 0.4), 0);
    std::vector<Vector3d> points(n);
    for (Vector3d& X : points) {
        X.x() = rng.uniform(-2., 2.);
        X.y() = rng.uniform(-2., 2.);
        X.z() = flat ? 6 + slope.head<2>().dot(X.head<2>()) : rng.uniform(4., 8.);
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
    Scene scene = exactScene(rng, boxPoints(rng, n));
    const Matrix3d Ro = randomRotation(rng);
    const Vector3d deviations = randomDeviations(rng, sigma);
    scene.Sigma = Ro * deviations.cwiseAbs2().asDiagonal() * Ro.transpose();
    const double turn = rng.uniform(0., CV_PI), across = rng.uniform(0., px);
    const double c = std::cos(turn), s = std::sin(turn);
    for (int i = 0; i < n; ++i) {
        const Vector3d e = Ro * deviations.cwiseProduct(gaussian3(rng));
        for (int k = 0; k < 3; ++k)
            scene.objectPoints(i, k) += e(k);
        const double u = rng.gaussian(px), v = rng.gaussian(across);
        scene.imagePoints(i, 0) += c * u - s * v;
        scene.imagePoints(i, 1) += s * u + c * v;
        setRow(scene.rays, i,
               Vector3d((scene.imagePoints(i, 0) - 320) / 800, (scene.imagePoints(i, 1) - 240) / 800, 1).normalized());
    }
    return scene;
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

Pose poseOf(const cv::Vec3d& rvec, const cv::Vec3d& tvec)
{
    return {expSO3(Vector3d(rvec[0], rvec[1], rvec[2])), Vector3d(tvec[0], tvec[1], tvec[2])};
}

testing::AssertionResult poseNear(const Pose& pose, const Pose& truth, double angle, double distance)
{
    const double angleOff = rotationAngle(pose.R, truth.R), distanceOff = (pose.t - truth.t).norm();
    if (angleOff <= angle && distanceOff <= distance)  // false for NaN
        return testing::AssertionSuccess();
    return testing::AssertionFailure() << "rotation off by " << angleOff << " rad (bound " << angle
                                       << "), translation off by " << distanceOff << " (bound " << distance << ")";
}

testing::AssertionResult poseNear(const cv::gmlpnp::Result& result, const Pose& truth, double angle, double distance)
{
    return poseNear(poseOf(result.rvec, result.tvec), truth, angle, distance);
}

Matrix3d matrix3(const cv::Mat& m)
{
    Matrix3d M;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            M(i, j) = m.at<double>(i, j);
    return M;
}

Matrix6d matrix6(const cv::Mat& m)
{
    Matrix6d M;
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j)
            M(i, j) = m.at<double>(i, j);
    return M;
}

}  // namespace opencv_test
