// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "common/tum_rgbd.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <locale>
#include <sstream>
#include <stdexcept>

#include <opencv2/imgcodecs.hpp>

#include "common/images.hpp"

namespace samples {

namespace {

//! Ground truth is recorded at 100 Hz; across a longer gap a straight line is no truth, s.
constexpr double kLongestGap = 0.1;

struct TimedFile
{
    double time = 0.0;
    std::string file;
};

//! Calls `parse(line)` for every line of a list that is not empty and no comment; it returns whether it understood.
template <typename Parse>
void forEachLine(const std::string& path, Parse parse)
{
    std::ifstream stream(path);
    if (!stream.is_open())
        throw std::runtime_error(path + ": cannot be opened");
    int number = 0;
    for (std::string line; std::getline(stream, line);) {
        ++number;
        if (line.empty() || line[0] == '#' || line[0] == '\r')
            continue;
        std::istringstream words(line);
        words.imbue(std::locale::classic());
        if (!parse(words))
            throw std::runtime_error(path + ":" + std::to_string(number) + ": not understood");
    }
}

template <typename Timed>
std::vector<Timed> sortedByTime(std::vector<Timed> list, const std::string& path)
{
    if (list.empty())
        throw std::runtime_error(path + ": no entries");
    std::stable_sort(list.begin(), list.end(), [](const Timed& a, const Timed& b) { return a.time < b.time; });
    return list;
}

//! The entry next to a time; the list is sorted and not empty.
template <typename Timed>
typename std::vector<Timed>::const_iterator nearest(const std::vector<Timed>& list, double time)
{
    const auto after =
        std::lower_bound(list.begin(), list.end(), time, [](const Timed& entry, double t) { return entry.time < t; });
    if (after == list.begin())
        return after;
    const auto before = std::prev(after);
    return after == list.end() || time - before->time <= after->time - time ? before : after;
}

std::vector<TimedFile> readFileList(const std::string& path)
{
    std::vector<TimedFile> list;
    forEachLine(path, [&](std::istringstream& words) {
        TimedFile entry;
        const bool understood = static_cast<bool>(words >> entry.time >> entry.file);
        list.push_back(entry);
        return understood;
    });
    return sortedByTime(list, path);
}

std::vector<TimedPose> readGroundTruth(const std::string& path)
{
    std::vector<TimedPose> list;
    forEachLine(path, [&](std::istringstream& words) {
        TimedPose p;
        words >> p.time;
        for (int i = 0; i < 3; ++i)
            words >> p.centre[i];
        for (int i = 0; i < 4; ++i)
            words >> p.quaternion[i];
        const double length = cv::norm(p.quaternion);
        p.quaternion /= length;
        list.push_back(p);
        return words && length > 0.5 && std::isfinite(length);
    });
    return sortedByTime(list, path);
}

//! The quaternion at the fraction `a` of the great arc from p to q.
cv::Vec4d slerp(const cv::Vec4d& p, cv::Vec4d q, double a)
{
    if (p.dot(q) < 0.0)
        q = -q;  // the same rotation, on the short way
    const double angle = 2.0 * std::atan2(cv::norm(q - p), cv::norm(q + p));
    if (angle < 1e-9)
        return cv::normalize((1.0 - a) * p + a * q);
    return (std::sin((1.0 - a) * angle) * p + std::sin(a * angle) * q) / std::sin(angle);
}

cv::Matx33d rotationMatrix(const cv::Vec4d& quaternion)
{
    const double x = quaternion[0], y = quaternion[1], z = quaternion[2], w = quaternion[3];
    return {1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - z * w),       2.0 * (x * z + y * w),
            2.0 * (x * y + z * w),       1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - x * w),
            2.0 * (x * z - y * w),       2.0 * (y * z + x * w),       1.0 - 2.0 * (x * x + y * y)};
}

}  // namespace

