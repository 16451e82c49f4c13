// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "control_points.hpp"
#include "reprojection.hpp"

// A. Vakhitov, L. Ferraz, A. Agudo, F. Moreno-Noguer: Uncertainty-Aware Camera Pose Estimation from Points and Lines,
// CVPR 2021: EPnPU. EPnP with each pair of equations weighted by the inverse covariance of its algebraic error, which
// holds the noise of the pixel times the squared depth and that of the point, turned into the camera. Depth and
// rotation come from a hypothesis, here EPnP's pose; then bundle adjustment of the pose with both noises.

namespace baselines {

namespace {

std::optional<Pose> bestPose(const Data& data, const std::vector<Matrix2d>& weights)
{
    const ControlPoints control(data.points);
    std::optional<Pose> best;
    double least = std::numeric_limits<double>::infinity();
    for (const Pose& pose : posesByDistances(control, kernel(control, data, weights), data)) {
        if (!plausible(data, pose))
            continue;
        double cost = 0;
        for (int i = 0; i < data.size(); ++i) {
            const Vector3d X = pose * data.points.col(i);
            const Vector2d r = X.head<2>() - X.z() * data.image.col(i);
            cost += weights.empty() ? r.squaredNorm() : r.dot(weights[i] * r);
        }
        if (cost < least) {
            least = cost;
            best = pose;
        }
    }
    return best;
}

}  // namespace

std::optional<Pose> epnp(const Data& data)
{
    return bestPose(data, {});
}

std::optional<Pose> epnpu(const Data& data, const Uncertainty& uncertainty)
{
    constexpr int REFINEMENTS = 20;
    const std::optional<Pose> hypothesis = epnp(data);
    if (!hypothesis)
        return std::nullopt;
    const std::optional<Pose> pose = bestPose(data, algebraicWeights(data, *hypothesis, uncertainty));
    if (!pose)
        return std::nullopt;
    return refined(data, *pose, REFINEMENTS, &uncertainty);
}

}  // namespace baselines
