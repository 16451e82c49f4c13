// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "fuzzed_file.hpp"
#include "outcome.hpp"

#include <opencv2/imgcodecs.hpp>

#include "common/images.hpp"
#include "common/tum_rgbd.hpp"

// Depth images, of any depth and size and cut short.

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    return fuzz::read<std::runtime_error>(data, size, "depth.png", [](const std::string& path) {
        const cv::Mat depth = samples::readDepthImage(path);
        for (const cv::Point2f& pixel :
             {cv::Point2f(0, 0), cv::Point2f(-1, 2), cv::Point2f(1e30f, 0),
              cv::Point2f(static_cast<float>(depth.cols), static_cast<float>(depth.rows - 1))})
            fuzz::require(samples::depthAt(depth, pixel) >= 0, "a depth that is not negative");
    });
}
