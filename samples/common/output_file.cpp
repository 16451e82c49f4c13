// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "common/output_file.hpp"

#include <cstdio>
#include <iostream>
#include <locale>
#include <random>
#include <stdexcept>

namespace files {

namespace fs = std::filesystem;

PartialFile::PartialFile(const std::string& path) : asked_(path), target_(path), partial_(path)
{
    std::error_code error;
    const fs::path real = fs::canonical(target_, error);  // through links; an error where there is nothing yet
    if (!error)
        target_ = partial_ = real;
    if (!error && !fs::is_regular_file(target_, error))
        return;
    // Other processes and threads may be writing the same file.
    partial_.replace_filename(target_.stem().string() + ".partial" + std::to_string(std::random_device{}()) +
                              target_.extension().string());
}

PartialFile::~PartialFile()
{
    std::error_code ignored;
    if (partial_ != target_)
        fs::remove(partial_, ignored);
}

void PartialFile::commit()
{
    std::error_code error, ignored;
    if (partial_ != target_) {
        const fs::file_status old = fs::status(target_, ignored);
        if (fs::exists(old))
            fs::permissions(partial_, old.permissions(), ignored);
        fs::rename(partial_, target_, error);
    }
    if (error)
        fail();
    partial_ = target_;
}

void PartialFile::fail() const
{
    throw std::runtime_error(asked_ + ": cannot be written");
}

OutputFile::OutputFile(const std::string& path) : file_(path), stream_(file_.path(), std::ios::binary)
{
    if (!stream_)
        file_.fail();
    stream_.imbue(std::locale::classic());
}

void OutputFile::commit()
{
    stream_.close();  // a stream that failed before stays failed
    if (!stream_)
        file_.fail();
    file_.commit();
}

void writeFile(const std::string& path, const std::function<void(std::ostream&)>& write)
{
    OutputFile file(path);
    write(file.stream());
    file.commit();
}

void flushStandardOutput()
{
    std::cout.flush();
    if (!std::cout || std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
        throw std::runtime_error("standard output: cannot be written");
}

}  // namespace files
