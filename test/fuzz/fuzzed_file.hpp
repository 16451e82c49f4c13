// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_FUZZ_FUZZED_FILE_HPP
#define GMLPNP_FUZZ_FUZZED_FILE_HPP

#include <cstdint>
#include <string>

namespace fuzz {

/** A folder of this process, removed at its end. */
const std::string& folder();

/** Writes the input as a file of that folder or of one in it. @return its path. */
std::string fileOf(const uint8_t* data, size_t size, const std::string& name);

/** Lets `read` have the input as a file. Only `Error`, which its reader documents, may come from it. */
template <class Error, class Read>
int read(const uint8_t* data, size_t size, const std::string& name, const Read& read)
{
    try {
        read(fileOf(data, size, name));
    } catch (const Error&) {
        // refused, as documented
    }
    return 0;
}

}  // namespace fuzz

#endif  // GMLPNP_FUZZ_FUZZED_FILE_HPP
