// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

// The paper's synthetic experiments and some beyond them, as CSV files: errors of all solvers of its Table I on the
// same problems, with 95 % intervals. scripts/figures.sh draws them; doc/lab/experiments.md says what they show.

#include <filesystem>
#include <iostream>
#include <thread>

#include "common/command_line.hpp"
#include "experiments.hpp"

namespace {

using namespace experiments;

const char* const kKeys =
    "{help h usage ? |             | print this help}"
    "{@experiments   |             | names from the list below, one or more, or all}"
    "{trials         | 500         | problems per cell}"
    "{threads        | 0           | worker threads, 0: one per core; they do not change the results}"
    "{out            | experiments | folder for the CSV files, created if missing}";

std::string about()
{
    std::string text = "The experiments of the paper, and beyond. Experiments:\n";
    for (const Experiment& experiment : allExperiments())
        text += cv::format("  %-12s %s\n", experiment.name.c_str(), experiment.about.c_str());
    text += cv::format("UPnP (OpenGV): %s.\n", baselines::haveUpnp() ? "built in" : "absent, OpenGV was not found");
    return text;
}

std::vector<Experiment> chosen(const std::vector<std::string>& names)
{
    std::vector<Experiment> experiments;
    for (const std::string& name : names) {
        const size_t before = experiments.size();
        for (const Experiment& experiment : allExperiments())
            if (name == "all" || name == experiment.name)
                experiments.push_back(experiment);
        if (experiments.size() == before)
            throw std::runtime_error("unknown experiment '" + name + "'; --help lists them");
    }
    return experiments;
}

int run(const samples::Arguments& arguments)
{
    cv::setNumThreads(1);  // the trials are parallel, not the solvers
    const std::vector<Experiment> experiments = chosen(arguments.files);
    Settings settings;
    settings.trials = arguments.get<int>("trials");
    settings.threads = arguments.get<int>("threads");
    settings.folder = arguments.get<std::string>("out");
    if (settings.trials < 2)
        throw std::runtime_error("--trials must be at least 2");
    if (settings.threads < 0)
        throw std::runtime_error("--threads must not be negative");
    if (settings.threads == 0)
        settings.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    std::filesystem::create_directories(settings.folder);
    for (const Experiment& experiment : experiments)
        experiment.run(settings);
    return 0;
}

}  // namespace

namespace experiments {

const std::vector<Experiment>& allExperiments()
{
    static const std::vector<Experiment> experiments = {
        {"points", "error against the number of points (20-200, 0.1 m, 1 px)", runPoints},
        {"noise", "error against noise (n = 50, 0.02-0.5 m, 0.2-5 px)", runNoise},
        {"time", "CPU time against the number of points, one thread", runTime},
        {"guess", "from the truth plus a growing offset (n = 200): success and error", runGuess},
        {"rounds", "determinant and Frobenius error of the estimated covariance over rounds", runRounds},
        {"case", "one problem: its noise, the residuals, the covariances", runCase},
        {"covariance", "error of the estimated covariance against the number of points", runCovariance},
        {"consistency", "error up to n = 10000", runConsistency},
        {"depth", "depths from 3 to 60 m: object and pixel noise that differ by point", runDepth},
        {"pixels", "pixel noise only", runPixels},
        {"omnidir", "a lens of 220 degrees", runWide},
        {"outliers", "wrong pixels, and points of five times the noise", runOutliers},
        {"coverage", "how often the 95 % ellipsoid of the pose holds the truth", runCoverage},
        {"recovery", "the noise that comes out against the noise that went in", runRecovery},
        {"small", "4 to 14 points: the default against isotropic noise", runSmall},
        {"bias", "mean errors and signed depth errors: small objects, mixed noise", runBias},
        {"tails", "estimated degrees of freedom against fixed ones", runTails},
    };
    return experiments;
}

}  // namespace experiments

int main(int argc, char** argv)
{
    return samples::runProgram(argc, argv, kKeys, about(), 1, run);
}
