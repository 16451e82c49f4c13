// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "fuzzed_file.hpp"

#include <filesystem>
#include <fstream>

#include <unistd.h>

namespace fuzz {

namespace {

struct Folder
{
    Folder() : path((std::filesystem::temp_directory_path() / ("gmlpnp_fuzz_" + std::to_string(::getpid()))).string())
    {
        std::filesystem::create_directories(path);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder()
    {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }

    std::string path;
};

}  // namespace

const std::string& folder()
{
    static const Folder one;
    return one.path;
}

std::string fileOf(const uint8_t* data, size_t size, const std::string& name)
{
    std::string path = folder() + "/" + name;
    std::filesystem::create_directories(std::filesystem::path(path).parent_path());
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    return path;
}

}  // namespace fuzz
