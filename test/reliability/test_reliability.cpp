// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include <gtest/gtest.h>

#include <cstring>

#include "same_pose.hpp"
#include "sweep.hpp"

namespace {

using namespace reliability;

Settings small()
{
    Settings settings;
    settings.problems = 4000;
    settings.searched = 400;
    settings.seed = 2;
    settings.threads = 2;
    return settings;
}

// The aims of doc/reliability.md; and a sweep that finds nothing is worth what its eyes are worth: OpenCV's solvers
// fail on the same problems.
TEST(Reliability, aFewThousandProblems)
{
    const Sweep found = sweep(small());
    long badPoses = 0, refused = 0;
    for (size_t s = 0; s < allSolvers().size(); ++s) {
        const Tally& tally = found.tallies[s];
        if (!allSolvers()[s].ours) {
            badPoses += tally.badPose;
            refused += tally.refused;
            continue;
        }
        SCOPED_TRACE(allSolvers()[s].name);
        EXPECT_GT(tally.solved, tally.calls / 2);
        EXPECT_GT(tally.solvable, 400);
        EXPECT_EQ(0, tally.badPose);
        EXPECT_EQ(0, tally.badResult);
        EXPECT_EQ(0, tally.foreignException);
        EXPECT_EQ(0, tally.inputChanged);
        EXPECT_EQ(0, tally.outputTouched);
        EXPECT_EQ(0, tally.refused);
    }
    EXPECT_GT(badPoses, 0);
    EXPECT_GT(refused, 0);
    EXPECT_GT(found.tallies[SEARCHED_SOLVER].searched, 20);
    EXPECT_EQ(0, found.tallies[SEARCHED_SOLVER].above);
    for (const Failure& failure : found.failures)
        EXPECT_TRUE(failure.what != "exception") << "problem " << failure.index;
}

// Found by the sweep: one kind of noise led nowhere, and the covariance of a success was not a number (seeds 4 and 6);
// the object noise of the published method collapsed, and its least variance was negative by rounding (seed 9).
TEST(Reliability, noSuccessWithoutItsCovariances)
{
    constexpr int FOUND[][2] = {{4, 10085},  {4, 11905},  {6, 17097},  {9, 35716},
                                {9, 109481}, {9, 216066}, {9, 904747}, {9, 995646}};  // seed, index
    for (const auto& found : FOUND)
        for (const Solver& solver : allSolvers())
            if (solver.fullResult) {
                EXPECT_FALSE(judge(solver, randomProblem(found[0], found[1])).badResult)
                    << solver.name << ", seed " << found[0] << ", problem " << found[1];
            }
}

// Found by the sweep: anisotropic noise makes another minimum of isotropic noise the best by up to 2.2 times.
TEST(Reliability, theBestMinimumMayCostMoreWithIsotropicNoise)
{
    constexpr int FOUND[][2] = {{1, 4072}, {2, 8872}, {2, 9770}, {2, 18764}, {2, 92584}, {10, 99854}};  // seed, index
    for (const auto& found : FOUND) {
        const Problem problem = randomProblem(found[0], found[1]);
        const Verdict verdict = judge(allSolvers()[SEARCHED_SOLVER], problem);
        EXPECT_FALSE(verdict.lost) << found[1];
        EXPECT_LT(aboveSearch(problem, verdict.pose, Settings().starts), 1) << found[1];
    }
}

// By rays, with all that rounds differently then. Of two exact poses the order may choose one: three places are not
// solvable, and a guess that is wrong not either.
TEST(Reliability, theOrderOfThePointsDoesNotMatter)
{
    constexpr int SEED = 3, PROBLEMS = 100000;
    cv::RNG rng(1);
    int compared = 0;
    for (int index = 0; index < PROBLEMS; ++index) {
        const Problem problem = randomProblem(SEED, index), other = shuffled(problem, rng);
        for (const Solver& solver : allSolvers()) {
            if (!solver.fullResult || !roundingIsSmall(solver, problem))
                continue;
            const Verdict a = judge(solver, problem), b = judge(solver, other);
            ASSERT_EQ(a.solved, b.solved) << solver.name << ", problem " << index;
            EXPECT_LE(apart(problem.centre, a.pose, b.pose), roundingBound(problem))
                << solver.name << ", problem " << index;
            compared++;
        }
    }
    EXPECT_GT(compared, 10000);
}

// The worst of the sweep, found by the build for ThreadSanitizer: a rod 2000 times as long as thick, 80 lengths away.
TEST(Reliability, theOrderOfARodMovesItByLessThanAThousandthOfADeviation)
{
    constexpr int SEED = 3, INDEX = 84809, ORDERS = 30;
    const Problem problem = randomProblem(SEED, INDEX);
    const Solver& solver = allSolvers()[SEARCHED_SOLVER];
    ASSERT_TRUE(roundingIsSmall(solver, problem));
    const Verdict found = judge(solver, problem);
    ASSERT_TRUE(found.solved);
    cv::RNG rng(1);
    for (int order = 0; order < ORDERS; ++order)
        EXPECT_LE(apart(problem.centre, found.pose, judge(solver, shuffled(problem, rng)).pose),
                  roundingBound(problem));
}

TEST(Reliability, problemsAreWhatTheySay)
{
    std::vector<int> shapes(SHAPES, 0);
    int solvable = 0, corrupt = 0, guesses = 0;
    for (int index = 0; index < 2000; ++index) {
        const Problem a = randomProblem(1, index), b = randomProblem(1, index);
        ASSERT_EQ(a.n, a.points.rows);
        ASSERT_EQ(a.n, b.points.rows);
        if (a.n > 0) {
            EXPECT_EQ(0, std::memcmp(a.points[0], b.points[0], a.points.total() * sizeof(double)));
        }
        shapes[static_cast<size_t>(a.shape)]++;
        solvable += a.solvable();
        corrupt += a.corrupt;
        guesses += a.hasGuess();
    }
    for (const int count : shapes)
        EXPECT_GT(count, 2000 / SHAPES / 2);
    EXPECT_GT(solvable, 200);
    EXPECT_GT(corrupt, 10);
    EXPECT_GT(guesses, 500);
}

// Exact data of a solvable problem: the truth explains every point.
TEST(Reliability, theTruthIsThePose)
{
    for (int index = 0; index < 2000; ++index) {
        const Problem problem = randomProblem(1, index);
        if (!problem.solvable() || problem.objectNoise > 0 || problem.rayNoise > 0)
            continue;
        const double rounding = 1e-14 * (10 + problem.offset + problem.distance) * problem.scale;
        for (int i = 0; i < problem.n; ++i) {
            const Vector3d p(problem.points(i, 0), problem.points(i, 1), problem.points(i, 2));
            const Vector3d m(problem.rays(i, 0), problem.rays(i, 1), problem.rays(i, 2));
            EXPECT_LT(m.cross(problem.truth * p).norm(), rounding) << "problem " << index;
        }
    }
}

}  // namespace
