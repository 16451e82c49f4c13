// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_SAMPLES_OUTPUT_FILE_HPP
#define GMLPNP_SAMPLES_OUTPUT_FILE_HPP

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

namespace files {

/** A file that comes into being as a whole or not at all: it is written under another name in the same folder and
renamed by commit(). Without that, after an error for instance, what stood there before still does and nothing is left
over. Devices and pipes are written to directly; a symbolic link stays one, and rights stay what they were. */
class PartialFile
{
public:
    explicit PartialFile(const std::string& path);
    ~PartialFile();
    PartialFile(const PartialFile&) = delete;
    PartialFile& operator=(const PartialFile&) = delete;

    //! Where to write: the extension is that of the file.
    std::string path() const { return partial_.string(); }

    //! @throws std::runtime_error naming the file where it cannot take its place.
    void commit();

    //! @throws std::runtime_error: the file cannot be written.
    [[noreturn]] void fail() const;

private:
    std::string asked_;
    std::filesystem::path target_, partial_;
};

/** A text file of that kind. */
class OutputFile
{
public:
    //! @throws std::runtime_error naming the file where it cannot be opened, before there is anything to lose.
    explicit OutputFile(const std::string& path);

    //! In the classic locale, whatever the global one is.
    std::ostream& stream() { return stream_; }

    //! @throws std::runtime_error where anything could not be written: a full disk.
    void commit();

private:
    PartialFile file_;
    std::ofstream stream_;
};

/** What the program has printed goes where it is to go. Without that a full disk is noticed where nobody asks any more,
after main(). @throws std::runtime_error where anything printed so far could not be written. */
void flushStandardOutput();

/** Writes a file with what `write` puts into the stream. @throws std::runtime_error as OutputFile. */
void writeFile(const std::string& path, const std::function<void(std::ostream&)>& write);

}  // namespace files

#endif  // GMLPNP_SAMPLES_OUTPUT_FILE_HPP
