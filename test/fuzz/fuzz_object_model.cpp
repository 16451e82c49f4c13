// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "fuzzed_arguments.hpp"
#include "fuzzed_file.hpp"
#include "outcome.hpp"

#include "common/object_model.hpp"

// A textured object: its mesh up to a line of `===`; what follows chooses what stands in its model. OpenCV writes that
// file, so that there is nothing in it that OpenCV's parser, which is not ours, might stumble over.

namespace {

using namespace fuzz;

void writeMatrix(cv::FileStorage& file, Bytes& bytes)
{
    file << "{"
         << "rows" << bytes.pick({1, 0, -1, 2, 5, 2147483647}) << "cols" << bytes.pick({3, 1, 32, 0, -1, 2147483647});
    file << "dt" << bytes.pick({"d", "3f", "u", "32u", "", "9f", "h", "?", "2147483647d"});
    file << "data" << std::vector<double>(static_cast<size_t>(bytes.between(0, 40)), bytes.number());
    file << "}";
}

// `plain`, or something else under its name.
void write(cv::FileStorage& file, const char* name, Bytes& bytes, const cv::Mat& plain)
{
    const int kind = bytes.between(0, 15);
    if (kind == 11)
        return;
    file << name;
    if (kind == 12)
        file << bytes.number();
    else if (kind == 13)
        file << bytes.pick({"none", "", "1"});
    else if (kind == 14)
        file << anyMat(bytes);
    else if (kind == 15)
        writeMatrix(file, bytes);
    else
        file << plain;
}

void writeModel(const std::string& path, Bytes& bytes)
{
    const int points = bytes.pick({5, 1, 40, 0}), descriptors = points + std::max(0, bytes.between(0, 15) - 14);
    cv::FileStorage file(path, cv::FileStorage::WRITE);
    const double coordinate = bytes.between(0, 7) == 7 ? bytes.number() : 1.5;
    const cv::Mat positions(points, 3, CV_32F, cv::Scalar(coordinate));
    write(file, "points_3d", bytes, bytes.flip() ? positions : positions.reshape(3));
    write(file, "descriptors", bytes, cv::Mat(descriptors, 32, CV_8UC1, cv::Scalar(7)));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    const std::string text(reinterpret_cast<const char*>(data), size), border = "===\n";
    const size_t end = std::min(text.find(border), size), rest = std::min(end + border.size(), size);
    fileOf(data, end, "box.ply");
    Bytes bytes(data + rest, size - rest);
    if (!call([&] { writeModel(folder() + "/cookies_ORB.yml", bytes); }))
        return 0;  // nothing that OpenCV can write
    try {
        const samples::ObjectModel model = samples::readObjectModel(folder());
        require(!model.points.empty() && cv::checkRange(model.points), "finite points");
        require(model.descriptors.type() == CV_8UC1 && model.descriptors.cols == 32 &&
                    model.descriptors.rows == static_cast<int>(model.points.size()),
                "a descriptor for each");
        require(!model.corners.empty() && cv::checkRange(model.corners), "finite corners");
    } catch (const std::runtime_error&) {
        // refused, as documented
    }
    return 0;
}
