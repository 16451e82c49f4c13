// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "sweep.hpp"

#include <mutex>

#include "trials.hpp"

namespace reliability {

namespace {

constexpr double ABOVE = 1;       // nat
constexpr int ENOUGH_POINTS = 4;  // fewer are misuse of solvePnP

// What is wrong with a call, by a name; and its count.
struct Fault
{
    const char* name;
    bool Verdict::*seen;
    long Tally::*count;
};

constexpr Fault FAULTS[] = {
    {"pose", &Verdict::badPose, &Tally::badPose},
    {"result", &Verdict::badResult, &Tally::badResult},
    {"foreign exception", &Verdict::foreignException, &Tally::foreignException},
    {"input changed", &Verdict::inputChanged, &Tally::inputChanged},
    {"output touched", &Verdict::outputTouched, &Tally::outputTouched},
    {"exception", &Verdict::threw, &Tally::threw},
    {"refused", &Verdict::refused, &Tally::refused},
    {"lost", &Verdict::lost, &Tally::lost},
};

void add(const Verdict& verdict, const Problem& problem, int index, size_t solver, Sweep& sweep)
{
    Tally& tally = sweep.tallies[solver];
    tally.calls += verdict.called;
    tally.solved += verdict.solved;
    tally.solvable += verdict.called && problem.solvable();
    for (const Fault& fault : FAULTS) {
        if (!(verdict.*fault.seen))
            continue;
        tally.*fault.count += 1;
        const bool misuse = fault.seen == &Verdict::threw && problem.n < ENOUGH_POINTS;
        if (allSolvers()[solver].ours && !misuse)
            sweep.failures.push_back({index, solver, fault.name, 0});
    }
}

void addSearch(double above, const Problem& problem, int index, Sweep& sweep)
{
    Tally& tally = sweep.tallies[SEARCHED_SOLVER];
    const bool solvable = problem.solvable();
    (solvable ? tally.searched : tally.searchedUnsolvable)++;
    if (above <= ABOVE)
        return;
    (solvable ? tally.above : tally.aboveUnsolvable)++;
    sweep.failures.push_back({index, SEARCHED_SOLVER, "above the search", above});
}

}  // namespace

Sweep sweep(const Settings& settings)
{
    const std::vector<Solver>& solvers = allSolvers();
    Sweep out;
    out.tallies.resize(solvers.size());
    std::mutex mutex;
    experiments::Progress progress("problems", settings.problems);
    experiments::forTrials(settings.problems, settings.threads, progress, [&](int index) {
        const Problem problem = randomProblem(settings.seed, index);
        std::vector<Verdict> verdicts;
        for (const Solver& solver : solvers)
            verdicts.push_back(judge(solver, problem));
        const Verdict& searched = verdicts[SEARCHED_SOLVER];
        const bool search = index < settings.searched && searchable(problem) && searched.solved;
        const double above = search ? aboveSearch(problem, searched.pose, settings.starts) : 0;
        const std::lock_guard<std::mutex> lock(mutex);
        for (size_t s = 0; s < solvers.size(); ++s)
            add(verdicts[s], problem, index, s, out);
        if (search)
            addSearch(above, problem, index, out);
    });
    std::stable_sort(out.failures.begin(), out.failures.end(), [](const Failure& a, const Failure& b) {
        return std::make_pair(a.index, a.solver) < std::make_pair(b.index, b.solver);
    });
    return out;
}

}  // namespace reliability
