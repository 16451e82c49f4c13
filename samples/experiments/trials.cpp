// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "trials.hpp"

#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <exception>
#include <thread>
#include <vector>

namespace experiments {

Progress::Progress(std::string name, long total)
    : name_(std::move(name)), total_(total), terminal_(isatty(STDERR_FILENO) != 0), start_(cv::getTickCount())
{}

Progress::~Progress()
{
    show(true);
}

void Progress::step()
{
    const std::lock_guard<std::mutex> lock(mutex_);
    ++done_;
    const long percent = 100 * done_ / total_;
    if (!terminal_ || percent == shown_)
        return;
    shown_ = percent;
    show(false);
}

void Progress::show(bool last) const
{
    constexpr long WIDTH = 30;
    const long filled = total_ > 0 ? WIDTH * done_ / total_ : WIDTH;
    const std::string bar =
        std::string(static_cast<size_t>(filled), '#') + std::string(static_cast<size_t>(WIDTH - filled), '.');
    const double seconds = static_cast<double>(cv::getTickCount() - start_) / cv::getTickFrequency();
    std::fprintf(stderr, "%s%-12s [%s] %3ld %%  %6.1f s%s", terminal_ ? "\r" : "", name_.c_str(), bar.c_str(),
                 total_ > 0 ? 100 * done_ / total_ : 100, seconds, last ? "\n" : "");
}

cv::RNG trialRng(const std::string& experiment, int cell, int trial)
{
    uint64_t state = 1469598103934665603ull;  // FNV-1a
    for (const char c : experiment)
        state = (state ^ static_cast<unsigned char>(c)) * 1099511628211ull;
    // The generator's first numbers grow with its seed: neighbouring seeds need mixing (splitmix64).
    state += 0x9e3779b97f4a7c15ull * (static_cast<uint64_t>(cell) * 1000003u + static_cast<uint64_t>(trial) + 1);
    state = (state ^ (state >> 30)) * 0xbf58476d1ce4e5b9ull;
    state = (state ^ (state >> 27)) * 0x94d049bb133111ebull;
    return cv::RNG(state ^ (state >> 31));
}

void forTrials(int count, int threads, Progress& progress, const std::function<void(int)>& trial)
{
    std::atomic<int> next{0};
    std::exception_ptr failure;
    std::mutex failureMutex;
    const auto work = [&] {
        for (int k = next++; k < count; k = next++) {
            try {
                trial(k);
            } catch (...) {
                const std::lock_guard<std::mutex> lock(failureMutex);
                failure = std::current_exception();
                next = count;
            }
            progress.step();
        }
    };
    std::vector<std::thread> workers;
    for (int t = 1; t < threads; ++t)
        workers.emplace_back(work);
    work();
    for (std::thread& worker : workers)
        worker.join();
    if (failure)
        std::rethrow_exception(failure);
}

}  // namespace experiments
