// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "fuzzed_file.hpp"
#include "outcome.hpp"

#include "common/kitti360.hpp"

// Calibrations of KITTI-360: the input is each of the three files of a rectified camera.

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    for (const char* const name : {"perspective.txt", "calib_cam_to_pose.txt", "calib_cam_to_velo.txt"})
        fuzz::fileOf(data, size, std::string("calibration/") + name);
    try {
        const samples::KittiCamera camera = samples::readKittiCamera(fuzz::folder(), "00");
        fuzz::require(camera.lens && camera.size.width > 0 && camera.size.height > 0, "a lens and a picture's size");
        fuzz::require(cv::checkRange(camera.fromLidar.t) && cv::checkRange(camera.fromVehicle.t), "finite poses");
    } catch (const std::runtime_error&) {
        // refused, as documented
    } catch (const cv::Exception&) {
        // a lens that is none, likewise
    }
    return 0;
}
