// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "common/correspondences.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <locale>
#include <map>
#include <set>
#include <sstream>

#include "common/output_file.hpp"

namespace samples {

namespace {

using Words = std::vector<std::string>;

//! How far R^T R of a true rotation may be from the identity: files carry six digits or more.
constexpr double kRotationTolerance = 1e-4;

//! Reads one file; it knows the line it stands on, so that every complaint can name it.
class Reader
{
public:
    Reader(const std::string& path, CameraIn camera) : stream_(path), camera_(camera) { set_.path = path; }

    CorrespondenceSet read();

private:
    [[noreturn]] void fail(const std::string& message) const;
    double number(const std::string& word) const;
    std::vector<double> numbers(const Words& words, size_t from, size_t count) const;
    void row(const Words& words);
    void header(const std::string& text, const Words& words);
    void intrinsics(const Words& words);
    void distortion(const Words& words);
    void imageSize(const Words& words);
    void assembleTruth();
    cv::Matx33d rotation(const std::vector<double>& values) const;

    std::ifstream stream_;
    CameraIn camera_;
    int line_ = 0;
    CorrespondenceSet set_;
    std::set<std::string> seen_;
    std::map<std::string, std::vector<double>> truth_;
};

Words split(const std::string& text)
{
    std::istringstream stream(text);
    Words words;
    for (std::string word; stream >> word;)
        words.push_back(word);
    return words;
}

//! A word of the file, short and printable whatever it was.
std::string quoted(const std::string& word)
{
    std::string text = word.substr(0, 24);
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return !std::isprint(c); }, '?');
    return "'" + text + (text.size() < word.size() ? "...'" : "'");
}

size_t truthLength(const std::string& key)
{
    static const std::map<std::string, size_t> lengths = {
        {"true_rvec", 3}, {"true_tvec", 3}, {"true_camera_centre", 3}, {"true_R_world_from_camera", 9}};
    const auto entry = lengths.find(key);
    return entry == lengths.end() ? 0 : entry->second;
}

void Reader::fail(const std::string& message) const
{
    throw std::runtime_error(set_.path + ":" + std::to_string(line_) + ": " + message);
}

double Reader::number(const std::string& word) const
{
    // Not strtod: it follows the program's locale and takes "nan" and "inf" for numbers.
    std::istringstream stream(word);
    stream.imbue(std::locale::classic());
    double value = 0.0;
    if (!(stream >> value) || !stream.eof() || !std::isfinite(value))
        fail(quoted(word) + " is not a finite number");
    return value;
}

std::vector<double> Reader::numbers(const Words& words, size_t from, size_t count) const
{
    if (words.size() != from + count)
        fail("expected " + std::to_string(count) + " numbers, found " +
             std::to_string(words.size() - std::min(from, words.size())));
    std::vector<double> values;
    for (size_t i = from; i < words.size(); ++i)
        values.push_back(number(words[i]));
    return values;
}

void Reader::row(const Words& words)
{
    const std::vector<double> v = numbers(words, 0, 5);
    set_.objectPoints.emplace_back(v[0], v[1], v[2]);
    set_.imagePoints.emplace_back(v[3], v[4]);
}

void Reader::intrinsics(const Words& words)
{
    if (words.size() < 4 || words[1] != "fy" || words[2] != "cx" || words[3] != "cy")
        fail("expected 'fx fy cx cy' and 4 numbers");
    const std::vector<double> v = numbers(words, 4, 4);
    if (v[0] == 0.0 || v[1] == 0.0)
        fail("a focal length of zero");
    set_.cameraMatrix = cv::Matx33d(v[0], 0.0, v[2], 0.0, v[1], v[3], 0.0, 0.0, 1.0);
}

void Reader::distortion(const Words& words)
{
    set_.distCoeffs = numbers(words, 1, words.size() - 1);
    static const std::set<size_t> counts = {0, 4, 5, 8, 12, 14};
    if (!counts.count(set_.distCoeffs.size()))
        fail("expected 0, 4, 5, 8, 12 or 14 distortion coefficients, found " + std::to_string(set_.distCoeffs.size()));
}

void Reader::imageSize(const Words& words)
{
    const std::vector<double> v = numbers(words, 1, 2);
    if (v[0] < 1.0 || v[1] < 1.0 || v[0] > 1e6 || v[1] > 1e6)
        fail("an image of " + words[1] + " x " + words[2] + " pixels");
    set_.imageSize = cv::Size(cv::saturate_cast<int>(v[0]), cv::saturate_cast<int>(v[1]));
}

void Reader::header(const std::string& text, const Words& words)
{
    const std::string key = words.empty() ? std::string() : words[0];
    if (key == "source") {
        const size_t begin = text.find_first_not_of(" \t", text.find("source") + key.size());
        set_.source.push_back(begin == std::string::npos ? std::string() : text.substr(begin));
        return;
    }
    const size_t length = truthLength(key);
    if (length == 0 && key != "fx" && key != "dist" && key != "image_size" && key != "unit")
        return;  // a comment
    if (!seen_.insert(key).second)
        fail("a second '" + key + "' line");
    if (length > 0)
        truth_[key] = numbers(words, 1, length);
    else if (key == "fx")
        intrinsics(words);
    else if (key == "dist")
        distortion(words);
    else if (key == "image_size")
        imageSize(words);
    else if (words.size() != 2)
        fail("expected one word after 'unit'");
    else
        set_.unit = words[1];
}

