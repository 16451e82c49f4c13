// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "common/object_model.hpp"

#include <fstream>
#include <stdexcept>

namespace samples {

namespace {

// The vertices of a PLY file in text form.
std::vector<cv::Point3d> readCorners(const std::string& path)
{
    std::ifstream file(path);
    if (!file)
        throw std::runtime_error(path + ": cannot be opened");
    std::string word;
    size_t count = 0;
    while (file >> word && word != "end_header")
        if (word == "vertex")
            file >> count;
    std::vector<cv::Point3d> corners;  // as many as there are: what the file says may be any number
    for (cv::Point3d corner; corners.size() < count && file >> corner.x >> corner.y >> corner.z;)
        corners.push_back(corner);
    if (corners.empty() || corners.size() < count)
        throw std::runtime_error(path + ": is not a mesh in text form");
    return corners;
}

// Empty where there is none. OpenCV makes room for the matrix before it looks at how many numbers there are.
cv::Mat matrixOf(const cv::FileNode& node)
{
    const auto side = [&](const char* name) { return node[name].isInt() ? static_cast<int>(node[name]) : 0; };
    cv::Mat matrix;
    if (!node.isMap() || side("rows") < 1 || side("cols") < 1)
        return matrix;
    if (static_cast<double>(side("rows")) * side("cols") <= static_cast<double>(node["data"].size()))
        node >> matrix;
    return matrix;
}

void readPoints(const std::string& path, ObjectModel& model)
{
    const cv::FileStorage file(path, cv::FileStorage::READ);
    if (!file.isOpened())
        throw std::runtime_error("cannot be opened");
    const cv::Mat points = matrixOf(file["points_3d"]);
    if (points.empty() || points.cols * points.channels() != 3 || !cv::checkRange(points))
        throw std::runtime_error("points_3d is not a matrix of points");
    points.reshape(3).copyTo(model.points);
    model.descriptors = matrixOf(file["descriptors"]);
    constexpr int OF_ORB = 32;  // bytes
    if (model.descriptors.type() != CV_8UC1 || model.descriptors.cols != OF_ORB ||
        model.descriptors.rows != points.rows)
        throw std::runtime_error("descriptors is not a matrix of ORB's, a row for each of points_3d");
}

}  // namespace

ObjectModel readObjectModel(const std::string& folder)
{
    const std::string path = folder + "/cookies_ORB.yml";
    ObjectModel model;
    try {
        readPoints(path, model);
    } catch (const std::exception& e) {  // of cv::FileStorage too
        throw std::runtime_error(path + ": " + e.what());
    }
    model.corners = readCorners(folder + "/box.ply");
    return model;
}

}  // namespace samples
