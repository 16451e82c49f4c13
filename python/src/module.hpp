// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_PYTHON_MODULE_HPP
#define GMLPNP_PYTHON_MODULE_HPP

#include <utility>

#include <pybind11/pybind11.h>

namespace bindings {

namespace py = pybind11;

void addErrors(py::module_& m);
void addConstants(py::module_& m);
void addTypes(py::module_& m);     // Params, RansacParams, Result
void addCameras(py::module_& m);   // CameraModel
void addSolvers(py::module_& m);   // solve, solveAll, solveRays
void addRansac(py::module_& m);    // solveRansac, solveRaysRansac
void addSolvePnP(py::module_& m);  // the functions with signatures of cv2
void addSolvePnPRansac(py::module_& m);
void addDraw(py::module_& m);  // drawPoseUncertainty, where the library is there

/** Calls `work`, which must not touch Python, while other Python threads run. */
template <class Work>
auto withoutGil(Work&& work)
{
    const py::gil_scoped_release release;
    return std::forward<Work>(work)();
}

}  // namespace bindings

#endif  // GMLPNP_PYTHON_MODULE_HPP
