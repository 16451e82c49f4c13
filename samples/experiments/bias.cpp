// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include <opencv2/calib3d.hpp>

#include "experiments.hpp"

// Whether the pose is pulled along the viewing direction: noise in the pixels pulls one way, noise in the points the
// other, where the solver takes one for the other.

namespace experiments {

namespace {

struct Cell
{
    std::string name;
    Draw draw;
};

struct Outcome
{
    PoseErrors errors;
    double depth;  // signed, along the true direction to the object, m
};

Outcome outcome(const Pose& pose, const Pose& truth)
{
    return {errorsOf(pose, truth), (pose.t - truth.t).dot(truth.t.normalized())};
}

constexpr const char* METHODS[] = {"SQPnP", "SQPnP + refineLM", "GMLPnP marginal"};
constexpr size_t COUNT = std::size(METHODS);

std::array<Outcome, COUNT> outcomes(const Problem& problem)
{
    const Scene& scene = problem.scene;
    const cv::Matx33d K = synthetic::paperCamera();
    std::array<Outcome, COUNT> all;
    cv::Vec3d rvec, tvec;
    const auto solve = [&](int flag) {
        if (!cv::gmlpnp::solvePnP(scene.objectPoints, scene.imagePoints, K, cv::noArray(), rvec, tvec, false, flag))
            throw std::runtime_error("bias: a problem without a pose");
        return outcome(poseOf(rvec, tvec), scene.truth);
    };
    all[0] = solve(cv::SOLVEPNP_SQPNP);
    cv::solvePnPRefineLM(scene.objectPoints, scene.imagePoints, K, cv::noArray(), rvec, tvec);
    all[1] = outcome(poseOf(rvec, tvec), scene.truth);
    all[2] = solve(cv::gmlpnp::SOLVEPNP_GMLPNP_MARGINAL);
    return all;
}

std::vector<Cell> cells()
{
    std::vector<Cell> all;
    for (const double half : {30., 200.})
        for (const int n : {100, 400})
            all.push_back({cv::format("pixels, ±%g px, n = %d", half, n), smallProblem(n, half, 1)});
    for (const double field : {15., 60.})
        for (const int n : {50, 100, 400})
            all.push_back({cv::format("0.05 m + 1 px, ±%g°, n = %d", field, n), coneProblem(n, field, 0.05, 1)});
    return all;
}

}  // namespace

void runBias(const Settings& settings)
{
    const std::vector<Cell> all = cells();
    const int trials = settings.trials;
    Progress progress("bias", static_cast<long>(all.size()) * trials);
    Csv csv(settings.folder, "bias",
            std::vector<std::string>{"cell", "solver", "trials"} + intervalColumns("rotation_deg") +
                intervalColumns("translation_percent") + intervalColumns("depth_m") +
                std::vector<std::string>{"depth_deviation_m"});
    for (size_t c = 0; c < all.size(); ++c) {
        std::vector<std::array<Outcome, COUNT>> results(trials);
        forTrials(trials, settings.threads, progress, [&](int k) {
            cv::RNG rng = trialRng("bias", static_cast<int>(c), k);
            results[k] = outcomes(all[c].draw(rng));
        });
        const Bootstrap bootstrap(trials);
        for (size_t m = 0; m < COUNT; ++m) {
            std::vector<double> rotation, translation, depth;
            double square = 0;
            for (const auto& one : results) {
                rotation.push_back(one[m].errors.rotation);
                translation.push_back(one[m].errors.translation);
                depth.push_back(one[m].depth);
                square += depth.back() * depth.back() / trials;
            }
            const Interval mean = bootstrap.mean(depth);
            csv << "\"" + all[c].name + "\"" << METHODS[m] << trials << bootstrap.mean(rotation)
                << bootstrap.mean(translation) << mean << std::sqrt(square - mean.value * mean.value);
            csv.endRow();
        }
    }
    csv.save();
}

}  // namespace experiments
