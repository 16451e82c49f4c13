// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "fuzzed_file.hpp"
#include "outcome.hpp"

#include "common/kitti360.hpp"

// Pose and motion files of KITTI-360.

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    return fuzz::read<std::runtime_error>(data, size, "poses.txt", [](const std::string& path) {
        for (const auto& [frame, pose] : samples::readKittiPoses(path)) {
            fuzz::require(frame >= 0, "frames that can be counted");
            fuzz::require(cv::norm(pose.R.t() * pose.R - cv::Matx33d::eye()) < 1e-2 && cv::checkRange(pose.t),
                          "rigid motions");
        }
    });
}
