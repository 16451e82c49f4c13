// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "experiments.hpp"

// Errors of all solvers on the same problems, one cell (noise, number of points, scene) after the other.

namespace experiments {

PoseErrors errorsOf(const std::optional<Pose>& pose, const Pose& truth)
{
    constexpr double NONE = std::numeric_limits<double>::quiet_NaN();
    if (!pose || !pose->R.allFinite() || !pose->t.allFinite())
        return {NONE, NONE, NONE};
    return {synthetic::columnAngle(pose->R, truth.R), 100 * (pose->t - truth.t).norm() / truth.t.norm(),
            (pose->R.transpose() * pose->t - truth.R.transpose() * truth.t).norm()};
}

std::optional<Pose> poseBy(const Solver& solver, const Problem& problem)
{
    try {
        return solver.solve(problem);
    } catch (const cv::Exception&) {
        return std::nullopt;
    }
}

namespace {

struct Cell
{
    std::string label;
    double x;  // what the figure has on its axis
    Draw draw;
    int trials;
};

using Metric = double PoseErrors::*;
const std::pair<const char*, Metric> METRICS[] = {{"rotation_deg", &PoseErrors::rotation},
                                                  {"translation_percent", &PoseErrors::translation},
                                                  {"centre_m", &PoseErrors::centre}};

std::vector<std::string> header()
{
    std::vector<std::string> columns = {"cell", "x", "solver", "trials", "solved"};
    for (const auto& metric : METRICS) {
        const std::string name = metric.first;
        columns = columns + intervalColumns(name) + std::vector<std::string>{name + "_median"} +
                  intervalColumns(name + "_ratio");
    }
    return columns + std::vector<std::string>{"ratio_to"};
}

std::vector<double> valuesOf(const std::vector<PoseErrors>& errors, Metric metric)
{
    std::vector<double> values;
    for (const PoseErrors& e : errors)
        values.push_back(e.*metric);
    return values;
}

void writeCell(Csv& csv, const Cell& cell, const std::vector<Solver>& solvers,
               const std::vector<std::vector<PoseErrors>>& errors, size_t reference)
{
    const Bootstrap bootstrap(cell.trials);
    for (size_t s = 0; s < solvers.size(); ++s) {
        csv << cell.label << cell.x << solvers[s].name << cell.trials
            << countNumbers(valuesOf(errors[s], &PoseErrors::rotation));
        for (const auto& metric : METRICS) {
            const std::vector<double> values = valuesOf(errors[s], metric.second);
            csv << bootstrap.mean(values) << median(values)
                << bootstrap.ratio(values, valuesOf(errors[reference], metric.second));
        }
        csv << solvers[reference].name;
        csv.endRow();
    }
}

void runCells(const std::string& name, const std::vector<Cell>& cells, bool perspective, const Settings& settings)
{
    const std::vector<Solver> solvers = solversFor(perspective);
    // Ratios refer to SQPnP, the best closed form; on rays there is only MLPnP everywhere.
    size_t reference = 0;
    while (solvers[reference].name != (perspective ? "SQPnP" : "MLPnP"))
        ++reference;
    long total = 0;
    for (const Cell& cell : cells)
        total += cell.trials;
    Progress progress(name, total);
    Csv csv(settings.folder, name, header());
    for (size_t c = 0; c < cells.size(); ++c) {
        const Cell& cell = cells[c];
        std::vector<std::vector<PoseErrors>> errors(solvers.size(), std::vector<PoseErrors>(cell.trials));
        forTrials(cell.trials, settings.threads, progress, [&](int k) {
            cv::RNG rng = trialRng(name, static_cast<int>(c), k);
            const Problem problem = cell.draw(rng);
            for (size_t s = 0; s < solvers.size(); ++s)
                errors[s][k] = errorsOf(poseBy(solvers[s], problem), problem.scene.truth);
        });
        writeCell(csv, cell, solvers, errors, reference);
    }
    csv.save();
}

}  // namespace

void runPoints(const Settings& settings)
{
    std::vector<Cell> cells;
    for (int n = 20; n <= 200; n += 20)
        cells.push_back({"n = " + std::to_string(n), double(n), paperProblem(n, 0.1, 1), settings.trials});
    runCells("points", cells, true, settings);
}

void runNoise(const Settings& settings)
{
    std::vector<Cell> cells;
    for (const double sigma : {0.02, 0.05, 0.1, 0.2, 0.3, 0.4, 0.5})
        cells.push_back({cv::format("%g m + %g px", sigma, 10 * sigma), sigma, paperProblem(50, sigma, 10 * sigma),
                         settings.trials});
    runCells("noise", cells, true, settings);
}

void runDepth(const Settings& settings)
{
    std::vector<Cell> cells;
    for (const double sigma : {0.1, 0.05, 0.02, 0.01})
        cells.push_back(
            {cv::format("%g cm + 1 px", 100 * sigma), sigma, depthProblem(100, 3, 60, sigma, 1), settings.trials});
    runCells("depth", cells, true, settings);
}

void runPixels(const Settings& settings)
{
    const int trials = settings.trials;
    runCells("pixels",
             {{"depth 0.5-5 m", 0, depthProblem(100, 0.5, 5, 0, 1), trials},
              {"depth 3-60 m", 1, depthProblem(100, 3, 60, 0, 1), trials},
              {"paper's box", 2, paperProblem(50, 0, 1), trials},
              {"object of 60 px", 3, smallProblem(400, 30, 1), trials}},
             true, settings);
}

void runWide(const Settings& settings)
{
    std::vector<Cell> cells;
    for (const int n : {20, 50, 100, 200})
        cells.push_back({"n = " + std::to_string(n), double(n), wideProblem(n, 0.05, 1), settings.trials});
    runCells("omnidir", cells, false, settings);
}

void runOutliers(const Settings& settings)
{
    std::vector<Cell> cells;
    for (const bool gross : {true, false})
        for (const double share : {0., 0.05, 0.1, 0.2, 0.3, 0.4})
            cells.push_back({gross ? "wrong pixels" : "five times the noise", share,
                             outlierProblem(100, 0.05, 1, share, gross), settings.trials});
    runCells("outliers", cells, true, settings);
}

void runConsistency(const Settings& settings)
{
    // The larger the problem, the less its error varies from the law that it shall show: trials for equal time.
    std::vector<Cell> cells;
    for (const int n : {20, 50, 100, 200, 500, 1000, 2000, 5000, 10000}) {
        const int trials = std::min(settings.trials, std::max(settings.trials / 10, settings.trials * 1000 / n));
        cells.push_back({"n = " + std::to_string(n), double(n), paperProblem(n, 0.1, 1), std::max(trials, 2)});
    }
    runCells("consistency", cells, true, settings);
}

}  // namespace experiments
