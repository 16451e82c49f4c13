// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include <ctime>

#include "experiments.hpp"

namespace experiments {

namespace {

double threadMicroseconds()
{
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e6 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_nsec);
}

// Shortest of a few calls: what disturbs a call only makes it longer.
double microseconds(const Solver& solver, const Problem& problem)
{
    constexpr int CALLS = 3;
    double shortest = std::numeric_limits<double>::infinity();
    for (int call = 0; call < CALLS; ++call) {
        const double start = threadMicroseconds();
        const std::optional<Pose> pose = poseBy(solver, problem);
        const double time = threadMicroseconds() - start;
        if (!pose)
            return std::numeric_limits<double>::quiet_NaN();  // giving up is not solving fast
        shortest = std::min(shortest, time);
    }
    return shortest;
}

}  // namespace

void runTime(const Settings& settings)
{
    constexpr int MOST_PROBLEMS = 50;
    const int sizes[] = {20, 50, 100, 150, 200, 500, 1000};
    const int problems = std::min(settings.trials, MOST_PROBLEMS);
    const std::vector<Solver> solvers = solversFor(true);
    Progress progress("time", static_cast<long>(std::size(sizes)) * problems);
    Csv csv(settings.folder, "time",
            std::vector<std::string>{"x", "solver", "problems", "solved", "us_median"} + intervalColumns("us"));
    for (const int n : sizes) {
        std::vector<std::vector<double>> times(solvers.size(), std::vector<double>(problems));
        // One thread whatever the settings: the cores share their caches and their clock.
        forTrials(problems, 1, progress, [&](int k) {
            cv::RNG rng = trialRng("time", n, k);
            const Problem problem = paperProblem(n, 0.1, 1)(rng);
            for (size_t s = 0; s < solvers.size(); ++s)
                times[s][k] = microseconds(solvers[s], problem);
        });
        const Bootstrap bootstrap(problems);
        for (size_t s = 0; s < solvers.size(); ++s) {
            csv << n << solvers[s].name << problems << countNumbers(times[s]) << median(times[s])
                << bootstrap.mean(times[s]);
            csv.endRow();
        }
    }
    csv.save();
}

}  // namespace experiments
