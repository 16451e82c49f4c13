// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "common/progress.hpp"

#include <unistd.h>

#include <iostream>

#include <opencv2/core.hpp>

namespace samples {

namespace {

constexpr size_t kWidth = 30;  // characters of the bar

}  // namespace

Progress::Progress(size_t total, const std::string& unit) : Progress(total, unit, std::cerr, isatty(STDERR_FILENO) != 0)
{}

Progress::Progress(size_t total, const std::string& unit, std::ostream& out, bool shown)
    : total_(total), unit_(unit), out_(out), shown_(shown && total > 0)
{}

Progress::~Progress()
{
    if (shown_ && done_ > 0)
        out_ << "\n";
}

void Progress::step()
{
    ++done_;
    if (!shown_)
        return;
    const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    const int left = cvCeil(elapsed * static_cast<double>(total_ - done_) / static_cast<double>(done_));
    const size_t filled = kWidth * done_ / total_;
    out_ << "\r[" << std::string(filled, '#') << std::string(kWidth - filled, ' ') << "] " << done_ << "/" << total_
         << " " << unit_ << cv::format(", %d:%02d left ", left / 60, left % 60) << std::flush;
}

}  // namespace samples
