// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "common/exterior_orientation.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <locale>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace samples {

namespace {

//! Words between commas or blanks; quotes, of either kind, hold a word together and are left out.
std::vector<std::string> words(const std::string& line)
{
    std::vector<std::string> result;
    std::string word;
    bool inWord = false;
    char quote = 0;
    const auto finish = [&] {
        if (inWord)
            result.push_back(word);
        word.clear();
        inWord = false;
    };
    for (const char c : line) {
        if (quote == 0 && (c == '\'' || c == '"')) {
            quote = c;
            inWord = true;
        } else if (quote != 0 && c == quote) {
            quote = 0;
        } else if (quote == 0 && (c == ',' || c == ' ' || c == '\t' || c == '\r')) {
            finish();
        } else {
            word += c;
            inWord = true;
        }
    }
    finish();
    return result;
}

//! The place of each wanted column in the table.
std::vector<size_t> columnsOf(const std::vector<std::string>& title, const std::string& path)
{
    std::vector<size_t> columns;
    for (const char* const name : {"filename", "x", "y", "z", "omega", "phi", "kappa"}) {
        const auto column = std::find(title.begin(), title.end(), name);
        if (column == title.end())
            throw std::runtime_error(path + ":1: no column '" + name + "'");
        columns.push_back(static_cast<size_t>(column - title.begin()));
    }
    return columns;
}

bool numberOf(const std::string& word, double& number)
{
    std::istringstream stream(word);
    stream.imbue(std::locale::classic());
    return (stream >> number) && stream.eof() && std::isfinite(number);
}

std::string stemOf(const std::string& name)
{
    // Not a path's stem: names such as 0_1.5_2 have dots of their own.
    const size_t dot = name.rfind('.');
    const std::string extension = dot == std::string::npos ? std::string() : name.substr(dot + 1);
    const bool isPicture =
        extension.size() >= 3 && extension.size() <= 4 && extension.find_first_of("0123456789") == std::string::npos;
    return isPicture ? name.substr(0, dot) : name;
}

}  // namespace

Pose poseFromOmegaPhiKappa(const cv::Vec3d& centre, const cv::Vec3d& angles)
{
    const auto about = [&](int axis) {
        cv::Vec3d rotation;
        rotation[axis] = angles[axis] * CV_PI / 180.0;
        return poseFromRotationVector(rotation, {}).R;
    };
    const cv::Matx33d mapFromCamera = about(0) * about(1) * about(2) * cv::Matx33d::diag(cv::Vec3d(1.0, -1.0, -1.0));
    return inverse(Pose{mapFromCamera, centre});
}

std::map<std::string, Pose> readOrientations(const std::string& path)
{
    std::ifstream stream(path);
    std::string line;
    if (!stream.is_open() || !std::getline(stream, line))
        throw std::runtime_error(path + ": cannot be opened");
    const std::vector<size_t> columns = columnsOf(words(line), path);
    const size_t most = *std::max_element(columns.begin(), columns.end());
    std::map<std::string, Pose> poses;
    for (int number = 2; std::getline(stream, line); ++number) {
        const std::vector<std::string> row = words(line);
        if (row.empty())
            continue;
        double v[6];
        bool understood = row.size() > most;
        for (size_t i = 0; i < 6 && understood; ++i)
            understood = numberOf(row[columns[i + 1]], v[i]);
        if (!understood)
            throw std::runtime_error(path + ":" + std::to_string(number) + ": not understood");
        poses[stemOf(row[columns[0]])] = poseFromOmegaPhiKappa({v[0], v[1], v[2]}, {v[3], v[4], v[5]});
    }
    if (poses.empty())
        throw std::runtime_error(path + ": no pictures");
    return poses;
}

cv::Vec3d rollPitchYaw(const Pose& cameraFromMap)
{
    const cv::Matx33d northEastDown(0, 1, 0, 1, 0, 0, 0, 0, -1), cameraFromBody(0, 1, 0, -1, 0, 0, 0, 0, 1);
    const cv::Matx33d R = northEastDown * cameraFromMap.R.t() * cameraFromBody;
    return {degrees(std::atan2(R(2, 1), R(2, 2))), degrees(std::atan2(-R(2, 0), std::hypot(R(0, 0), R(1, 0)))),
            degrees(std::atan2(R(1, 0), R(0, 0)))};
}

double angleDifference(double a, double b)
{
    const double difference = std::remainder(a - b, 360.0);
    return difference == -180.0 ? 180.0 : difference;
}

}  // namespace samples
