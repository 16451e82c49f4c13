// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include <opencv2/gmlpnp.hpp>

#include "module.hpp"
#include "solvepnp.hpp"

// Functions whose parameters and returns are those of cv2, name by name.

namespace bindings {

namespace {

using namespace py::literals;
using cv::TermCriteria;

const char* const kSolvePnP =
    R"(solvePnP(objectPoints, imagePoints, cameraMatrix, distCoeffs[, rvec[, tvec[, useExtrinsicGuess[, flags]]]]) -> retval, rvec, tvec

Drop-in for cv2.solvePnP: the same parameters, the same returns. With the flags of this module any four or more
points will do, coplanar or not (three with a guess), and a guess is honoured; all other flags go to OpenCV.
objectPoints: N points, object frame, (N, 3), (N, 1, 3) or (1, N, 3).
imagePoints: N pixels, (N, 2), (N, 1, 2) or (1, N, 2).
cameraMatrix: 3x3. distCoeffs: None or 4, 5, 8, 12 or 14 coefficients.
rvec, tvec: a guess, and, where they are float arrays of shape (3, 1) or (3,), filled.
useExtrinsicGuess: start at rvec, tvec. flags: SOLVEPNP_...; default SOLVEPNP_GMLPNP_MARGINAL.
retval: True with a finite pose; False where the data give none.
rvec: rotation vector, (3, 1), rad, X = R p + t. tvec: translation, (3, 1), the caller's length. Where retval is False
they are what was passed, None by default.)";

const char* const kSolvePnPGeneric =
    R"(solvePnPGeneric(objectPoints, imagePoints, cameraMatrix, distCoeffs[, rvecs[, tvecs[, useExtrinsicGuess[, flags[, rvec[, tvec[, reprojectionError]]]]]]]) -> retval, rvecs, tvecs, reprojectionError

Drop-in for cv2.solvePnPGeneric: every distinct pose, best first. Arguments as in solvePnP().
rvecs, tvecs, reprojectionError: outputs only; what is passed is not looked at.
rvec, tvec: the guess, never written; one pose comes out.
retval: the number of poses; 0 where the data give none.
rvecs, tvecs: tuples of (3, 1) arrays. reprojectionError: (retval, 1), root mean square over both coordinates of all
points, px; None without poses.)";

const char* const kSolvePnPRefine =
    R"(solvePnPRefine(objectPoints, imagePoints, cameraMatrix, distCoeffs, rvec, tvec[, criteria]) -> rvec, tvec

The marginal method from a given pose, which it never makes worse; three or more points. Arguments as in solvePnP().
rvec, tvec: the pose; float arrays of shape (3, 1) or (3,) are filled. Unchanged where the data give no pose.
criteria: (type, maxCount, epsilon); the count bounds the rounds, epsilon is not used.)";

const char* const kSolvePnPRefineLM =
    R"(solvePnPRefineLM(objectPoints, imagePoints, cameraMatrix, distCoeffs, rvec, tvec[, criteria]) -> rvec, tvec

cv2.solvePnPRefineLM.)";

const char* const kSolvePnPRefineVVS =
    R"(solvePnPRefineVVS(objectPoints, imagePoints, cameraMatrix, distCoeffs, rvec, tvec[, criteria[, VVSlambda]]) -> rvec, tvec

cv2.solvePnPRefineVVS.)";

const char* const kFisheyeSolvePnP =
    R"(solvePnP(objectPoints, imagePoints, cameraMatrix, distCoeffs[, rvec[, tvec[, useExtrinsicGuess[, flags[, criteria]]]]]) -> retval, rvec, tvec

Drop-in for cv2.fisheye.solvePnP (OpenCV 4.10 and newer): as gmlpnp.solvePnP, for the Kannala-Brandt lens. The flags of
this module work on rays, also at 90 degrees and beyond; the flags of OpenCV need all rays in front of the camera.
distCoeffs: None or k1, k2, k3, k4. criteria: not used, the lens is inverted to convergence.)";

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
          "tvec"_a = none, "useExtrinsicGuess"_a = false, "flags"_a = marginal, kSolvePnP);
    m.def("solvePnPGeneric", solvePnPGeneric, "objectPoints"_a, "imagePoints"_a, "cameraMatrix"_a, "distCoeffs"_a,
          "rvecs"_a = none, "tvecs"_a = none, "useExtrinsicGuess"_a = false, "flags"_a = marginal, "rvec"_a = none,
          "tvec"_a = none, "reprojectionError"_a = none, kSolvePnPGeneric);
    m.def("solvePnPRefine", solvePnPRefine, "objectPoints"_a, "imagePoints"_a, "cameraMatrix"_a, "distCoeffs"_a,
          "rvec"_a, "tvec"_a, "criteria"_a = none, kSolvePnPRefine);
    m.def("solvePnPRefineLM", solvePnPRefineLM, "objectPoints"_a, "imagePoints"_a, "cameraMatrix"_a, "distCoeffs"_a,
          "rvec"_a, "tvec"_a, "criteria"_a = none, kSolvePnPRefineLM);
    m.def("solvePnPRefineVVS", solvePnPRefineVVS, "objectPoints"_a, "imagePoints"_a, "cameraMatrix"_a, "distCoeffs"_a,
          "rvec"_a, "tvec"_a, "criteria"_a = none, "VVSlambda"_a = 1.0, kSolvePnPRefineVVS);

    // Public as gmlpnp.fisheye, a module of the package.
    py::module_ fisheye = m.def_submodule("_fisheye");
    fisheye.def("solvePnP", fisheyeSolvePnP, "objectPoints"_a, "imagePoints"_a, "cameraMatrix"_a, "distCoeffs"_a,
                "rvec"_a = none, "tvec"_a = none, "useExtrinsicGuess"_a = false, "flags"_a = marginal,
                "criteria"_a = none, kFisheyeSolvePnP);
}

}  // namespace bindings
