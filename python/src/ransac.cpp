// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include <memory>

#include <opencv2/gmlpnp.hpp>

#include "arrays.hpp"
#include "docstrings.hpp"
#include "module.hpp"

namespace bindings {

namespace {

using namespace py::literals;
using cv::gmlpnp::Params;
using cv::gmlpnp::RansacParams;
using cv::gmlpnp::Result;
using Camera = std::shared_ptr<cv::gmlpnp::CameraModel>;

struct Options
{
    Options(const RansacParams* ransacParams, const Params* solveParams)
        : ransac(ransacParams != nullptr ? *ransacParams : RansacParams()),
          params(solveParams != nullptr ? *solveParams : Params())
    {}

    // Copies: they may change while other threads run.
    RansacParams ransac;
    Params params;
};

//! For `solve(result, inliers)`, one of the functions here.
template <class Solve>
py::tuple solved(const Solve& solve)
{
    Result result;
    cv::Mat inliers;
    const bool found = withoutGil([&] { return solve(result, inliers); });
    return py::make_tuple(found, result, toPython(inliers));
}

py::tuple solveRansac(const py::object& objectPoints, const py::object& imagePoints, const Camera& camera,
                      const RansacParams* ransac, const Params* params)
{
    const Input points(objectPoints, "objectPoints"), pixels(imagePoints, "imagePoints");
    const Options options(ransac, params);
    return solved([&](Result& result, cv::Mat& inliers) {
        return cv::gmlpnp::solveRansac(points, pixels, camera, result, inliers, options.ransac, options.params);
    });
}

py::tuple solveRansacByMatrix(const py::object& objectPoints, const py::object& imagePoints,
                              const py::object& cameraMatrix, const py::object& distCoeffs, const RansacParams* ransac,
                              const Params* params)
{
    const Input points(objectPoints, "objectPoints"), pixels(imagePoints, "imagePoints");
    const Input K(cameraMatrix, "cameraMatrix"), D(distCoeffs, "distCoeffs");
    const Options options(ransac, params);
    return solved([&](Result& result, cv::Mat& inliers) {
        return cv::gmlpnp::solveRansac(points, pixels, K, D, result, inliers, options.ransac, options.params);
    });
}

py::tuple solveRaysRansac(const py::object& objectPoints, const py::object& rays, const RansacParams* ransac,
                          const Params* params)
{
    const Input points(objectPoints, "objectPoints"), directions(rays, "rays");
    const Options options(ransac, params);
    return solved([&](Result& result, cv::Mat& inliers) {
        return cv::gmlpnp::solveRaysRansac(points, directions, result, inliers, options.ransac, options.params);
    });
}

}  // namespace

void addRansac(py::module_& m)
{
    const py::object none = py::none();
    m.def("solveRansac", solveRansac, "objectPoints"_a, "imagePoints"_a, "camera"_a, "ransac"_a = none,
          "params"_a = none, doc("solveRansac"));
    m.def("solveRansac", solveRansacByMatrix, "objectPoints"_a, "imagePoints"_a, "cameraMatrix"_a, "distCoeffs"_a,
          "ransac"_a = none, "params"_a = none);
    m.def("solveRaysRansac", solveRaysRansac, "objectPoints"_a, "rays"_a, "ransac"_a = none, "params"_a = none,
          doc("solveRaysRansac"));
}

}  // namespace bindings
