// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include <memory>

#include <opencv2/gmlpnp.hpp>

#include "arrays.hpp"
#include "module.hpp"

namespace bindings {

namespace {

using namespace py::literals;
using cv::gmlpnp::Params;
using cv::gmlpnp::Result;
using Camera = std::shared_ptr<cv::gmlpnp::CameraModel>;

const char* const kSolve = R"(solve(objectPoints, imagePoints, camera[, params]) -> retval, result
solve(objectPoints, imagePoints, cameraMatrix, distCoeffs[, params]) -> retval, result

Pose and noise from object points and pixels of any camera; no guess is needed.
objectPoints: N points, object frame, (N, 3), (N, 1, 3) or (1, N, 3).
imagePoints: N pixels, (N, 2), (N, 1, 2) or (1, N, 2). Pixels without a ray are left out.
camera: a CameraModel. cameraMatrix: 3x3. distCoeffs: None or 4, 5, 8, 12 or 14 coefficients.
params: a Params, or None.
retval: True with a finite pose; False where the data give none, result.status says why.
result: a Result.
Raises gmlpnp.error for misuse. Arrays may have any layout and any real type; lists and tuples do, too.)";

const char* const kSolveAll = R"(solveAll(objectPoints, imagePoints, camera[, params]) -> retval, results
solveAll(objectPoints, imagePoints, cameraMatrix, distCoeffs[, params]) -> retval, results

Every distinct pose that fits, best first: both poses of a small flat object, for instance. Arguments as in solve();
a guess leaves only the pose it leads to. Where costs differ by a few nats solve() may return another than the first.
retval: the number of results; 0 where the data give no pose.
results: tuple of Result, ascending cost.)";

const char* const kSolveRays = R"(solveRays(objectPoints, rays[, params]) -> retval, result

Pose and noise from object points and rays: any camera, any direction, also behind the image plane.
objectPoints: N points, object frame, (N, 3), (N, 1, 3) or (1, N, 3).
rays: N rays, camera frame, likewise; of any length but zero.
params: a Params, or None.
retval: True with a finite pose; False where the data give none, result.status says why.
result: a Result.)";

const char* const kSolveBatch = R"(solveBatch(objectPoints, rays[, params]) -> retval, results

Many independent problems at once, on all cores; the results are those of solveRays(), bit for bit.
objectPoints: the points of each problem, object frame: a sequence of arrays as solveRays() takes them.
rays: the rays of each problem, camera frame: as many arrays.
params: a Params for all, without objectCovariances, or None.
retval: how many problems have a pose.
results: tuple of Result, one for each problem; without a pose, its status says why.)";

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
    m.def("solve", solve, "objectPoints"_a, "imagePoints"_a, "camera"_a, "params"_a = none, kSolve);
    m.def("solve", solveByMatrix, "objectPoints"_a, "imagePoints"_a, "cameraMatrix"_a, "distCoeffs"_a,
          "params"_a = none);
    m.def("solveAll", solveAll, "objectPoints"_a, "imagePoints"_a, "camera"_a, "params"_a = none, kSolveAll);
    m.def("solveAll", solveAllByMatrix, "objectPoints"_a, "imagePoints"_a, "cameraMatrix"_a, "distCoeffs"_a,
          "params"_a = none);
    m.def("solveRays", solveRays, "objectPoints"_a, "rays"_a, "params"_a = none, kSolveRays);
    m.def("solveBatch", solveBatch, "objectPoints"_a, "rays"_a, "params"_a = none, kSolveBatch);
}

}  // namespace bindings