cv::Matx33d Reader::rotation(const std::vector<double>& values) const
{
    const cv::Matx33d R(values.data());
    if (cv::norm(R.t() * R - cv::Matx33d::eye()) > kRotationTolerance || cv::determinant(R) < 0.0)
        fail("true_R_world_from_camera is not a rotation");
    return R;
}

void Reader::assembleTruth()
{
    const bool direct = truth_.count("true_rvec") && truth_.count("true_tvec");
    const bool inverse = truth_.count("true_camera_centre") && truth_.count("true_R_world_from_camera");
    if (truth_.size() != (direct || inverse ? 2u : 0u))
        fail("the truth is 'true_rvec' and 'true_tvec', or 'true_camera_centre' and 'true_R_world_from_camera'");
    set_.hasTruth = direct || inverse;
    if (direct)
        set_.truth =
            poseFromRotationVector(cv::Vec3d(truth_["true_rvec"].data()), cv::Vec3d(truth_["true_tvec"].data()));
    if (inverse) {
        set_.truth.R = rotation(truth_["true_R_world_from_camera"]).t();
        set_.truth.t = -(set_.truth.R * cv::Vec3d(truth_["true_camera_centre"].data()));
    }
}

CorrespondenceSet Reader::read()
{
    if (!stream_.is_open())
        throw std::runtime_error(set_.path + ": cannot be opened");
    for (std::string text; std::getline(stream_, text);) {
        ++line_;
        if (!text.empty() && text.back() == '\r')
            text.pop_back();
        const size_t begin = text.find_first_not_of(" \t");
        if (begin == std::string::npos)
            continue;
        if (text[begin] == '#')
            header(text, split(text.substr(begin + 1)));
        else
            row(split(text));
    }
    if (stream_.bad())
        throw std::runtime_error(set_.path + ": cannot be read");
    if (set_.objectPoints.size() < kMinCorrespondences)
        fail("the file ends after " + std::to_string(set_.objectPoints.size()) + " points; at least " +
             std::to_string(kMinCorrespondences) + " are needed");
    if (camera_ == CameraIn::kFile && !seen_.count("fx"))
        fail("the file ends without a '# fx fy cx cy' line");
    assembleTruth();
    return set_;
}

void writeHeader(std::ostream& out, const CorrespondenceSet& set)
{
    const cv::Matx33d& K = set.cameraMatrix;
    out << "# 2D-3D correspondences: X Y Z" << (set.unit.empty() ? "" : " [" + set.unit + "]") << "  u v [px]\n";
    for (const std::string& text : set.source)
        out << "# source " << text << "\n";
    out << std::setprecision(12) << "# fx fy cx cy " << K(0, 0) << " " << K(1, 1) << " " << K(0, 2) << " " << K(1, 2)
        << "\n# dist";
    for (const double coefficient : set.distCoeffs)
        out << " " << coefficient;
    out << "\n";
    if (!set.imageSize.empty())
        out << "# image_size " << set.imageSize.width << " " << set.imageSize.height << "\n";
    if (!set.unit.empty())
        out << "# unit " << set.unit << "\n";
    if (!set.hasTruth)
        return;
    const cv::Vec3d r = rotationVector(set.truth.R), t = set.truth.t;
    out << std::fixed << std::setprecision(9) << "# true_rvec " << r[0] << " " << r[1] << " " << r[2]
        << "\n# true_tvec " << t[0] << " " << t[1] << " " << t[2] << "\n";
}

}  // namespace

std::string CorrespondenceSet::name() const
{
    return std::filesystem::path(path).stem().string();
}

cv::Ptr<cv::gmlpnp::CameraModel> CorrespondenceSet::camera() const
{
    return lens ? lens : cv::gmlpnp::CameraModel::pinhole(cameraMatrix, distCoeffs);
}

std::vector<cv::Point3d> centred(std::vector<cv::Point3d> points, cv::Point3d& centroid)
{
    centroid = cv::Point3d();
    for (const cv::Point3d& p : points)
        centroid += p / static_cast<double>(points.size());
    for (cv::Point3d& p : points)
        p -= centroid;
    return points;
}

void requireMatches(const CorrespondenceSet& set, const std::string& first, const std::string& second)
{
    if (set.objectPoints.size() < kMinCorrespondences)
        throw TooFewMatches("only " + std::to_string(set.objectPoints.size()) + " matches between " + first + " and " +
                            second);
}

CorrespondenceSet readCorrespondences(const std::string& path, CameraIn camera)
{
    return Reader(path, camera).read();
}

void writeCorrespondences(const std::string& path, const CorrespondenceSet& set)
{
    files::writeFile(path, [&](std::ostream& out) {
        writeHeader(out, set);
        out << std::fixed;
        for (size_t i = 0; i < set.objectPoints.size(); ++i) {
            const cv::Point3d& p = set.objectPoints[i];
            const cv::Point2d& u = set.imagePoints[i];
            out << std::setprecision(5) << p.x << " " << p.y << " " << p.z << " " << std::setprecision(3) << u.x << " "
                << u.y << "\n";
        }
    });
}

}  // namespace samples
