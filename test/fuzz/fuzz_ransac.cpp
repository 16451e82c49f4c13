// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "fuzzed_arguments.hpp"
#include "outcome.hpp"

// solveRansac and solveRaysRansac.

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    using namespace fuzz;
    namespace gmlpnp = cv::gmlpnp;
    Bytes bytes(data, size);
    const int which = bytes.between(0, 2);
    const gmlpnp::RansacParams ransac = ransacFrom(bytes);
    const Arguments in(bytes);
    const auto p = in.objectPoints.in(), u = in.imagePoints.in(), m = in.rays.in();
    const auto K = in.cameraMatrix.in(), D = in.distCoeffs.in();

    gmlpnp::Result result = untouchedResult();
    std::vector<int> inliers(1, -7);
    bool solved = false;
    const bool returned = call([&] {
        if (which == 1)
            solved = gmlpnp::solveRaysRansac(p, m, result, inliers, ransac, in.params);
        else if (which == 2)
            solved = gmlpnp::solveRansac(p, u, K, D, result, inliers, ransac, in.params);
        else
            solved = gmlpnp::solveRansac(p, u, in.camera, result, inliers, ransac, in.params);
    });
    require(in.unchanged(), "inputs that stay");
    if (solved) {
        requireSound(result);
        requireInliers(inliers, result.weights.rows);
    } else {
        require(untouched(result) && (returned || result.status == -7), "a failure that writes its status only");
        require(inliers == std::vector<int>(1, -7), "a failure that writes no inliers");
    }
    return 0;
}
