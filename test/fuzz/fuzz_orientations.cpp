// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "fuzzed_file.hpp"
#include "outcome.hpp"

#include "common/exterior_orientation.hpp"

// Tables of exterior orientations.

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    return fuzz::read<std::runtime_error>(data, size, "orientations.csv", [](const std::string& path) {
        for (const auto& [name, pose] : samples::readOrientations(path))
            fuzz::require(cv::norm(pose.R.t() * pose.R - cv::Matx33d::eye()) < 1e-9 && cv::checkRange(pose.t),
                          "rigid motions");
    });
}
