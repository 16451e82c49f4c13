// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

// RANSAC of this module beside that of OpenCV: how often the pose is right, how good it is then, and how long it takes.
// All methods solve the same problems in one run; Markdown tables go to the standard output, progress to the other.
//
//   bench_ransac [--scale=1]    --scale: share of the problems, for a quick look

#include <opencv2/core/utility.hpp>
#include <opencv2/gmlpnp.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "common/output_file.hpp"
#include "measuring.hpp"

namespace {

// --- Problems ---

struct Noise
{
    const char* name;
    double object;  // m, standard deviation of each coordinate
    double pixel;   // px, likewise
};

const Noise NOISES[] = {{"object noise, 2 cm", 0.02, 0}, {"pixel noise, 1 px", 0, 1}, {"both", 0.02, 1}};
const int SIZES[] = {50, 200, 1000, 5000};
const double OUTLIERS[] = {0.1, 0.4, 0.6, 0.8};

int problemsOf(int n)
{
    return n <= 200 ? 100 : n <= 1000 ? 60 : 30;
}

const cv::Matx33d K(800, 0, 320, 0, 800, 240, 0, 0, 1);  // px
const float THRESHOLD = 8;                               // px, OpenCV's default
const double CONFIDENCE = 0.99;                          // likewise
const int ITERATIONS = 1000;                             // at most; 600 samples of three are enough at 80 % of outliers

struct Problem
{
    std::vector<cv::Point3d> objectPoints;
    std::vector<cv::Point2d> imagePoints;
    cv::Matx33d R;
    cv::Vec3d t;
};

// The box of the paper's protocol, [-2, 2] x [-2, 2] x [4, 8] m before the camera, seen from a random pose. A wrong
// correspondence has a pixel anywhere in the picture of the box.
Problem makeProblem(int n, double outliers, const Noise& noise, int index)
{
    cv::RNG rng(static_cast<uint64>(index) * 1000003 + static_cast<uint64>(n) * 101 +
                static_cast<uint64>(100 * outliers));
    Problem problem;
    problem.R = randomRotation(rng);
    problem.t = cv::Vec3d(rng.uniform(-1., 1.), rng.uniform(-1., 1.), 6);
    for (int i = 0; i < n; ++i) {
        const cv::Vec3d X(rng.uniform(-2., 2.), rng.uniform(-2., 2.), rng.uniform(4., 8.));
        const cv::Vec3d e(rng.gaussian(1), rng.gaussian(1), rng.gaussian(1));
        problem.objectPoints.emplace_back(problem.R.t() * (X - problem.t) + noise.object * e);
        const double u = rng.gaussian(1), v = rng.gaussian(1);
        const cv::Vec3d x = K * X;
        cv::Point2d pixel(x[0] / x[2] + noise.pixel * u, x[1] / x[2] + noise.pixel * v);
        const cv::Point2d wrong(rng.uniform(-80., 720.), rng.uniform(-160., 640.));
        problem.imagePoints.push_back(i < std::lround(outliers * n) ? wrong : pixel);
    }
    return problem;
}

// --- Methods ---

template <int flags>
bool solveByOpenCV(const Problem& problem, cv::Vec3d& rvec, cv::Vec3d& tvec)
{
    cv::Mat r, t, inliers;
    const bool found = cv::solvePnPRansac(problem.objectPoints, problem.imagePoints, K, cv::noArray(), r, t, false,
                                          ITERATIONS, THRESHOLD, CONFIDENCE, inliers, flags);
    if (found && r.total() == 3 && t.total() == 3) {
        r.copyTo(rvec);
        t.copyTo(tvec);
    }
    return found;
}

bool solveByUs(const Problem& problem, cv::Vec3d& rvec, cv::Vec3d& tvec)
{
    cv::Mat inliers;
    return cv::gmlpnp::solvePnPRansac(problem.objectPoints, problem.imagePoints, K, cv::noArray(), rvec, tvec, false,
                                      ITERATIONS, THRESHOLD, CONFIDENCE, inliers);
}

struct Method
{
    const char* name;
    bool (*solve)(const Problem&, cv::Vec3d& rvec, cv::Vec3d& tvec);
};

const Method METHODS[] = {
    {"gmlpnp", solveByUs},  // ours stands first
    {"default", solveByOpenCV<cv::SOLVEPNP_ITERATIVE>},
    {"USAC_DEFAULT", solveByOpenCV<cv::USAC_DEFAULT>},
    {"USAC_ACCURATE", solveByOpenCV<cv::USAC_ACCURATE>},
    {"USAC_MAGSAC", solveByOpenCV<cv::USAC_MAGSAC>},
};
const size_t METHOD_COUNT = sizeof(METHODS) / sizeof(METHODS[0]);

// --- Measurement ---

struct Outcome
{
    bool right;
    double rotation;     // degrees
    double translation;  // % of the distance
    double milliseconds;
};

// A pose counts as right below these errors: several times those of the noise, far below those of a wrong consensus.
const double RIGHT_ROTATION = 5, RIGHT_TRANSLATION = 10;  // degrees, %

Outcome measure(const Method& method, const Problem& problem)
{
    cv::Vec3d rvec, tvec;
    const double start = threadSeconds();
    bool found = false;
    try {
        found = method.solve(problem, rvec, tvec);
    } catch (const cv::Exception&) {  // what OpenCV says of some degenerate samples
    }
    Outcome outcome{false, 0, 0, 1e3 * (threadSeconds() - start)};
    if (!found)
        return outcome;
    cv::Matx33d R;
    cv::Rodrigues(rvec, R);
    cv::Vec3d difference;
    cv::Rodrigues(R * problem.R.t(), difference);
    outcome.rotation = cv::norm(difference) * 180 / CV_PI;
    outcome.translation = 100 * cv::norm(tvec - problem.t) / cv::norm(problem.t);
    outcome.right = outcome.rotation < RIGHT_ROTATION && outcome.translation < RIGHT_TRANSLATION;
    return outcome;
}

struct Summary
{
    int right = 0, total = 0;
    double low = 0, high = 1;              // Wilson interval of the share of right poses, 95 %
    double rotation = 0, translation = 0;  // means over the right poses
    double milliseconds = 0;               // median
};

Summary summarise(const std::vector<Outcome>& outcomes)
{
    Summary summary;
    std::vector<double> times;
    for (const Outcome& outcome : outcomes) {
        ++summary.total;
        times.push_back(outcome.milliseconds);
        if (!outcome.right)
            continue;
        ++summary.right;
        summary.rotation += outcome.rotation;
        summary.translation += outcome.translation;
    }
    summary.rotation /= summary.right;
    summary.translation /= summary.right;
    summary.milliseconds = median(times);
    const double z = 1.96, n = summary.total, p = summary.right / n;
    const double centre = (p + z * z / (2 * n)) / (1 + z * z / n);
    const double half = z / (1 + z * z / n) * std::sqrt(p * (1 - p) / n + z * z / (4 * n * n));
    summary.low = std::max(0., centre - half);
    summary.high = std::min(1., centre + half);
    return summary;
}

// Mean errors of method `a` over those of method `b`, on the problems that both got right; 0 where there are none.
void errorRatios(const std::vector<Outcome>& a, const std::vector<Outcome>& b, double& rotation, double& translation)
{
    double sums[4] = {};
    for (size_t i = 0; i < a.size(); ++i) {
        if (!a[i].right || !b[i].right)
            continue;
        sums[0] += a[i].rotation;
        sums[1] += b[i].rotation;
        sums[2] += a[i].translation;
        sums[3] += b[i].translation;
    }
    rotation = sums[1] > 0 ? sums[0] / sums[1] : 0;
    translation = sums[3] > 0 ? sums[2] / sums[3] : 0;
}

// --- Report ---

struct Tally
{
    int cells = 0, success = 0, accuracy = 0, time = 0;
    std::vector<std::string> behind;
};

// Ahead: at least as many right poses; smaller errors on the same problems; less time. Against every other method.
void compare(const std::string& cell, const std::vector<std::vector<Outcome>>& outcomes,
             const std::vector<Summary>& summaries, Tally& tally)
{
    bool success = true, accuracy = true, time = true;
    std::string notes;
    for (size_t m = 1; m < METHOD_COUNT; ++m) {
        double rotation, translation;
        errorRatios(outcomes[0], outcomes[m], rotation, translation);
        if (summaries[0].right < summaries[m].right) {
            success = false;
            notes +=
                cv::format("; %s has %d right poses, ours %d", METHODS[m].name, summaries[m].right, summaries[0].right);
        }
        if (rotation >= 1 || translation >= 1) {
            accuracy = false;
            notes += cv::format("; errors are %.2f (rotation) and %.2f (translation) times those of %s", rotation,
                                translation, METHODS[m].name);
        }
        if (summaries[0].milliseconds >= summaries[m].milliseconds) {
            time = false;
            notes += cv::format("; %.1f times the time of %s", summaries[0].milliseconds / summaries[m].milliseconds,
                                METHODS[m].name);
        }
    }
    ++tally.cells;
    tally.success += success;
    tally.accuracy += accuracy;
    tally.time += time;
    if (!notes.empty())
        tally.behind.push_back(cell + ": " + notes.substr(2));
}

void printRow(int n, double outliers, const std::vector<Summary>& summaries)
{
    std::printf("| %d | %.0f |", n, 100 * outliers);
    for (const Summary& summary : summaries) {
        std::printf(" %.0f (%.0f–%.0f)", 100. * summary.right / summary.total, 100 * summary.low, 100 * summary.high);
        if (summary.right > 0)
            std::printf(" · %.3f° · %.3f", summary.rotation, summary.translation);
        std::printf(" · %.2f ms |", summary.milliseconds);
    }
    std::printf("\n");
    std::fflush(stdout);
}

void runNoise(const Noise& noise, double scale, Tally& tally)
{
    std::printf("\n### %s\n\n| n | outliers %% |", noise.name);
    for (const Method& method : METHODS)
        std::printf(" %s |", method.name);
    std::printf("\n|--:|--:|");
    for (size_t m = 0; m < METHOD_COUNT; ++m)
        std::printf("---|");
    std::printf("\n");
    for (const int n : SIZES)
        for (const double outliers : OUTLIERS) {
            const int problems = std::max(1, static_cast<int>(std::lround(scale * problemsOf(n))));
            std::vector<std::vector<Outcome>> outcomes(METHOD_COUNT);
            for (int i = 0; i < problems; ++i) {
                const Problem problem = makeProblem(n, outliers, noise, i);
                for (size_t k = 0; k < METHOD_COUNT; ++k) {
                    const size_t m = (k + static_cast<size_t>(i)) % METHOD_COUNT;  // nobody is always first
                    outcomes[m].push_back(measure(METHODS[m], problem));
                }
            }
            std::vector<Summary> summaries;
            for (const auto& each : outcomes)
                summaries.push_back(summarise(each));
            printRow(n, outliers, summaries);
            const std::string cell = cv::format("%s, n = %d, %.0f %%", noise.name, n, 100 * outliers);
            compare(cell, outcomes, summaries, tally);
            std::fprintf(stderr, "%s done\n", cell.c_str());
        }
}

// How often a pose is claimed where there is none: random points and random pixels.
void printChance(double scale)
{
    std::printf("| n | poses claimed |\n|--:|--:|\n");
    for (const int n : {5, 6, 8, 10, 20, 50, 200, 1000}) {
        const int count = std::max(1, static_cast<int>(scale * (n <= 10 ? 4000 : n <= 200 ? 2000 : 300)));
        int claimed = 0;
        cv::RNG rng(static_cast<uint64>(n));
        for (int k = 0; k < count; ++k) {
            std::vector<cv::Point3d> points;
            std::vector<cv::Point2d> pixels;
            for (int i = 0; i < n; ++i) {
                points.emplace_back(rng.uniform(-2., 2.), rng.uniform(-2., 2.), rng.uniform(-2., 2.));
                pixels.emplace_back(rng.uniform(0., 640.), rng.uniform(0., 480.));
            }
            cv::Vec3d rvec, tvec;
            claimed += cv::gmlpnp::solvePnPRansac(points, pixels, K, cv::noArray(), rvec, tvec);
        }
        std::printf("| %d | %d of %d |\n", n, claimed, count);
        std::fflush(stdout);
    }
}

void printComparison(double scale)
{
    std::printf(
        "OpenCV %s; threshold %.0f px, confidence %.2f, at most %d iterations. Per method: right poses in %% (95 %% "
        "interval) · mean rotation error · mean translation error in %% · median time.\n",
        CV_VERSION, static_cast<double>(THRESHOLD), CONFIDENCE, ITERATIONS);
    Tally tally;
    for (const Noise& noise : NOISES)
        runNoise(noise, scale, tally);
    std::printf("\n### Ahead of all four\n\nOf %d cells: right poses %d, both errors %d, time %d. Not in these:\n\n",
                tally.cells, tally.success, tally.accuracy, tally.time);
    for (const std::string& line : tally.behind)
        std::printf("- %s\n", line.c_str());
}

}  // namespace

int main(int argc, char** argv)
try {
    const cv::CommandLineParser arguments(
        argc, argv, "{help||}{scale|1|share of the problems}{chance||count the poses of data without one instead}");
    const double scale = arguments.get<double>("scale");
    cv::setNumThreads(1);
    if (arguments.has("help")) {
        arguments.printMessage();
    } else if (!arguments.check() || !(scale > 0)) {
        std::fprintf(stderr, "bench_ransac: --scale must be a positive number\n");
        return 2;
    } else if (arguments.has("chance")) {
        printChance(scale);
    } else {
        printComparison(scale);
    }
    files::flushStandardOutput();
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "bench_ransac: %s\n", error.what());
    return 1;
}
