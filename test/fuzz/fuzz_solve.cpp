// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "fuzzed_arguments.hpp"
#include "outcome.hpp"

// solve, solveRays and solveAll.

namespace {

using namespace fuzz;
namespace gmlpnp = cv::gmlpnp;

template <class Solve>
void one(const Arguments& in, const Solve& solve)
{
    gmlpnp::Result result = untouchedResult();
    bool solved = false;
    const bool returned = call([&] { solved = solve(result); });
    if (solved)
        requireSound(result);
    else
        require(untouched(result) && (returned || result.status == -7), "a failure that writes its status only");
    require(in.unchanged(), "inputs that stay");
}

template <class Solve>
void all(const Arguments& in, const Solve& solve)
{
    std::vector<gmlpnp::Result> results(1, untouchedResult());
    int count = 0;
    call([&] { count = solve(results); });
    require(count > 0 ? count == static_cast<int>(results.size()) : results.size() == 1 && untouched(results[0]),
            "as many results as said, or none written");
    for (int i = 0; i < count; ++i) {
        requireSound(results[i]);
        require(i == 0 || results[i - 1].cost <= results[i].cost, "results of ascending cost");
    }
    require(in.unchanged(), "inputs that stay");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    Bytes bytes(data, size);
    const int which = bytes.between(0, 4);
    const Arguments in(bytes);
    const auto p = in.objectPoints.in(), u = in.imagePoints.in(), m = in.rays.in();
    const auto K = in.cameraMatrix.in(), D = in.distCoeffs.in();
    using gmlpnp::Result;
    switch (which) {
        case 1:
            one(in, [&](Result& result) { return gmlpnp::solveRays(p, m, result, in.params); });
            break;
        case 2:
            one(in, [&](Result& result) { return gmlpnp::solve(p, u, K, D, result, in.params); });
            break;
        case 3:
            all(in, [&](auto& results) { return gmlpnp::solveAll(p, u, in.camera, results, in.params); });
            break;
        case 4:
            all(in, [&](auto& results) { return gmlpnp::solveAll(p, u, K, D, results, in.params); });
            break;
        default:
            one(in, [&](Result& result) { return gmlpnp::solve(p, u, in.camera, result, in.params); });
    }
    return 0;
}
