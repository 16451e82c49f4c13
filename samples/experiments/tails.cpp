// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "experiments.hpp"
#include "src/estimator/initial_pose.hpp"
#include "src/estimator/kinds_of_noise.hpp"

// What the estimated tails cost on Gaussian data, and whether they reach the best Student-t of fixed degrees of freedom
// where some of the points have five times the noise, and where the noise is a Student-t.

namespace experiments {

namespace {

using namespace cv::gmlpnp::detail;

constexpr int GAUSSIAN = 0, FIXED[] = {GAUSSIAN, 30, 10, 5, 3, 2};
constexpr size_t COUNT = std::size(FIXED) + 1;  // then the estimated

std::string nameOf(size_t method)
{
    if (method == std::size(FIXED))
        return "estimated";
    return FIXED[method] == GAUSSIAN ? "Gaussian" : cv::format("ν = %d", FIXED[method]);
}

Estimate fitBy(size_t method, const Correspondences& data, const Pose& start)
{
    FitOptions options{defaultLimits(false)};
    options.tails = method == std::size(FIXED);
    const bool student = !options.tails && FIXED[method] != GAUSSIAN;
    return fitMarginal(Subsets(data), start, std::nullopt, std::nullopt, options,
                       student ? Tails{1, 1, FIXED[method]} : Tails());
}

std::array<PoseErrors, COUNT> errorsOfAll(const Problem& problem)
{
    const Correspondences data(problem.scene.objectPoints, problem.scene.rays);
    const std::vector<PoseCandidate> starts = initialPoses(data);
    if (starts.empty())
        throw std::runtime_error("tails: a problem without a pose");
    std::array<PoseErrors, COUNT> errors;
    for (size_t m = 0; m < COUNT; ++m) {
        const cv::gmlpnp::detail::Estimate found = fitBy(m, data, starts.front().pose);
        errors[m] = errorsOf(data.toObject(found.pose), problem.scene.truth);
    }
    return errors;
}

struct Kind
{
    std::string name;
    std::function<Draw(int n)> problem;
};

std::vector<Kind> kindsOfNoise()
{
    std::vector<Kind> kinds;
    for (const double share : {0., 0.05, 0.1, 0.2})
        kinds.push_back(
            {cv::format("%g %%", 100 * share), [=](int n) { return outlierProblem(n, 0.1, 1, share, false); }});
    for (const int dof : {3, 2})
        kinds.push_back({cv::format("Student-t of %d", dof), [=](int n) { return studentProblem(n, 0.1, 1, dof); }});
    return kinds;
}

}  // namespace

void runTails(const Settings& settings)
{
    const std::vector<Kind> kinds = kindsOfNoise();
    const int sizes[] = {20, 50, 200};
    const int trials = settings.trials;
    Progress progress("tails", static_cast<long>(kinds.size() * std::size(sizes)) * trials);
    Csv csv(settings.folder, "tails",
            std::vector<std::string>{"noise", "x", "tails", "trials"} + intervalColumns("rotation_deg_ratio") +
                intervalColumns("translation_percent_ratio"));
    int cell = 0;
    for (const Kind& kind : kinds)
        for (const int n : sizes) {
            const Draw draw = kind.problem(n);
            std::vector<std::vector<double>> rotation(COUNT, std::vector<double>(trials)), translation = rotation;
            forTrials(trials, settings.threads, progress, [&](int k) {
                cv::RNG rng = trialRng("tails", cell, k);
                const std::array<PoseErrors, COUNT> errors = errorsOfAll(draw(rng));
                for (size_t m = 0; m < COUNT; ++m) {
                    rotation[m][k] = errors[m].rotation;
                    translation[m][k] = errors[m].translation;
                }
            });
            const Bootstrap bootstrap(trials);
            for (size_t m = 0; m < COUNT; ++m) {
                csv << kind.name << n << nameOf(m) << trials << bootstrap.ratio(rotation[m], rotation[0])
                    << bootstrap.ratio(translation[m], translation[0]);
                csv.endRow();
            }
            ++cell;
        }
    csv.save();
}

}  // namespace experiments
