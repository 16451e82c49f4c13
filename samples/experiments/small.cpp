// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "experiments.hpp"
#include "src/estimator/alternation.hpp"
#include "src/estimator/initial_pose.hpp"

// Where there are too few points for a covariance: the default against the estimator that takes all noise for
// isotropic.

namespace experiments {

namespace {

PoseErrors isotropicErrors(const Problem& problem)
{
    using namespace cv::gmlpnp::detail;
    const Correspondences data(problem.scene.objectPoints, problem.scene.rays);
    const std::vector<PoseCandidate> starts = initialPoses(data);
    return errorsOf(starts.empty() ? std::optional<Pose>()
                                   : std::optional<Pose>(data.toObject(isotropicPose(data, starts.front().pose))),
                    problem.scene.truth);
}

PoseErrors defaultErrors(const Problem& problem)
{
    const std::optional<cv::gmlpnp::Result> result = solved(problem, cv::gmlpnp::Params());
    return errorsOf(result ? std::optional<Pose>(poseOf(*result)) : std::nullopt, problem.scene.truth);
}

}  // namespace

void runSmall(const Settings& settings)
{
    constexpr int FEWEST = 4, MOST = 14;
    const std::pair<const char*, std::pair<double, double>> noises[] = {{"0.1 m + 1 px", {0.1, 1}}, {"1 px", {0, 1}}};
    const int trials = settings.trials;
    Progress progress("small", static_cast<long>(std::size(noises)) * (MOST - FEWEST + 1) * trials);
    Csv csv(settings.folder, "small",
            std::vector<std::string>{"noise", "x", "trials"} + intervalColumns("rotation_deg_ratio") +
                intervalColumns("translation_percent_ratio"));
    int cell = 0;
    for (const auto& noise : noises)
        for (int n = FEWEST; n <= MOST; ++n, ++cell) {
            std::vector<double> rotation(trials), translation(trials), rotation0(trials), translation0(trials);
            forTrials(trials, settings.threads, progress, [&](int k) {
                cv::RNG rng = trialRng("small", cell, k);
                const Problem problem = paperProblem(n, noise.second.first, noise.second.second)(rng);
                const PoseErrors ours = defaultErrors(problem), isotropic = isotropicErrors(problem);
                rotation[k] = ours.rotation, translation[k] = ours.translation;
                rotation0[k] = isotropic.rotation, translation0[k] = isotropic.translation;
            });
            const Bootstrap bootstrap(trials);
            csv << noise.first << n << trials << bootstrap.ratio(rotation, rotation0)
                << bootstrap.ratio(translation, translation0);
            csv.endRow();
        }
    csv.save();
}

}  // namespace experiments
