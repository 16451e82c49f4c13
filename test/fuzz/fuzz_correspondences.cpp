// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "fuzzed_file.hpp"
#include "outcome.hpp"

#include "common/correspondences.hpp"

// Correspondence files: what is read can be written and read again.

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    return fuzz::read<std::runtime_error>(data, size, "correspondences.txt", [](const std::string& path) {
        const samples::CorrespondenceSet set = samples::readCorrespondences(path);
        fuzz::require(set.objectPoints.size() == set.imagePoints.size() &&
                          set.objectPoints.size() >= samples::kMinCorrespondences,
                      "as many pixels as points, four at least");
        fuzz::require(cv::checkRange(set.objectPoints) && cv::checkRange(set.imagePoints), "finite numbers");
        const std::string copy = fuzz::folder() + "/copy.txt";
        samples::writeCorrespondences(copy, set);
        fuzz::require(samples::readCorrespondences(copy).objectPoints.size() == set.objectPoints.size(),
                      "what was written can be read");
    });
}
