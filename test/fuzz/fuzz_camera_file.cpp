// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "fuzzed_file.hpp"
#include "outcome.hpp"

// Calibration files: YAML, XML, JSON, of every lens.

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    return fuzz::read<cv::Exception>(data, size, "camera", [](const std::string& path) {
        fuzz::require(cv::gmlpnp::CameraModel::load(path, "pinhole") != nullptr, "a camera, or an exception");
    });
}
