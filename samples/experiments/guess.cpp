// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "experiments.hpp"

// The solvers that take a guess, from the truth and from ever farther away.

namespace experiments {

namespace {

using cv::gmlpnp::detail::expSO3;
using cv::gmlpnp::detail::logSO3;

struct Refiner
{
    std::string name;
    int flag;
};

std::optional<Pose> from(const Refiner& refiner, const Problem& problem, const Pose& guess)
{
    const Vector3d w = logSO3(guess.R);
    cv::Vec3d rvec(w.x(), w.y(), w.z()), tvec(guess.t.x(), guess.t.y(), guess.t.z());
    try {
        if (cv::gmlpnp::solvePnP(problem.scene.objectPoints, problem.scene.imagePoints, synthetic::paperCamera(),
                                 cv::noArray(), rvec, tvec, true, refiner.flag))
            return poseOf(rvec, tvec);
    } catch (const cv::Exception&) {
    }
    return std::nullopt;
}

// The rotation by the angle, the translation by a metre per 30 degrees, both in any direction.
Pose offset(const Pose& truth, double degrees, cv::RNG& rng)
{
    const Vector3d axis = synthetic::gaussian3(rng).normalized(), way = synthetic::gaussian3(rng).normalized();
    return {expSO3(degrees * CV_PI / 180 * axis) * truth.R, truth.t + degrees / 30 * way};
}

// The same minimum: within one degree and one per cent.
bool same(const std::optional<Pose>& a, const std::optional<Pose>& b)
{
    return a && b && synthetic::columnAngle(a->R, b->R) < 1 && (a->t - b->t).norm() < 0.01 * b->t.norm();
}

}  // namespace

void runGuess(const Settings& settings)
{
    const std::vector<Refiner> refiners = {{"BA", cv::gmlpnp::SOLVEPNP_ITERATIVE},
                                           {"GMLPnP", cv::gmlpnp::SOLVEPNP_GMLPNP},
                                           {"GMLPnP marginal", cv::gmlpnp::SOLVEPNP_GMLPNP_MARGINAL}};
    const double sigmas[] = {0.02, 0.1, 0.5}, offsets[] = {0, 10, 20, 30, 45, 60, 75, 90, 120, 150, 180};
    const int trials = settings.trials;
    Progress progress("guess", static_cast<long>(std::size(sigmas) * std::size(offsets)) * trials);
    Csv csv(settings.folder, "guess",
            std::vector<std::string>{"sigma_m", "offset_deg", "solver", "trials", "solved"} +
                intervalColumns("success") + intervalColumns("rotation_deg") + intervalColumns("translation_percent"));
    int cell = 0;
    for (const double sigma : sigmas)
        for (const double degrees : offsets) {
            std::vector<std::vector<double>> rotation(refiners.size(), std::vector<double>(trials)), translation;
            translation = rotation;
            std::vector<std::vector<char>> success(refiners.size(), std::vector<char>(trials));
            forTrials(trials, settings.threads, progress, [&](int k) {
                cv::RNG rng = trialRng("guess", cell, k);
                const Problem problem = paperProblem(200, sigma, 10 * sigma)(rng);
                const Pose guess = offset(problem.scene.truth, degrees, rng);
                for (size_t s = 0; s < refiners.size(); ++s) {
                    const std::optional<Pose> pose = from(refiners[s], problem, guess);
                    const PoseErrors errors = errorsOf(pose, problem.scene.truth);
                    rotation[s][k] = errors.rotation;
                    translation[s][k] = errors.translation;
                    success[s][k] = same(pose, from(refiners[s], problem, problem.scene.truth));
                }
            });
            const Bootstrap bootstrap(trials);
            for (size_t s = 0; s < refiners.size(); ++s) {
                const int hits = static_cast<int>(std::count(success[s].begin(), success[s].end(), 1));
                csv << sigma << degrees << refiners[s].name << trials << countNumbers(rotation[s])
                    << share(hits, trials) << bootstrap.mean(rotation[s]) << bootstrap.mean(translation[s]);
                csv.endRow();
            }
            ++cell;
        }
    csv.save();
}

}  // namespace experiments
