// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "common/images.hpp"

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <vector>

#include <opencv2/imgcodecs.hpp>

#include "common/output_file.hpp"

namespace samples {

namespace {

//! The decoder of DICOM (GDCM) in Debian's OpenCV 4.6 ends the program on a damaged file. Photographs are not of that
//! kind, so that none is tried.
bool isDicom(const std::string& path)
{
    constexpr std::streamoff MARK = 128;
    char mark[4] = {};
    std::ifstream file(path, std::ios::binary);
    file.seekg(MARK).read(mark, sizeof mark);
    return std::string(mark, sizeof mark) == "DICM";
}

}  // namespace

cv::Mat readImage(const std::string& path, int flags)
{
    cv::Mat image;
    try {
        if (!isDicom(path))
            image = cv::imread(path, flags);
    } catch (const cv::Exception&) {
        // A header that names a size no picture has: reported like a file that is none.
    }
    if (image.empty())
        throw std::runtime_error(path + ": cannot be read as an image");
    return image;
}

void writeImage(const std::string& path, const cv::Mat& image)
{
    std::vector<uchar> bytes;  // not cv::imwrite, which does not notice a full disk
    bool encoded = false;
    try {
        encoded = cv::imencode(std::filesystem::path(path).extension().string(), image, bytes);
    } catch (const cv::Exception&) {
        // No codec for the extension: reported like a folder that is not there.
    }
    if (!encoded)
        throw std::runtime_error(path + ": cannot be written");
    files::writeFile(path, [&](std::ostream& out) {
        out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    });
}

}  // namespace samples
