// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_SAMPLES_COMMAND_LINE_HPP
#define GMLPNP_SAMPLES_COMMAND_LINE_HPP

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include <opencv2/core/utility.hpp>

namespace samples {

/** A program's arguments. cv::CommandLineParser ignores options it does not know and keeps no list of files; a typing
error must not pass for a default, so both are added here. */
struct Arguments
{
    cv::CommandLineParser options;
    std::vector<std::string> files;  //!< the arguments that are no options

    //! The value of an option. @throws std::runtime_error where it does not have the type.
    template <typename T>
    T get(const std::string& name) const
    {
        T value = options.get<T>(name);
        if (!options.check())
            throw std::runtime_error("--" + name + ": '" + options.get<std::string>(name) + "' is not understood");
        return value;
    }

    //! The numbers of an option that is a list of them, separated by blanks.
    //! @throws std::runtime_error for anything else in it.
    std::vector<double> numbers(const std::string& name) const;
};

/** The camera matrix of an option --camera, "fx fy cx cy" in px. @throws std::runtime_error for anything else. */
cv::Matx33d cameraMatrixOf(const Arguments& arguments);

/** The body of main(): parses the arguments, answers --help, calls `run` and turns an exception, or output that cannot
be written, into a message and exit code 1. Wrong usage (an unknown option, too few files) is exit code 2. */
int runProgram(int argc, char** argv, const std::string& keys, const std::string& about, size_t fewestFiles,
               const std::function<int(const Arguments&)>& run);

}  // namespace samples

#endif  // GMLPNP_SAMPLES_COMMAND_LINE_HPP
