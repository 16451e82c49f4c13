// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "common/study.hpp"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <stdexcept>

#include "common/output_file.hpp"
#include "common/progress.hpp"

namespace samples {

const char* const kStudyKeys =
    "{methods        |    | only these, separated by commas, of EPNP,ITERATIVE,SQPNP,SQPNP+LM,ISOTROPIC,BEARING,GMLPNP,"
    "GMLPNP_MARGINAL}"
    "{output o       |    | folder for tables and errors; it is made. samples/python/draw.py draws what is in it}"
    "{residuals      |    | also test the residuals under the true motion for isotropy; with --output write them}"
    "{repeat         | 1  | calls per method and pair; the time is their median}"
    "{seed           | 1  | of RANSAC, bootstrap and test}";

namespace {

std::vector<Method> methodsOf(const std::string& names)
{
    if (names.empty())
        return comparedMethods();
    std::vector<Method> methods;
    std::istringstream stream(names);
    for (std::string name; std::getline(stream, name, ',');) {
        const auto& all = comparedMethods();
        const auto method = std::find_if(all.begin(), all.end(), [&](const Method& m) { return m.name == name; });
        if (method == all.end())
            throw std::runtime_error("--methods: unknown method '" + name + "'");
        methods.push_back(*method);
    }
    return methods;
}

void writeText(const std::string& path, const std::string& text)
{
    files::writeFile(path, [&](std::ostream& out) { out << text; });
}

Trial runTrial(const Study& study, const StudyOptions& options, size_t pair, std::vector<TrueResidual>& residuals)
{
    Trial trial;
    trial.name = study.pairs[pair];
    CorrespondenceSet set;
    try {
        set = study.correspondences(pair);
    } catch (const TooFewMatches& failure) {
        trial.failure = failure.what();
        return trial;
    }
    trial.points = set.objectPoints.size();
    for (const Method& method : options.methods) {
        Outcome outcome;
        outcome.estimate = estimatePose(set, method, options.repeat);
        if (outcome.estimate.solved && study.errors)
            outcome.errors = study.errors(outcome.estimate.pose(), set.truth);
        trial.outcomes.push_back(outcome);
    }
    if (options.residuals)
        addTrueResiduals(set, pair, residuals);
    if (study.visit)
        study.visit(pair, set, trial.outcomes);
    return trial;
}

//! The pairs without correspondences, and why.
std::string failuresOf(const Comparison& comparison)
{
    std::ostringstream out;
    for (const Trial& trial : comparison.trials)
        if (!trial.failure.empty())
            out << "Failed: " << trial.name << ": " << trial.failure << "\n";
    return out.str();
}

std::string reportOf(const Study& study, const StudyOptions& options, const Comparison& comparison)
{
    std::ostringstream out;
    size_t points = 0, failed = 0;
    for (const Trial& trial : comparison.trials) {
        points += trial.points;
        failed += trial.failure.empty() ? 0 : 1;
    }
    const size_t pairs = comparison.trials.size();
    out << study.title << ": " << pairs << " pairs, " << failed << " without correspondences; "
        << points / std::max<size_t>(1, pairs - failed) << " points in the others on average\n\n";
    printErrors(out, comparison, static_cast<uint64_t>(options.seed));
    if (!study.quantities.empty())
        printDifferences(out, comparison, static_cast<uint64_t>(options.seed));
    return out.str();
}

void reportResiduals(const Study& study, const StudyOptions& options, const std::vector<TrueResidual>& residuals)
{
    const Isotropy isotropy = testIsotropy(residuals, static_cast<uint64_t>(options.seed));
    std::ostringstream out;
    printIsotropy(out, isotropy, study.frame, study.unit);
    std::cout << out.str();
    if (options.output.empty())
        return;
    writeText(options.output + "/residuals.md", out.str());
    writeTrueResiduals(options.output + "/residuals.csv", residuals, isotropy,
                       {study.title + ": residuals under the true motion", study.frame, "m", study.pairs});
}

}  // namespace

StudyOptions studyOptions(const Arguments& arguments)
{
    StudyOptions options;
    options.output = arguments.get<std::string>("output");
    options.seed = arguments.get<int>("seed");
    options.repeat = arguments.get<int>("repeat");
    options.residuals = arguments.options.has("residuals");
    options.methods = methodsOf(arguments.get<std::string>("methods"));
    if (options.repeat < 1 || options.seed < 0)
        throw std::runtime_error("--repeat must be positive and --seed not negative");
    std::error_code error;
    if (!options.output.empty() && !std::filesystem::is_directory(options.output) &&
        !std::filesystem::create_directories(options.output, error))
        throw std::runtime_error(options.output + ": cannot be made a folder");
    return options;
}

void measureMotion(Study& study)
{
    study.quantities = {{"rotation", "deg", 4}, {"translation", "cm", 3}};
    study.errors = [](const Pose& estimate, const Pose& truth) {
        return std::vector<double>{rotationErrorDegrees(estimate, truth), 100.0 * positionError(estimate, truth)};
    };
    study.frame = {"camera frame of the first picture", {"x", "y", "z"}};
}

int runStudy(const Study& study, const StudyOptions& options)
{
    cv::setNumThreads(1);  // the time of the calling thread is then the whole time
    Comparison comparison{study.quantities, options.methods, {}};
    std::vector<TrueResidual> residuals;
    {
        Progress progress(study.pairs.size(), "pairs");
        for (size_t pair = 0; pair < study.pairs.size(); ++pair) {
            comparison.trials.push_back(runTrial(study, options, pair, residuals));
            progress.step();
        }
    }
    const std::string report = reportOf(study, options, comparison), failures = failuresOf(comparison);
    std::cout << report;
    std::cerr << failures;
    if (!options.output.empty()) {
        writeText(options.output + "/table.md", report + failures);
        writeComparison(options.output + "/errors.csv", comparison, study.title);
    }
    const bool any = std::any_of(comparison.trials.begin(), comparison.trials.end(),
                                 [](const Trial& trial) { return trial.failure.empty(); });
    if (!any) {
        std::cerr << "none of " << study.pairs.size() << " pairs gave correspondences" << std::endl;
        return 1;
    }
    if (options.residuals)
        reportResiduals(study, options, residuals);
    return 0;
}

}  // namespace samples
