// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "problem.hpp"

#include "baselines/reprojection.hpp"

namespace experiments {

using cv::gmlpnp::CameraModel;

cv::Ptr<CameraModel> pinhole()
{
    static const cv::Ptr<CameraModel> camera = CameraModel::pinhole(synthetic::paperCamera());
    return camera;
}

cv::Ptr<CameraModel> wideLens()
{
    static const cv::Ptr<CameraModel> camera =
        CameraModel::omnidir(cv::Matx33d(300, 0, 640, 0, 300, 640, 0, 0, 1), cv::noArray(), 1.5);
    return camera;
}

namespace {

// Pixel noise carried to the ray by the lens, and object noise turned into the camera, as seen from its distance.
Matrix3d rayCovariance(const Scene& scene, const CameraModel& camera, int i)
{
    cv::Vec3d ray;
    cv::Matx32d jacobian;
    CV_Assert(camera.unprojectPoint({scene.imagePoints(i, 0), scene.imagePoints(i, 1)}, ray, &jacobian));
    const Eigen::Map<const Eigen::Matrix<double, 3, 2, Eigen::RowMajor>> J(jacobian.val);
    const Vector3d p = Eigen::Map<const Vector3d>(scene.objectPoints.ptr<double>(i));
    const Matrix3d& R = scene.truth.R;
    return J * scene.pixelCovariance * J.transpose() +
           R * scene.Sigma * R.transpose() / (scene.truth * p).squaredNorm();
}

double inlierError(const Problem& problem)
{
    double trace = 0;
    for (int i = 0; i < problem.data.size(); ++i)
        trace += baselines::residualCovariance(baselines::reproject(problem.data, i, problem.scene.truth),
                                               problem.scene.truth, problem.uncertainty, i)
                     .trace();
    return 3 * std::sqrt(trace / (2 * problem.data.size()));
}

}  // namespace

Problem prepared(const Scene& scene, const cv::Ptr<CameraModel>& camera, bool perspective)
{
    const int n = scene.objectPoints.rows;
    const double focal = synthetic::paperCamera()(0, 0);
    Problem problem{scene, camera, perspective, {}, {}, {}};
    problem.data.points.resize(3, n);
    problem.data.rays.resize(3, n);
    problem.uncertainty.object.assign(n, scene.Sigma);
    for (int i = 0; i < n; ++i) {
        problem.data.points.col(i) = Eigen::Map<const Vector3d>(scene.objectPoints.ptr<double>(i));
        problem.data.rays.col(i) = Eigen::Map<const Vector3d>(scene.rays.ptr<double>(i));
        problem.rayCovariances.push_back(rayCovariance(scene, *camera, i));
    }
    if (perspective) {
        problem.data.image = problem.data.rays.colwise().hnormalized();
        problem.uncertainty.image.assign(n, scene.pixelCovariance / (focal * focal));
        problem.inlierError = inlierError(problem);
    }
    return problem;
}

Draw paperProblem(int n, double sigma, double px)
{
    return [=](cv::RNG& rng) { return prepared(synthetic::paperScene(rng, n, sigma, px), pinhole(), true); };
}

namespace {

// The points that `point` draws in the camera frame, then the noise of the paper's protocol.
Draw noisy(int n, double sigma, double px, const std::function<Vector3d(cv::RNG&)>& point,
           const cv::Ptr<CameraModel>& camera, bool perspective)
{
    return [=](cv::RNG& rng) {
        std::vector<Vector3d> points(n);
        for (Vector3d& X : points)
            X = point(rng);
        Scene scene = synthetic::exactScene(rng, points);
        synthetic::disturb(rng, scene, sigma, px, *camera);
        return prepared(scene, camera, perspective);
    };
}

Vector3d direction(cv::RNG& rng, double halfFieldDegrees)
{
    const double cosine = rng.uniform(std::cos(halfFieldDegrees * CV_PI / 180), 1.), turn = rng.uniform(0., 2 * CV_PI);
    const double sine = std::sqrt(1 - cosine * cosine);
    return {sine * std::cos(turn), sine * std::sin(turn), cosine};
}

}  // namespace

Draw depthProblem(int n, double nearest, double farthest, double sigma, double px)
{
    const auto point = [=](cv::RNG& rng) {
        const double depth = std::exp(rng.uniform(std::log(nearest), std::log(farthest)));
        const double x = std::tan(rng.uniform(-CV_PI / 4, CV_PI / 4)), y = std::tan(rng.uniform(-CV_PI / 4, CV_PI / 4));
        return Vector3d(x * depth, y * depth, depth);
    };
    return noisy(n, sigma, px, point, pinhole(), true);
}

Draw smallProblem(int n, double halfSize, double px)
{
    const double depth = 6, reach = halfSize / synthetic::paperCamera()(0, 0) * depth;
    const auto point = [=](cv::RNG& rng) {
        const double x = rng.uniform(-reach, reach), y = rng.uniform(-reach, reach), z = rng.uniform(-reach, reach);
        return Vector3d(x, y, depth + z);
    };
    return noisy(n, 0, px, point, pinhole(), true);
}

Draw coneProblem(int n, double halfFieldDegrees, double sigma, double px)
{
    const auto point = [=](cv::RNG& rng) {
        const Vector3d m = direction(rng, halfFieldDegrees);
        return Vector3d(rng.uniform(4., 8.) * m);
    };
    return noisy(n, sigma, px, point, pinhole(), true);
}

Draw wideProblem(int n, double sigma, double px)
{
    const auto point = [](cv::RNG& rng) {
        const Vector3d m = direction(rng, 110);
        return Vector3d(rng.uniform(2., 8.) * m);
    };
    return noisy(n, sigma, px, point, wideLens(), false);
}

Draw outlierProblem(int n, double sigma, double px, double share, bool gross)
{
    return [=](cv::RNG& rng) {
        Scene scene = synthetic::paperScene(rng, n, sigma, px);
        const Matrix3d root = cv::gmlpnp::detail::Eigen3d(24 * scene.Sigma).operatorSqrt();  // 24 + 1 = 5^2
        for (int i = 0; i < cvRound(share * n); ++i) {
            if (gross) {
                scene.imagePoints(i, 0) = rng.uniform(0., 640.);
                scene.imagePoints(i, 1) = rng.uniform(0., 480.);
                cv::Vec3d ray;
                pinhole()->unprojectPoint({scene.imagePoints(i, 0), scene.imagePoints(i, 1)}, ray);
                Eigen::Map<Vector3d>(scene.rays.ptr<double>(i)) = Vector3d(ray.val);
            } else {
                Eigen::Map<Vector3d>(scene.objectPoints.ptr<double>(i)) += root * synthetic::gaussian3(rng);
            }
        }
        return prepared(scene, pinhole(), true);
    };
}

Draw studentProblem(int n, double sigma, double px, int dof)
{
    return [=](cv::RNG& rng) {
        Scene scene = synthetic::exactScene(rng, synthetic::boxPoints(rng, n));
        const cv::Mat_<double> exact = scene.objectPoints.clone();
        synthetic::disturb(rng, scene, sigma, px, *pinhole());
        for (int i = 0; i < n; ++i) {
            double chi2 = 0;
            for (int k = 0; k < dof; ++k) {
                const double normal = rng.gaussian(1);
                chi2 += normal * normal;
            }
            scene.objectPoints.row(i) =
                exact.row(i) + (scene.objectPoints.row(i) - exact.row(i)) / std::sqrt(chi2 / dof);
        }
        return prepared(scene, pinhole(), true);
    };
}

}  // namespace experiments