bool tumCalibration(const std::string& sequence, TumCalibration& calibration)
{
    static const std::array<TumCalibration, 3> calibrations = {
        {{{517.3, 0.0, 318.6, 0.0, 516.5, 255.3, 0.0, 0.0, 1.0}, {0.2624, -0.9531, -0.0054, 0.0026, 1.1633}},
         {{520.9, 0.0, 325.1, 0.0, 521.0, 249.7, 0.0, 0.0, 1.0}, {0.2312, -0.7849, -0.0033, -0.0001, 0.9172}},
         {{535.4, 0.0, 320.1, 0.0, 539.2, 247.6, 0.0, 0.0, 1.0}, {}}}};
    for (size_t at = sequence.find("fr"); at != std::string::npos; at = sequence.find("fr", at + 1)) {
        const size_t digit = at + (sequence.compare(at, 8, "freiburg") == 0 ? 8 : 2);
        if (digit < sequence.size() && sequence[digit] >= '1' && sequence[digit] <= '3') {
            calibration = calibrations[static_cast<size_t>(sequence[digit] - '1')];
            return true;
        }
    }
    return false;
}

TumSequence readTumSequence(const std::string& folder)
{
    TumSequence sequence;
    const std::string root = folder.substr(0, folder.find_last_not_of('/') + 1);
    sequence.name = root.substr(root.find_last_of('/') + 1);
    sequence.groundTruth = readGroundTruth(root + "/groundtruth.txt");
    const std::vector<TimedFile> depth = readFileList(root + "/depth.txt");
    for (const TimedFile& colour : readFileList(root + "/rgb.txt")) {
        const auto partner = nearest(depth, colour.time);
        if (std::abs(partner->time - colour.time) <= kAssociationTolerance)
            sequence.frames.push_back({colour.time, root + "/" + colour.file, root + "/" + partner->file});
    }
    if (sequence.frames.empty())
        throw std::runtime_error(root + ": no colour image has a depth image of the same time");
    return sequence;
}

bool interpolate(const std::vector<TimedPose>& groundTruth, double time, Pose& cameraFromWorld)
{
    const auto after = std::lower_bound(groundTruth.begin(), groundTruth.end(), time,
                                        [](const TimedPose& p, double t) { return p.time < t; });
    if (after == groundTruth.begin() || after == groundTruth.end())
        return false;
    const auto before = std::prev(after);
    const double gap = after->time - before->time;
    if (gap > kLongestGap)
        return false;
    const double a = (time - before->time) / gap;
    cameraFromWorld.R = rotationMatrix(slerp(before->quaternion, after->quaternion, a)).t();
    cameraFromWorld.t = -(cameraFromWorld.R * ((1.0 - a) * before->centre + a * after->centre));
    return true;
}

std::vector<FramePair> pairsOf(const TumSequence& sequence, double interval)
{
    std::vector<FramePair> pairs;
    for (size_t i = 0; i < sequence.frames.size(); ++i) {
        const double time = sequence.frames[i].time + interval;
        const auto partner = nearest(sequence.frames, time);
        Pose first, second;
        if (std::abs(partner->time - time) > kAssociationTolerance ||
            !interpolate(sequence.groundTruth, sequence.frames[i].time, first) ||
            !interpolate(sequence.groundTruth, partner->time, second))
            continue;
        FramePair pair;
        pair.first = i;
        pair.second = static_cast<size_t>(partner - sequence.frames.begin());
        pair.secondFromFirst = second * inverse(first);
        pairs.push_back(pair);
    }
    return pairs;
}

cv::Mat readDepthImage(const std::string& path)
{
    cv::Mat depth = readImage(path, cv::IMREAD_UNCHANGED);
    if (depth.type() != CV_16UC1)
        throw std::runtime_error(path + ": a depth image has one channel of 16 bits");
    return depth;
}

double depthAt(const cv::Mat& depth, const cv::Point2f& pixel)
{
    const cv::Point nearestPixel(cvRound(pixel.x), cvRound(pixel.y));
    if (!cv::Rect(cv::Point(), depth.size()).contains(nearestPixel))
        return 0.0;
    return depth.at<ushort>(nearestPixel) / kDepthUnitsPerMetre;
}

}  // namespace samples
