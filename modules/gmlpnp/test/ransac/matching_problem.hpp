// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_TEST_GMLPNP_MATCHING_PROBLEM_HPP
#define OPENCV_TEST_GMLPNP_MATCHING_PROBLEM_HPP

#include "../../src/ransac/score.hpp"
#include "../scenes.hpp"

namespace opencv_test {
namespace matching {

using namespace cv::gmlpnp::detail;

// A scene with wrong correspondences, as the search sees it.
struct MatchingProblem
{
    MatchingProblem(cv::RNG& rng, int n, double outliers) : MatchingProblem(rng, paperScene(rng, n, 0.01, 1), outliers)
    {}

    MatchingProblem(cv::RNG& rng, Scene given, double outliers)
        : scene(std::move(given)), data(withOutliers(rng, scene, outliers), scene.rays)
    {
        for (int i = 0; i < data.size(); ++i)
            metrics.push_back(angularMetric(data.scaledRayAt(i), 0.01));
    }

    static cv::Mat_<double> withOutliers(cv::RNG& rng, Scene& scene, double share)
    {
        const int n = scene.objectPoints.rows;
        for (int i = n - static_cast<int>(share * n); i < n; ++i)
            for (int k = 0; k < 3; ++k)
                scene.objectPoints(i, k) = rng.uniform(-3., 3.);
        return scene.objectPoints;
    }

    // By hand, as the definitions say it; behind the camera there is no residual.
    std::optional<Eigen::Vector2d> residual(const Pose& pose, int i) const
    {
        const Vector3d X = pose * data.pointAt(i);
        const double s = data.scaledRayAt(i).dot(X);
        if (s > 0)
            return Eigen::Vector2d(metrics[i] * X / s);
        return std::nullopt;
    }

    Score score(const Pose& pose) const
    {
        Score sum{0, 0};
        for (int i = 0; i < data.size(); ++i) {
            const auto e = residual(pose, i);
            const bool inlier = e && e->squaredNorm() < 1;
            sum.cost += inlier ? e->squaredNorm() : 1;
            sum.inliers += inlier;
        }
        return sum;
    }

    std::vector<bool> inliers(const Pose& pose) const
    {
        std::vector<bool> found(data.size());
        for (int i = 0; i < data.size(); ++i) {
            const auto e = residual(pose, i);
            found[i] = e && e->squaredNorm() < 1;
        }
        return found;
    }

    // Derivatives by differences.
    Pose stepped(const Pose& pose, double width) const
    {
        Matrix6d H = Matrix6d::Zero();
        Vector6d g = Vector6d::Zero();
        for (int i = 0; i < data.size(); ++i) {
            const auto e = residual(pose, i);
            if (!e || e->norm() >= width)
                continue;
            Eigen::Matrix<double, 2, 6> J;
            for (int k = 0; k < 6; ++k) {
                constexpr double STEP = 1e-6;
                const Vector6d along = STEP * Vector6d::Unit(k);
                J.col(k) = (*residual(perturbed(pose, along), i) - *residual(perturbed(pose, -along), i)) / (2 * STEP);
            }
            const double left = 1 - e->squaredNorm() / (width * width);
            H += left * left * J.transpose() * J;
            g += left * left * J.transpose() * *e;
        }
        return perturbed(pose, -H.ldlt().solve(g));
    }

    Scene scene;
    Correspondences data;
    std::vector<Metric> metrics;
};

inline Pose near(cv::RNG& rng, const Pose& pose, double size)
{
    Vector6d xi;
    xi << size * gaussian3(rng), size * gaussian3(rng);
    return perturbed(pose, xi);
}

}  // namespace matching
}  // namespace opencv_test

#endif  // OPENCV_TEST_GMLPNP_MATCHING_PROBLEM_HPP
