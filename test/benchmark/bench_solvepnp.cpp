// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

// CPU time of the solvers on the synthetic problems of the paper, one thread.
//
//   bench_solvepnp             absolute times, by Google Benchmark and its options
//   bench_solvepnp --ratios    a Markdown table of times relative to SQPNP
//   bench_solvepnp --batch     how much faster solveBatch is on several threads, by the clock on the wall
//
// The ratios come from paired measurements: within a repetition each method solves the same problems one after the
// other, so that a change of the clock or a noisy neighbour meets all of them; the table shows the medians of the
// repetitions' ratios. Google Benchmark knows no pairs, hence the two modes.

#include <benchmark/benchmark.h>

#include <opencv2/core/utility.hpp>
#include <opencv2/gmlpnp.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/output_file.hpp"
#include "measuring.hpp"

namespace {

const int SIZES[] = {20, 50, 100, 200, 1000, 10000};  // points of a problem
const int PROBLEMS = 10;                              // problems of each size
const int REPETITIONS = 31;                           // of the paired measurement; odd, so that the median is one

// --- Problems ---

struct Problem
{
    std::vector<cv::Point3d> objectPoints;
    std::vector<cv::Point2d> imagePoints;
};

const cv::Matx33d K(800, 0, 320, 0, 800, 240, 0, 0, 1);  // px; 640 x 480
const double OBJECT_NOISE = 0.1;                         // m, the largest standard deviation of the three
const double IMAGE_NOISE = 1;                            // px, the larger one of the two

// Points uniform in [-2, 2] x [-2, 2] x [4, 8] m of the camera frame; the object frame has its origin in their centre
// and any orientation; anisotropic Gaussian noise on points and pixels.
Problem makeProblem(int n, int index)
{
    cv::RNG rng(static_cast<uint64>(1000 * n + index + 1));
    const cv::Matx33d camFromObj = randomRotation(rng), noiseAxes = randomRotation(rng);
    const cv::Vec3d deviations(OBJECT_NOISE, rng.uniform(0., OBJECT_NOISE), rng.uniform(0., OBJECT_NOISE));
    const double angle = rng.uniform(0., CV_PI), c = std::cos(angle), s = std::sin(angle);
    const double minorDeviation = rng.uniform(0., IMAGE_NOISE);

    std::vector<cv::Vec3d> camPoints;
    cv::Vec3d centre;
    for (int i = 0; i < n; ++i) {
        camPoints.emplace_back(rng.uniform(-2., 2.), rng.uniform(-2., 2.), rng.uniform(4., 8.));
        centre += camPoints.back() * (1. / n);
    }

    Problem problem;
    for (const cv::Vec3d& X : camPoints) {
        const cv::Vec3d noise(rng.gaussian(deviations[0]), rng.gaussian(deviations[1]), rng.gaussian(deviations[2]));
        problem.objectPoints.emplace_back(camFromObj.t() * (X - centre) + noiseAxes * noise);
        const double a = rng.gaussian(IMAGE_NOISE), b = rng.gaussian(minorDeviation);
        const cv::Vec3d x = K * X;
        problem.imagePoints.emplace_back(x[0] / x[2] + c * a - s * b, x[1] / x[2] + s * a + c * b);
    }
    return problem;
}

const std::vector<Problem>& problemsOfSize(int n)
{
    static std::map<int, std::vector<Problem>> cache;
    std::vector<Problem>& problems = cache[n];
    for (int i = static_cast<int>(problems.size()); i < PROBLEMS; ++i)
        problems.push_back(makeProblem(n, i));
    return problems;
}

// --- Methods ---

template <int flags>
bool solveByOpenCV(const Problem& problem)
{
    cv::Vec3d rvec, tvec;
    return cv::solvePnP(problem.objectPoints, problem.imagePoints, K, cv::noArray(), rvec, tvec, false, flags);
}

template <int flags>
bool solveByUs(const Problem& problem)
{
    cv::Vec3d rvec, tvec;
    return cv::gmlpnp::solvePnP(problem.objectPoints, problem.imagePoints, K, cv::noArray(), rvec, tvec, false, flags);
}

bool solveWithCovariances(const Problem& problem)
{
    cv::gmlpnp::Result result;
    return cv::gmlpnp::solve(problem.objectPoints, problem.imagePoints, K, cv::noArray(), result);
}

struct Method
{
    const char* name;
    bool (*solve)(const Problem&);
};

const Method METHODS[] = {
    {"SQPNP", solveByOpenCV<cv::SOLVEPNP_SQPNP>},  // the reference of the ratios stands first
    {"EPNP", solveByOpenCV<cv::SOLVEPNP_EPNP>},
    {"ITERATIVE", solveByOpenCV<cv::SOLVEPNP_ITERATIVE>},
    {"GMLPNP", solveByUs<cv::gmlpnp::SOLVEPNP_GMLPNP>},
    {"GMLPNP_MARGINAL", solveByUs<cv::gmlpnp::SOLVEPNP_GMLPNP_MARGINAL>},
    {"solve", solveWithCovariances},  // GMLPNP_MARGINAL with every covariance of the result
};
const size_t METHOD_COUNT = sizeof(METHODS) / sizeof(METHODS[0]);

// A solver that gives up early would win: no time without a pose.
void solveOrThrow(const Method& method, const Problem& problem)
{
    if (!method.solve(problem))
        throw std::runtime_error(std::string(method.name) + " found no pose");
}

// --- Paired ratios ---

// Seconds of each method for all problems of one repetition, each problem solved `calls` times.
std::vector<double> measureOnce(const std::vector<Problem>& problems, int calls, size_t repetition)
{
    std::vector<double> seconds(METHOD_COUNT, 0.);
    for (size_t p = 0; p < problems.size(); ++p) {
        for (size_t k = 0; k < METHOD_COUNT; ++k) {
            const size_t m = (k + p + repetition) % METHOD_COUNT;  // nobody is always first
            solveOrThrow(METHODS[m], problems[p]);                 // fills the caches with what this method needs
            const double start = threadSeconds();
            for (int call = 0; call < calls; ++call)
                solveOrThrow(METHODS[m], problems[p]);
            seconds[m] += threadSeconds() - start;
        }
    }
    return seconds;
}

void printRatios()
{
    std::printf("OpenCV %s, %d problems of each size, medians of %d paired repetitions.\n\n", CV_VERSION, PROBLEMS,
                REPETITIONS);
    std::printf("| n | %s |", METHODS[0].name);
    for (size_t m = 1; m < METHOD_COUNT; ++m)
        std::printf(" %s |", METHODS[m].name);
    std::printf("\n|--:|");
    for (size_t m = 0; m < METHOD_COUNT; ++m)
        std::printf("--:|");
    std::printf("\n");

    for (const int n : SIZES) {
        const std::vector<Problem>& problems = problemsOfSize(n);
        const int calls = std::max(1, 1000 / n);  // a timing takes about a millisecond or more
        measureOnce(problems, 1, 0);              // warm-up

        std::vector<double> reference;
        std::vector<std::vector<double>> ratios(METHOD_COUNT);
        for (size_t repetition = 0; repetition < REPETITIONS; ++repetition) {
            const std::vector<double> seconds = measureOnce(problems, calls, repetition);
            reference.push_back(seconds[0] / (calls * PROBLEMS));
            for (size_t m = 0; m < METHOD_COUNT; ++m)
                ratios[m].push_back(seconds[m] / seconds[0]);
        }

        std::printf("| %d | %.0f µs |", n, 1e6 * median(reference));
        for (size_t m = 1; m < METHOD_COUNT; ++m)
            std::printf(" %.2f |", median(ratios[m]));
        std::printf("\n");
        std::fflush(stdout);
    }
}

// --- Batches ---

void printBatch()
{
    const int count = 4000, n = 50;
    std::vector<cv::Mat> points, rays;
    for (int i = 0; i < count; ++i) {
        const Problem problem = makeProblem(n, i);
        cv::Mat directions;
        cv::gmlpnp::CameraModel::pinhole(K)->unproject(problem.imagePoints, directions);
        points.emplace_back(problem.objectPoints, true);
        rays.push_back(directions);
    }
    std::printf(
        "%d problems of %d points, medians of %d paired repetitions.\n\n| threads | µs a problem | speed-up "
        "|\n|--:|--:|--:|\n",
        count, n, REPETITIONS);
    const int most = cv::getNumberOfCPUs();
    std::vector<std::vector<double>> seconds(most), speedUps(most);
    for (int repetition = 0; repetition <= REPETITIONS; ++repetition)
        for (int threads = 1; threads <= most; ++threads) {
            cv::setNumThreads(threads);
            std::vector<cv::gmlpnp::Result> results;
            const int64 start = cv::getTickCount();
            if (cv::gmlpnp::solveBatch(points, rays, results) != count)
                throw std::runtime_error("solveBatch found not every pose");
            const double time = static_cast<double>(cv::getTickCount() - start) / cv::getTickFrequency();
            if (repetition == 0)  // warm-up
                continue;
            seconds[threads - 1].push_back(time);
            speedUps[threads - 1].push_back(seconds[0].back() / time);
        }
    for (int threads = 1; threads <= most; ++threads)
        std::printf("| %d | %.1f | %.2f |\n", threads, 1e6 * median(seconds[threads - 1]) / count,
                    median(speedUps[threads - 1]));
}

// --- Absolute times ---

void solveInTurn(benchmark::State& state, const Method& method)
{
    const std::vector<Problem>& problems = problemsOfSize(static_cast<int>(state.range(0)));
    size_t next = 0;
    while (state.KeepRunning()) {
        solveOrThrow(method, problems[next]);
        next = (next + 1) % problems.size();
    }
}

void registerBenchmarks()
{
    for (const Method& method : METHODS) {
        auto* entry = benchmark::RegisterBenchmark(method.name,
                                                   [&method](benchmark::State& state) { solveInTurn(state, method); });
        for (const int n : SIZES)
            entry->Arg(n);
        entry->Unit(benchmark::kMicrosecond);
    }
}

bool runBenchmarks(int argc, char** argv)
{
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return false;
    registerBenchmarks();
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return true;
}

}  // namespace

int main(int argc, char** argv)
try {
    cv::setNumThreads(1);
    if (argc == 2 && std::strcmp(argv[1], "--ratios") == 0)
        printRatios();
    else if (argc == 2 && std::strcmp(argv[1], "--batch") == 0)
        printBatch();
    else if (!runBenchmarks(argc, argv))
        return 1;
    files::flushStandardOutput();
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "bench_solvepnp: %s\n", error.what());
    return 1;
}
