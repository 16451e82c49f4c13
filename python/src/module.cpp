// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "module.hpp"

PYBIND11_MODULE(_gmlpnp, m)
{
    // Each docstring starts with a signature of its own, in cv2's form.
    pybind11::options options;
    options.disable_function_signatures();

    // What is defined here says where users find it: in help(), in tracebacks, in pickles.
    const pybind11::object own_name = m.attr("__name__");
    m.attr("__name__") = "gmlpnp";

    m.attr("__version__") = GMLPNP_VERSION;
    bindings::addErrors(m);
    bindings::addConstants(m);
    bindings::addTypes(m);
    bindings::addCameras(m);
    bindings::addSolvers(m);
    bindings::addRansac(m);
    bindings::addSolvePnP(m);
    bindings::addSolvePnPRansac(m);
#ifdef GMLPNP_HAVE_DRAW
    bindings::addDraw(m);
#endif

    m.attr("__name__") = own_name;
}
