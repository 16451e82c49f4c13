// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "fuzzed_file.hpp"
#include "outcome.hpp"

#include "common/kitti360.hpp"

// LiDAR scans.

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    return fuzz::read<std::runtime_error>(data, size, "scan.bin", [](const std::string& path) {
        const std::vector<cv::Point3d> points = samples::readScan(path, samples::KittiCamera());
        fuzz::require(!points.empty() && cv::checkRange(points), "finite points");
    });
}
