// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_EXPERIMENTS_TRIALS_HPP
#define GMLPNP_EXPERIMENTS_TRIALS_HPP

#include <functional>
#include <mutex>
#include <string>

#include <opencv2/core.hpp>

namespace experiments {

/** How a run was asked for. */
struct Settings
{
    int trials = 500;
    int threads = 1;
    std::string folder;  //!< for the CSV files
};

/** A line on stderr that says how far an experiment is; a terminal sees it move, a file its end. */
class Progress
{
public:
    Progress(std::string name, long total);
    ~Progress();

    void step();

private:
    void show(bool last) const;

    const std::string name_;
    const long total_;
    const bool terminal_;
    const int64_t start_;
    std::mutex mutex_;
    long done_ = 0;
    long shown_ = -1;  // percent
};

/** A generator for each trial of each cell of each experiment: the same in any order and on any thread. */
cv::RNG trialRng(const std::string& experiment, int cell, int trial);

/** Calls `trial(0)` ... `trial(count - 1)`, each once, from several threads. What one throws is thrown here. */
void forTrials(int count, int threads, Progress& progress, const std::function<void(int)>& trial);

}  // namespace experiments

#endif  // GMLPNP_EXPERIMENTS_TRIALS_HPP
