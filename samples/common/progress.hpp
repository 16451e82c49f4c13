// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_SAMPLES_PROGRESS_HPP
#define GMLPNP_SAMPLES_PROGRESS_HPP

#include <chrono>
#include <cstddef>
#include <ostream>
#include <string>

namespace samples {

/** A bar that is redrawn in place: how much is done, how much time is left. */
class Progress
{
public:
    //! On stderr where that is a terminal; silent otherwise, so that logs stay readable.
    Progress(size_t total, const std::string& unit);

    Progress(size_t total, const std::string& unit, std::ostream& out, bool shown);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    //! One more is done.
    void step();

private:
    size_t total_, done_ = 0;
    std::string unit_;
    std::ostream& out_;
    bool shown_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace samples

#endif  // GMLPNP_SAMPLES_PROGRESS_HPP
