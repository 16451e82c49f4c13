// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "solvepnp.hpp"

#include <opencv2/gmlpnp.hpp>

#include "docstrings.hpp"
#include "module.hpp"

// solvePnPRansac with parameters and returns of cv2, name by name.

namespace bindings {

namespace {

using namespace py::literals;

//! For `solve(rvec, tvec, inliers)`, one of the functions here.
template <class Solve>
py::tuple solved(const py::object& rvec, const py::object& tvec, const Solve& solve)
{
    InOutVector r(rvec, "rvec"), t(tvec, "tvec");
    cv::Mat inliers;
    const bool found = withoutGil([&] { return solve(r.mat, t.mat, inliers); });
    return py::make_tuple(found, r.toPython(), t.toPython(), toPython(inliers));
}

py::tuple solvePnPRansac(const py::object& objectPoints, const py::object& imagePoints, const py::object& cameraMatrix,
                         const py::object& distCoeffs, const py::object& rvec, const py::object& tvec,
                         bool useExtrinsicGuess, int iterationsCount, float reprojectionError, double confidence,
                         const py::object& /*inliers*/, int flags)
{
    const Data in(objectPoints, imagePoints, cameraMatrix, distCoeffs);
    return solved(rvec, tvec, [&](cv::Mat& r, cv::Mat& t, cv::Mat& inliers) {
        return cv::gmlpnp::solvePnPRansac(in.points, in.pixels, in.K, in.D, r, t, useExtrinsicGuess, iterationsCount,
                                          reprojectionError, confidence, inliers, flags);
    });
}

cv::UsacParams usacParamsFrom(const py::object& params)
{
    cv::UsacParams usac;
    if (params.is_none())
        return usac;
    usac.threshold = params.attr("threshold").cast<double>();
    usac.confidence = params.attr("confidence").cast<double>();
    usac.maxIterations = params.attr("maxIterations").cast<int>();
    usac.randomGeneratorState = params.attr("randomGeneratorState").cast<int>();
    usac.sampler = static_cast<cv::SamplingMethod>(params.attr("sampler").cast<int>());
    return usac;
}

py::tuple solvePnPRansacByParams(const py::object& objectPoints, const py::object& imagePoints,
                                 const py::object& cameraMatrix, const py::object& distCoeffs, const py::object& rvec,
                                 const py::object& tvec, const py::object& /*inliers*/, const py::object& params)
{
    const Data in(objectPoints, imagePoints, cameraMatrix, distCoeffs);
    const cv::UsacParams usac = usacParamsFrom(params);
    const py::tuple out = solved(rvec, tvec, [&](cv::Mat& r, cv::Mat& t, cv::Mat& inliers) {
        cv::Mat K = in.K.mat();
        return cv::gmlpnp::solvePnPRansac(in.points, in.pixels, K, in.D, r, t, inliers, usac);
    });
    return py::make_tuple(out[0], cameraMatrix, out[1], out[2], out[3]);
}

py::tuple fisheyeSolvePnPRansac(const py::object& objectPoints, const py::object& imagePoints,
                                const py::object& cameraMatrix, const py::object& distCoeffs, const py::object& rvec,
                                const py::object& tvec, bool useExtrinsicGuess, int iterationsCount,
                                float reprojectionError, double confidence, const py::object& /*inliers*/, int flags,
                                const py::object& criteria)
{
    const Data in(objectPoints, imagePoints, cameraMatrix, distCoeffs);
    const cv::TermCriteria stop = criteriaFrom(criteria);
    return solved(rvec, tvec, [&](cv::Mat& r, cv::Mat& t, cv::Mat& inliers) {
        return cv::gmlpnp::fisheye::solvePnPRansac(in.points, in.pixels, in.K, in.D, r, t, useExtrinsicGuess,
                                                   iterationsCount, reprojectionError, confidence, inliers, flags,
                                                   stop);
    });
}

}  // namespace

void addSolvePnPRansac(py::module_& m)
{
    const py::object none = py::none();
    const int marginal = cv::gmlpnp::SOLVEPNP_GMLPNP_MARGINAL;
    m.def("solvePnPRansac", solvePnPRansac, "objectPoints"_a, "imagePoints"_a, "cameraMatrix"_a, "distCoeffs"_a,
          "rvec"_a = none, "tvec"_a = none, "useExtrinsicGuess"_a = false, "iterationsCount"_a = 10000,
          "reprojectionError"_a = 8.f, "confidence"_a = 0.99, "inliers"_a = none, "flags"_a = marginal,
          doc("solvePnPRansac"));
    m.def("solvePnPRansac", solvePnPRansacByParams, "objectPoints"_a, "imagePoints"_a, "cameraMatrix"_a, "distCoeffs"_a,
          "rvec"_a = none, "tvec"_a = none, "inliers"_a = none, "params"_a = none);
    auto fisheye = m.attr("_fisheye").cast<py::module_>();
    fisheye.def("solvePnPRansac", fisheyeSolvePnPRansac, "objectPoints"_a, "imagePoints"_a, "cameraMatrix"_a,
                "distCoeffs"_a, "rvec"_a = none, "tvec"_a = none, "useExtrinsicGuess"_a = false,
                "iterationsCount"_a = 10000, "reprojectionError"_a = 8.f, "confidence"_a = 0.99, "inliers"_a = none,
                "flags"_a = marginal, "criteria"_a = none, doc("fisheye.solvePnPRansac"));
}

}  // namespace bindings
