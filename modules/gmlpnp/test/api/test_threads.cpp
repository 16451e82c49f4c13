// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include <atomic>
#include <chrono>
#include <thread>

#include "every_function.hpp"

// Many threads in every public function at once, first of all in each for the first time in the process: each call
// gives the bits that it gives alone.

namespace opencv_test {
namespace {

/** Where threads wait for each other. */
class Gate
{
public:
    explicit Gate(int threads) : threads_(threads) {}

    //! Returns when all threads have come for the `time`-th time, from 1.
    void pass(int time)
    {
        ++came_;
        while (came_ < time * threads_)
            std::this_thread::yield();
    }

private:
    const int threads_;
    std::atomic<int> came_{0};
};

/** What one thread got of each function. */
struct Answers
{
    std::vector<Bits> first;
    std::vector<int> others;  // how many later ones differ from the first
};

// All threads in the same function first, then in different ones.
Answers callAll(const std::vector<Function>& functions, const Shared& shared, int thread, Gate& gate)
{
    constexpr int REPEATS = 2;
    Answers answers{{}, std::vector<int>(functions.size(), 0)};
    int time = 0;
    for (const Function& function : functions) {
        gate.pass(++time);
        answers.first.push_back(function.call(shared));
    }
    for (size_t k = 0; k < REPEATS * functions.size(); ++k) {
        const size_t at = (k + static_cast<size_t>(thread)) % functions.size();
        answers.others[at] += functions[at].call(shared) != answers.first[at];
    }
    return answers;
}

// Before the threads nothing is called that could set up what they would race for. That holds where this test has a
// process of its own, as ctest gives it.
TEST(Gmlpnp_Threads, everyFunctionAtOnce)
{
    constexpr int THREADS = 8;
    const Shared shared(testRng());
    const std::vector<Function> functions = everyFunction();
    Gate gate(THREADS);
    std::vector<Answers> answers(THREADS);
    std::vector<std::thread> threads;
    for (int thread = 0; thread < THREADS; ++thread)
        threads.emplace_back([&, thread] { answers[thread] = callAll(functions, shared, thread, gate); });
    for (std::thread& thread : threads)
        thread.join();
    for (size_t at = 0; at < functions.size(); ++at) {
        const Bits alone = functions[at].call(shared);
        EXPECT_FALSE(alone.empty()) << functions[at].name;
        for (const Answers& ofThread : answers) {
            EXPECT_TRUE(alone == ofThread.first[at]) << functions[at].name;
            EXPECT_EQ(0, ofThread.others[at]) << functions[at].name;
        }
    }
}

#ifdef GMLPNP_STANDALONE  // OpenCV's harness does not let GoogleTest start its process anew
// What a call uses must outlive main(): nothing of it is destroyed while the program ends. Sanitizers see it best.
TEST(Gmlpnp_Threads, threadsMaySolveWhileTheProgramEnds)
{
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    cv::RNG rng = testRng();
    const Scene scene = paperScene(rng, 20, 0.1, 1);
    const auto solveOn = [&scene] {
        const auto* const data = new cv::gmlpnp::detail::Correspondences(scene.objectPoints, scene.rays);
        const cv::gmlpnp::detail::Noise noise = cv::gmlpnp::detail::isotropic(1e-3, 1e-6);
        for (;;)
            cv::gmlpnp::detail::rayPass(*data, data->fromObject(scene.truth), noise);
    };
    const auto endMeanwhile = [&] {
        std::thread(solveOn).detach();
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        std::exit(0);
    };
    EXPECT_EXIT(endMeanwhile(), testing::ExitedWithCode(0), "");
}
#endif

}  // namespace
}  // namespace opencv_test
