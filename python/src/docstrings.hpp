// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_PYTHON_DOCSTRINGS_HPP
#define GMLPNP_PYTHON_DOCSTRINGS_HPP

#include <string>

namespace bindings {

/** The docstring of "solve", "Result.rvec" or "fisheye.solvePnP", from the comment of the public C++ header.
@throws std::logic_error for a name without one: the import of the module then fails, and so does its build. */
const char* doc(const std::string& name);

}  // namespace bindings

#endif  // GMLPNP_PYTHON_DOCSTRINGS_HPP
