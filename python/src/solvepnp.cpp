// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include <opencv2/gmlpnp.hpp>

#include "docstrings.hpp"
#include "module.hpp"
#include "solvepnp.hpp"

// Functions whose parameters and returns are those of cv2, name by name.

namespace bindings {

namespace {

using namespace py::literals;
using cv::TermCriteria;

py::tuple solvePnP(const py::object& objectPoints, const py::object& imagePoints, const py::object& cameraMatrix,
                   const py::object& distCoeffs, const py::object& rvec, const py::object& tvec, bool useExtrinsicGuess,
                   int flags)
{
    const Data in(objectPoints, imagePoints, cameraMatrix, distCoeffs);
    InOutVector r(rvec, "rvec"), t(tvec, "tvec");
    const bool solved = withoutGil(
        [&] { return cv::gmlpnp::solvePnP(in.points, in.pixels, in.K, in.D, r.mat, t.mat, useExtrinsicGuess, flags); });
    return py::make_tuple(solved, r.toPython(), t.toPython());
}

py::tuple fisheyeSolvePnP(const py::object& objectPoints, const py::object& imagePoints, const py::object& cameraMatrix,
                          const py::object& distCoeffs, const py::object& rvec, const py::object& tvec,
                          bool useExtrinsicGuess, int flags, const py::object& criteria)
{
    const Data in(objectPoints, imagePoints, cameraMatrix, distCoeffs);
    const TermCriteria stop = criteriaFrom(criteria);
    InOutVector r(rvec, "rvec"), t(tvec, "tvec");
    const bool solved = withoutGil([&] {
        return cv::gmlpnp::fisheye::solvePnP(in.points, in.pixels, in.K, in.D, r.mat, t.mat, useExtrinsicGuess, flags,
                                             stop);
    });
    return py::make_tuple(solved, r.toPython(), t.toPython());
}

py::tuple solvePnPGeneric(const py::object& objectPoints, const py::object& imagePoints, const py::object& cameraMatrix,
                          const py::object& distCoeffs, const py::object& /*rvecs*/, const py::object& /*tvecs*/,
                          bool useExtrinsicGuess, int flags, const py::object& rvec, const py::object& tvec,
                          const py::object& /*reprojectionError*/)
{
    const Data in(objectPoints, imagePoints, cameraMatrix, distCoeffs);
    InOutVector r(rvec, "rvec"), t(tvec, "tvec");  // copies: OpenCV's own solver writes its guess
    std::vector<cv::Mat> rvecs, tvecs;
    cv::Mat errors;
    const int count = withoutGil([&] {
        return cv::gmlpnp::solvePnPGeneric(in.points, in.pixels, in.K, in.D, rvecs, tvecs, useExtrinsicGuess, flags,
                                           r.mat, t.mat, errors);
    });
    return py::make_tuple(count, toPython(rvecs), toPython(tvecs), toPython(errors));
}

//! For `refine(in, rvec, tvec, criteria)`, one of the functions that refine.
template <class Refine>
py::tuple refined(const Data& in, const py::object& rvec, const py::object& tvec, const py::object& criteria,
                  const Refine& refine)
{
    const TermCriteria stop = criteriaFrom(criteria);
    InOutVector r(rvec, "rvec"), t(tvec, "tvec");
    withoutGil([&] { refine(in, r.mat, t.mat, stop); });
    return py::make_tuple(r.toPython(), t.toPython());
}

py::tuple solvePnPRefine(const py::object& objectPoints, const py::object& imagePoints, const py::object& cameraMatrix,
                         const py::object& distCoeffs, const py::object& rvec, const py::object& tvec,
                         const py::object& criteria)
{
    return refined(Data(objectPoints, imagePoints, cameraMatrix, distCoeffs), rvec, tvec, criteria,
                   [](const Data& in, cv::Mat& r, cv::Mat& t, const TermCriteria& stop) {
                       cv::gmlpnp::solvePnPRefine(in.points, in.pixels, in.K, in.D, r, t, stop);
                   });
}

py::tuple solvePnPRefineLM(const py::object& objectPoints, const py::object& imagePoints,
                           const py::object& cameraMatrix, const py::object& distCoeffs, const py::object& rvec,
                           const py::object& tvec, const py::object& criteria)
{
    return refined(Data(objectPoints, imagePoints, cameraMatrix, distCoeffs), rvec, tvec, criteria,
                   [](const Data& in, cv::Mat& r, cv::Mat& t, const TermCriteria& stop) {
                       cv::gmlpnp::solvePnPRefineLM(in.points, in.pixels, in.K, in.D, r, t, stop);
                   });
}

py::tuple solvePnPRefineVVS(const py::object& objectPoints, const py::object& imagePoints,
                            const py::object& cameraMatrix, const py::object& distCoeffs, const py::object& rvec,
                            const py::object& tvec, const py::object& criteria, double VVSlambda)
{
    return refined(Data(objectPoints, imagePoints, cameraMatrix, distCoeffs), rvec, tvec, criteria,
                   [VVSlambda](const Data& in, cv::Mat& r, cv::Mat& t, const TermCriteria& stop) {
                       cv::gmlpnp::solvePnPRefineVVS(in.points, in.pixels, in.K, in.D, r, t, stop, VVSlambda);
                   });
}

}  // namespace

void addSolvePnP(py::module_& m)
{
    const py::object none = py::none();
    const int marginal = cv::gmlpnp::SOLVEPNP_GMLPNP_MARGINAL;
    m.def("solvePnP", solvePnP, "objectPoints"_a, "imagePoints"_a, "cameraMatrix"_a, "distCoeffs"_a, "rvec"_a = none,
          "tvec"_a = none, "useExtrinsicGuess"_a = false, "flags"_a = marginal, doc("solvePnP"));
    m.def("solvePnPGeneric", solvePnPGeneric, "objectPoints"_a, "imagePoints"_a, "cameraMatrix"_a, "distCoeffs"_a,
          "rvecs"_a = none, "tvecs"_a = none, "useExtrinsicGuess"_a = false, "flags"_a = marginal, "rvec"_a = none,
          "tvec"_a = none, "reprojectionError"_a = none, doc("solvePnPGeneric"));
    m.def("solvePnPRefine", solvePnPRefine, "objectPoints"_a, "imagePoints"_a, "cameraMatrix"_a, "distCoeffs"_a,
          "rvec"_a, "tvec"_a, "criteria"_a = none, doc("solvePnPRefine"));
    m.def("solvePnPRefineLM", solvePnPRefineLM, "objectPoints"_a, "imagePoints"_a, "cameraMatrix"_a, "distCoeffs"_a,
          "rvec"_a, "tvec"_a, "criteria"_a = none, doc("solvePnPRefineLM"));
    m.def("solvePnPRefineVVS", solvePnPRefineVVS, "objectPoints"_a, "imagePoints"_a, "cameraMatrix"_a, "distCoeffs"_a,
          "rvec"_a, "tvec"_a, "criteria"_a = none, "VVSlambda"_a = 1.0, doc("solvePnPRefineVVS"));

    // Public as gmlpnp.fisheye, a module of the package.
    py::module_ fisheye = m.def_submodule("_fisheye", doc("fisheye"));
    fisheye.def("solvePnP", fisheyeSolvePnP, "objectPoints"_a, "imagePoints"_a, "cameraMatrix"_a, "distCoeffs"_a,
                "rvec"_a = none, "tvec"_a = none, "useExtrinsicGuess"_a = false, "flags"_a = marginal,
                "criteria"_a = none, doc("fisheye.solvePnP"));
}

}  // namespace bindings
