// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "docstrings.hpp"

#include <map>
#include <stdexcept>

namespace bindings {

const char* doc(const std::string& name)
{
    static const std::map<std::string, const char*> docstrings = {
#include "docstrings.inc"
    };
    const auto found = docstrings.find(name);
    if (found == docstrings.end())
        throw std::logic_error("the C++ headers do not describe " + name);
    return found->second;
}

}  // namespace bindings
