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
using cv::gmlpnp::Result;
using Camera = std::shared_ptr<cv::gmlpnp::CameraModel>;

//! A copy: `params` may change while other threads run.
Params orDefault(const Params* params)
{
    return params != nullptr ? *params : Params();
}

py::tuple solve(const py::object& objectPoints, const py::object& imagePoints, const Camera& camera,
                const Params* params)
{
    const Input points(objectPoints, "objectPoints"), pixels(imagePoints, "imagePoints");
    const Params options = orDefault(params);
    Result result;
    const bool solved = withoutGil([&] { return cv::gmlpnp::solve(points, pixels, camera, result, options); });
    return py::make_tuple(solved, result);
}

py::tuple solveByMatrix(const py::object& objectPoints, const py::object& imagePoints, const py::object& cameraMatrix,
                        const py::object& distCoeffs, const Params* params)
{
    const Input points(objectPoints, "objectPoints"), pixels(imagePoints, "imagePoints");
    const Input K(cameraMatrix, "cameraMatrix"), D(distCoeffs, "distCoeffs");
    const Params options = orDefault(params);
    Result result;
    const bool solved = withoutGil([&] { return cv::gmlpnp::solve(points, pixels, K, D, result, options); });
    return py::make_tuple(solved, result);
}

py::tuple tupleOf(const std::vector<Result>& results)
{
    py::tuple tuple(results.size());
    for (size_t i = 0; i < results.size(); ++i)
        tuple[i] = results[i];
    return tuple;
}

py::tuple solveAll(const py::object& objectPoints, const py::object& imagePoints, const Camera& camera,
                   const Params* params)
{
    const Input points(objectPoints, "objectPoints"), pixels(imagePoints, "imagePoints");
    const Params options = orDefault(params);
    std::vector<Result> results;
    const int count = withoutGil([&] { return cv::gmlpnp::solveAll(points, pixels, camera, results, options); });
    return py::make_tuple(count, tupleOf(results));
}

py::tuple solveAllByMatrix(const py::object& objectPoints, const py::object& imagePoints,
                           const py::object& cameraMatrix, const py::object& distCoeffs, const Params* params)
{
    const Input points(objectPoints, "objectPoints"), pixels(imagePoints, "imagePoints");
    const Input K(cameraMatrix, "cameraMatrix"), D(distCoeffs, "distCoeffs");
    const Params options = orDefault(params);
    std::vector<Result> results;
    const int count = withoutGil([&] { return cv::gmlpnp::solveAll(points, pixels, K, D, results, options); });
    return py::make_tuple(count, tupleOf(results));
}

py::tuple solveRays(const py::object& objectPoints, const py::object& rays, const Params* params)
{
    const Input points(objectPoints, "objectPoints"), directions(rays, "rays");
    const Params options = orDefault(params);
    Result result;
    const bool solved = withoutGil([&] { return cv::gmlpnp::solveRays(points, directions, result, options); });
    return py::make_tuple(solved, result);
}

py::tuple solveBatch(const py::object& objectPoints, const py::object& rays, const Params* params)
{
    std::vector<Input> owners;  // of the memory that is shared
    std::vector<cv::Mat> points, directions;
    const auto read = [&owners](const py::object& arrays, const char* name, std::vector<cv::Mat>& mats) {
        if (!py::isinstance<py::iterable>(arrays))
            CV_Error(cv::Error::StsBadArg, cv::format("'%s' must be a sequence of arrays", name));
        for (const py::handle& each : arrays) {
            owners.emplace_back(py::reinterpret_borrow<py::object>(each), name);
            mats.push_back(owners.back().mat());
        }
    };
    read(objectPoints, "objectPoints", points);
    read(rays, "rays", directions);
    const Params options = orDefault(params);
    std::vector<Result> results;
    const int count = withoutGil([&] { return cv::gmlpnp::solveBatch(points, directions, results, options); });
    return py::make_tuple(count, tupleOf(results));
}

}  // namespace

void addSolvers(py::module_& m)
{
    const py::object none = py::none();
    m.def("solve", solve, "objectPoints"_a, "imagePoints"_a, "camera"_a, "params"_a = none, doc("solve"));
    m.def("solve", solveByMatrix, "objectPoints"_a, "imagePoints"_a, "cameraMatrix"_a, "distCoeffs"_a,
          "params"_a = none);
    m.def("solveAll", solveAll, "objectPoints"_a, "imagePoints"_a, "camera"_a, "params"_a = none, doc("solveAll"));
    m.def("solveAll", solveAllByMatrix, "objectPoints"_a, "imagePoints"_a, "cameraMatrix"_a, "distCoeffs"_a,
          "params"_a = none);
    m.def("solveRays", solveRays, "objectPoints"_a, "rays"_a, "params"_a = none, doc("solveRays"));
    m.def("solveBatch", solveBatch, "objectPoints"_a, "rays"_a, "params"_a = none, doc("solveBatch"));
}

}  // namespace bindings
