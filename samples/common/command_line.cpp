// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "common/command_line.hpp"

#include <exception>
#include <iostream>
#include <locale>
#include <set>
#include <sstream>

#include "common/output_file.hpp"

namespace samples {

namespace {

//! The names that the keys of a cv::CommandLineParser declare: the words before the first bar of each entry.
std::set<std::string> declaredNames(const std::string& keys)
{
    std::set<std::string> names;
    for (size_t begin = keys.find('{'); begin != std::string::npos; begin = keys.find('{', begin + 1)) {
        std::istringstream words(keys.substr(begin + 1, keys.find('|', begin) - begin - 1));
        for (std::string name; words >> name;)
            names.insert(name);
    }
    return names;
}

std::string optionName(const std::string& argument)
{
    const size_t begin = argument.find_first_not_of('-');
    if (begin == std::string::npos)
        return std::string();
    return argument.substr(begin, argument.find('=') - begin);
}

}  // namespace

std::vector<double> Arguments::numbers(const std::string& name) const
{
    const std::string text = options.get<std::string>(name);
    std::istringstream stream(text);
    stream.imbue(std::locale::classic());
    std::vector<double> values;
    for (double value = 0.0; stream >> value;)
        values.push_back(value);
    if (!stream.eof())
        throw std::runtime_error("--" + name + ": '" + text + "' is not a list of numbers");
    return values;
}

cv::Matx33d cameraMatrixOf(const Arguments& arguments)
{
    const std::vector<double> k = arguments.numbers("camera");
    if (k.size() != 4 || !(k[0] > 0.0) || !(k[1] > 0.0))
        throw std::runtime_error("--camera: expected fx fy cx cy");
    return {k[0], 0.0, k[2], 0.0, k[1], k[3], 0.0, 0.0, 1.0};
}

int runProgram(int argc, char** argv, const std::string& keys, const std::string& about, size_t fewestFiles,
               const std::function<int(const Arguments&)>& run)
{
    const std::set<std::string> names = declaredNames(keys);
    std::string unknown;
    Arguments arguments{cv::CommandLineParser(argc, argv, keys), {}};
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        if (argument[0] != '-')
            arguments.files.push_back(argument);
        else if (!names.count(optionName(argument)))
            unknown = argument;
    }
    arguments.options.about(about);
    const bool help = arguments.options.has("help");
    const bool understood = unknown.empty() && arguments.files.size() >= fewestFiles;
    if (!unknown.empty())
        std::cerr << "unknown option " << unknown << std::endl;
    try {
        int code = help ? 0 : 2;
        if (help || !understood)
            arguments.options.printMessage();
        else
            code = run(arguments);
        files::flushStandardOutput();
        return code;
    } catch (const std::exception& error) {
        std::cerr << argv[0] << ": " << error.what() << std::endl;
        return 1;
    }
}

}  // namespace samples
