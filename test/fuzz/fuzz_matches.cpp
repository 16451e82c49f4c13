// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "fuzzed_file.hpp"
#include "outcome.hpp"

#include "common/pixel_matches.hpp"

// Files of matches between two pictures.

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    return fuzz::read<std::runtime_error>(data, size, "matches.txt", [](const std::string& path) {
        const samples::PixelMatches matches = samples::readMatches(path);
        fuzz::require(matches.reference.size() == matches.query.size(), "pairs");
        fuzz::require(cv::checkRange(matches.reference) && cv::checkRange(matches.query), "finite pixels");
    });
}
