// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_PYTHON_CONSTANTS_HPP
#define GMLPNP_PYTHON_CONSTANTS_HPP

#include <string>

namespace bindings {

//! "STATUS_CONVERGED"; the number where it has no name.
std::string statusName(int status);

//! "SOLVEPNP_GMLPNP"; the number where it has no name.
std::string methodName(int flag);

}  // namespace bindings

#endif  // GMLPNP_PYTHON_CONSTANTS_HPP
