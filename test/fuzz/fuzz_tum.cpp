// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "fuzzed_file.hpp"
#include "outcome.hpp"

#include "common/tum_rgbd.hpp"

// The lists of a TUM RGB-D sequence, one after the other in the input, a line of `===` between them.

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    const std::string text(reinterpret_cast<const char*>(data), size), border = "===\n";
    size_t begin = 0;
    for (const char* const name : {"rgb.txt", "depth.txt", "groundtruth.txt"}) {
        const size_t end = std::min(text.find(border, begin), size);
        fuzz::fileOf(data + begin, end - begin, name);
        begin = std::min(end + border.size(), size);
    }
    try {
        const samples::TumSequence sequence = samples::readTumSequence(fuzz::folder());
        for (const samples::FramePair& pair : samples::pairsOf(sequence, 0.1)) {
            fuzz::require(pair.first < sequence.frames.size() && pair.second < sequence.frames.size(), "frames");
            const samples::Pose& motion = pair.secondFromFirst;
            fuzz::require(cv::norm(motion.R.t() * motion.R - cv::Matx33d::eye()) < 1e-6, "rotations");
        }
    } catch (const std::runtime_error&) {
        // refused, as documented
    }
    return 0;
}
