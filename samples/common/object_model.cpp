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
    std::vector<cv::Point3d> corners(count);
    for (cv::Point3d& corner : corners)
        file >> corner.x >> corner.y >> corner.z;
    if (!file || corners.empty())
        throw std::runtime_error(path + ": is not a mesh in text form");
    return corners;
}

}  // namespace

ObjectModel readObjectModel(const std::string& folder)
{
    const std::string path = folder + "/cookies_ORB.yml";
    const cv::FileStorage file(path, cv::FileStorage::READ);
    if (!file.isOpened())
        throw std::runtime_error(path + ": cannot be opened");
    ObjectModel model;
    cv::Mat points;
    file["points_3d"] >> points;
    file["descriptors"] >> model.descriptors;
    if (points.empty() || points.rows != model.descriptors.rows)
        throw std::runtime_error(path + ": no points_3d with a row of descriptors each");
    points.reshape(3, points.rows).copyTo(model.points);
    model.corners = readCorners(folder + "/box.ply");
    return model;
}

}  // namespace samples
