// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

// Random problems from ordinary to hostile, through our functions and OpenCV's: what comes back, counted.
// doc/reliability.md holds the table of a million.

#include <filesystem>
#include <iostream>
#include <thread>

#include <opencv2/core/utils/logger.hpp>

#include "common/command_line.hpp"
#include "common/table.hpp"
#include "csv.hpp"
#include "sweep.hpp"

namespace {

using namespace reliability;

const char* const kAbout =
    "Random problems, from ordinary to hostile, through cv::gmlpnp and cv::solvePnP: what comes back, counted.\n"
    "The columns are explained in doc/reliability.md.\n";

const char* const kKeys =
    "{help h usage ? |         | print this help}"
    "{problems       | 1000000 | how many}"
    "{searched       | 0       | of them compared with a search from random rotations, the first so many}"
    "{starts         | 50      | rotations of a search}"
    "{seed           | 1       | equal seeds, equal problems}"
    "{threads        | 0       | worker threads, 0: one per core; they do not change the results}"
    "{out            |         | folder for reliability.csv and failures.csv, created if missing; empty: none}";

std::string share(long count, long of)
{
    if (of == 0)
        return "-";
    return count == 0 ? "0" : cv::format("%ld (%.2g)", count, static_cast<double>(count) / static_cast<double>(of));
}

// The columns of the table and of its file.
struct Column
{
    const char* title;
    const char* name;
    long Tally::*count;
    long Tally::*of;  // null: a total
    bool searchOnly;
};

constexpr Column COLUMNS[] = {
    {"calls", "calls", &Tally::calls, nullptr, false},
    {"true", "true", &Tally::solved, nullptr, false},
    {"(a) bad pose", "bad_pose", &Tally::badPose, &Tally::calls, false},
    {"bad result", "bad_result", &Tally::badResult, &Tally::calls, false},
    {"(b) other exception", "other_exception", &Tally::foreignException, &Tally::calls, false},
    {"(b) input changed", "input_changed", &Tally::inputChanged, &Tally::calls, false},
    {"output touched", "output_touched", &Tally::outputTouched, &Tally::calls, false},
    {"cv::Exception", "exception", &Tally::threw, &Tally::calls, false},
    {"solvable", "solvable", &Tally::solvable, nullptr, false},
    {"(c) refused", "refused", &Tally::refused, &Tally::solvable, false},
    {"lost", "lost", &Tally::lost, &Tally::solvable, false},
    {"searched", "searched", &Tally::searched, nullptr, true},
    {"(d) above", "above", &Tally::above, &Tally::searched, true},
    {"unsolvable", "searched_unsolvable", &Tally::searchedUnsolvable, nullptr, true},
    {"above", "above_unsolvable", &Tally::aboveUnsolvable, &Tally::searchedUnsolvable, true},
};

std::string cell(const Column& column, const Tally& tally, bool searched)
{
    if (column.searchOnly && !searched)
        return "";
    return column.of == nullptr ? std::to_string(tally.*column.count) : share(tally.*column.count, tally.*column.of);
}

void print(const Sweep& sweep)
{
    std::vector<std::string> title = {""};
    for (const Column& column : COLUMNS)
        title.emplace_back(column.title);
    samples::Table table(title);
    for (size_t s = 0; s < allSolvers().size(); ++s) {
        std::vector<std::string> row = {allSolvers()[s].name};
        for (const Column& column : COLUMNS)
            row.push_back(cell(column, sweep.tallies[s], s == SEARCHED_SOLVER));
        table.add(row);
    }
    table.printMarkdown(std::cout);
}

void save(const Sweep& sweep, const std::string& folder)
{
    std::vector<std::string> names = {"function"};
    for (const Column& column : COLUMNS)
        names.emplace_back(column.name);
    experiments::Csv counts(folder, "reliability", names);
    for (size_t s = 0; s < allSolvers().size(); ++s) {
        counts << "\"" + allSolvers()[s].name + "\"";
        for (const Column& column : COLUMNS)
            counts << std::to_string(sweep.tallies[s].*column.count);
        counts.endRow();
    }
    counts.save();
}

void saveFailures(const Sweep& sweep, int seed, const std::string& folder)
{
    experiments::Csv csv(
        folder, "failures",
        {"index", "function", "what", "above", "shape", "n", "scale", "offset", "thickness", "distance", "object_noise",
         "ray_noise", "outliers", "guess", "corrupt", "condition", "rotation_deviation", "centre_deviation"});
    for (const Failure& failure : sweep.failures) {
        const Problem p = randomProblem(seed, failure.index);
        csv << failure.index << "\"" + allSolvers()[failure.solver].name + "\"" << failure.what << failure.above
            << nameOf(p.shape) << p.n << p.scale << p.offset << p.thickness << p.distance << p.objectNoise << p.rayNoise
            << p.outliers << nameOf(p.guess) << static_cast<int>(p.corrupt) << p.condition << p.rotationDeviation
            << p.centreDeviation;
        csv.endRow();
    }
    csv.save();
}

int run(const samples::Arguments& arguments)
{
    cv::setNumThreads(1);  // the problems are parallel, not the solvers
    cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
    Settings settings;
    settings.problems = arguments.get<int>("problems");
    settings.searched = arguments.get<int>("searched");
    settings.starts = arguments.get<int>("starts");
    settings.seed = arguments.get<int>("seed");
    settings.threads = arguments.get<int>("threads");
    if (settings.problems < 1)
        throw std::runtime_error("--problems must be at least 1");
    if (settings.searched < 0 || settings.starts < 1)
        throw std::runtime_error("--searched must not be negative, --starts at least 1");
    if (settings.threads < 0)
        throw std::runtime_error("--threads must not be negative");
    if (settings.threads == 0)
        settings.threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    const std::string folder = arguments.get<std::string>("out");
    if (!folder.empty())
        std::filesystem::create_directories(folder);
    const Sweep found = sweep(settings);
    print(found);
    if (!folder.empty()) {
        save(found, folder);
        saveFailures(found, settings.seed, folder);
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv)
{
    return samples::runProgram(argc, argv, kKeys, kAbout, 0, run);
}
