// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "fuzzed_file.hpp"
#include "outcome.hpp"

#include <iterator>

// Calibration files: YAML, XML, JSON, of every lens, and of a lens that only the caller names.

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    const char* const others[] = {"", "fisheye", "omnidir", "eucm", "doubleSphere", "equirectangular", "MEI", "none"};
    const std::string path = fuzz::fileOf(data, size, "camera");
    for (const char* const model : {"pinhole", others[size % std::size(others)]})
        fuzz::call(
            [&] { fuzz::require(cv::gmlpnp::CameraModel::load(path, model) != nullptr, "a camera, or an exception"); });
    return 0;
}
