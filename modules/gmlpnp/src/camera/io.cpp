// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "calibration_text.hpp"

#include <fstream>

// This file reads cameras from calibration files. Each lens writes itself; READERS has one line per lens that reads it
// back.

namespace cv {
namespace gmlpnp {
namespace {

using Names = std::initializer_list<const char*>;

constexpr Names MATRIX_NAMES = {"K", "camera_matrix", "cameraMatrix", "Camera_Matrix", "camera_Matrix", "CameraMatrix"};
constexpr Names DISTORTION_NAMES = {
    "D", "distortion_coefficients", "distortionCoefficients", "Distortion_Coefficients", "distCoeffs", "dist_coeffs"};
constexpr int LARGEST_SIDE = 64;                  // no matrix of a camera has so many rows or columns
constexpr size_t LARGEST_FILE = size_t(1) << 26;  // bytes; no calibration is so long

[[noreturn]] void parseError(const String& message)
{
    CV_Error(Error::StsParseError, message);
}

bool isNumber(const FileNode& node)
{
    return node.isInt() || node.isReal();
}

double numberOf(const FileNode& map, const char* name)
{
    const FileNode node = map[name];
    if (!isNumber(node))
        parseError(format("camera field '%s' is missing or not a number", name));
    return static_cast<double>(node);
}

FileNode mapOf(const FileNode& map, const char* name)
{
    const FileNode node = map[name];
    if (!node.isMap())
        parseError(format("camera field '%s' is missing or not a mapping", name));
    return node;
}

String stringOf(const FileNode& map, const char* name)
{
    const FileNode node = map[name];
    if (node.empty())
        return String();
    if (!node.isString())
        parseError(format("camera field '%s' is not a string", name));
    return static_cast<String>(node);
}

int sideOf(const FileNode& matrix, const char* side, const char* name)
{
    const FileNode node = matrix[side];
    const int n = node.isInt() ? static_cast<int>(node) : -1;
    if (n < 0 || n > LARGEST_SIDE)
        parseError(format("camera field '%s' is a matrix without proper '%s'", name, side));
    return n;
}

// Returns a matrix from a mapping of OpenCV or ROS (rows, cols, data), or from a plain list of `listRows` rows.
Mat matrixOf(const FileNode& node, const char* name, int listRows)
{
    if (!node.isMap() && !node.isSeq())
        parseError(format("camera field '%s' is neither a matrix nor a list", name));
    const FileNode data = node.isMap() ? node["data"] : node;
    std::vector<double> values;
    if (isNumber(data))
        values.push_back(static_cast<double>(data));
    for (size_t i = 0; data.isSeq() && i < data.size(); ++i) {
        const FileNode item = data[static_cast<int>(i)];
        if (!isNumber(item))
            parseError(format("camera field '%s' holds something else than numbers", name));
        values.push_back(static_cast<double>(item));
    }
    const int n = static_cast<int>(values.size());
    const int rows = node.isMap() ? sideOf(node, "rows", name) : listRows;
    const int cols = node.isMap() ? sideOf(node, "cols", name) : n / listRows;
    if (rows * cols != n)
        parseError(format("camera field '%s' holds %d numbers instead of %d x %d", name, n, rows, cols));
    return n == 0 ? Mat() : Mat(values, true).reshape(1, rows);
}

Mat firstOf(const FileNode& map, Names names, int listRows)
{
    for (const char* name : names)
        if (!map[name].empty())
            return matrixOf(map[name], name, listRows);
    String tried;
    for (const char* name : names)
        tried += String(tried.empty() ? "'" : ", '") + name + "'";
    parseError("camera field missing: one of " + tried);
}

Mat matrixK(const FileNode& map)
{
    return firstOf(map, MATRIX_NAMES, 3);
}

Mat coefficientsD(const FileNode& map)
{
    return firstOf(map, DISTORTION_NAMES, 1);
}

// cv::omnidir::calibrate returns xi as a 1x1 matrix.
double mirror(const FileNode& map)
{
    const FileNode node = map["xi"];
    if (!node.isMap() && !node.isSeq())
        return numberOf(map, "xi");
    const Mat xi = matrixOf(node, "xi", 1);
    if (xi.total() != 1)
        parseError("camera field 'xi' is not one number");
    return xi.at<double>(0);
}

Ptr<CameraModel> readMei(const FileNode& map)
{
    const FileNode m = mapOf(map, "mirror_parameters"), d = mapOf(map, "distortion_parameters");
    const FileNode p = mapOf(map, "projection_parameters");
    const Matx33d K(numberOf(p, "gamma1"), 0, numberOf(p, "u0"), 0, numberOf(p, "gamma2"), numberOf(p, "v0"), 0, 0, 1);
    const Vec4d D(numberOf(d, "k1"), numberOf(d, "k2"), numberOf(d, "p1"), numberOf(d, "p2"));
    return CameraModel::omnidir(K, D, numberOf(m, "xi"));
}

Size sizeOf(const FileNode& map)
{
    return {saturate_cast<int>(numberOf(map, "width")), saturate_cast<int>(numberOf(map, "height"))};
}

struct Reader
{
    const char* model;
    Ptr<CameraModel> (*read)(const FileNode& map);
};

const Reader READERS[] = {
    {"pinhole", [](const FileNode& m) { return CameraModel::pinhole(matrixK(m), coefficientsD(m)); }},
    {"fisheye", [](const FileNode& m) { return CameraModel::fisheye(matrixK(m), coefficientsD(m)); }},
    {"omnidir", [](const FileNode& m) { return CameraModel::omnidir(matrixK(m), coefficientsD(m), mirror(m)); }},
    {"eucm",
     [](const FileNode& m) { return CameraModel::eucm(matrixK(m), numberOf(m, "alpha"), numberOf(m, "beta")); }},
    {"doubleSphere",
     [](const FileNode& m) { return CameraModel::doubleSphere(matrixK(m), numberOf(m, "xi"), numberOf(m, "alpha")); }},
    {"equirectangular", [](const FileNode& m) { return CameraModel::equirectangular(sizeOf(m)); }},
    {"MEI", readMei},
};

// Returns the name of the lens. The file's own word comes first, then the lens that its fields imply, then the caller's
// word.
String modelOf(const FileNode& map, const String& callers)
{
    for (const char* name : {"model", "model_type"})
        if (!stringOf(map, name).empty())
            return stringOf(map, name);
    const String ros = stringOf(map, "distortion_model");
    if (ros == "plumb_bob" || ros == "rational_polynomial")
        return "pinhole";
    if (ros == "equidistant" || ros == "fisheye")
        return "fisheye";
    if (!ros.empty())
        parseError("camera field 'distortion_model' is unknown: " + ros);
    if (!map["fisheye_model"].empty() && numberOf(map, "fisheye_model") != 0)
        return "fisheye";
    if (!map["xi"].empty())
        return "omnidir";
    return callers.empty() ? "pinhole" : callers;
}

// Returns the bytes of a file. The file must be small, and it must end.
String contentOf(const String& filename)
{
    std::ifstream file(filename, std::ios::binary);
    if (!file)
        CV_Error(Error::StsObjectNotFound, "cannot be opened");
    file.seekg(0, std::ios::end);
    const std::streamoff size = file.tellg();
    if (size < 0 || static_cast<size_t>(size) > LARGEST_FILE)
        parseError("is not a calibration file");
    file.seekg(0);
    String text(static_cast<size_t>(size) + 1, '\0');
    text.resize(static_cast<size_t>(file.read(&text[0], size + 1).gcount()));
    if (text.size() > static_cast<size_t>(size))  // a device has no size, and some have no end
        parseError("is not a calibration file");
    return text;
}

}  // namespace

Ptr<CameraModel> CameraModel::read(const FileNode& node, const String& model)
{
    if (!node.isMap())
        parseError("a camera must be a mapping");
    const String name = modelOf(node, model);
    for (const Reader& reader : READERS)
        if (name == reader.model)
            return reader.read(node);
    parseError("unknown camera model '" + name + "'");
}

Ptr<CameraModel> CameraModel::load(const String& filename, const String& model)
{
    try {
        const FileStorage fs(detail::calibrationText(contentOf(filename)), FileStorage::READ | FileStorage::MEMORY);
        const FileNode root = fs.root();
        if (!root.isMap())
            parseError("holds no mapping");
        return read(root["camera"].isMap() ? root["camera"] : root, model);
    } catch (const Exception& e) {
        // OpenCV's parsers put their message into the place of the function. A message has spaces, a function has none.
        const bool isSwapped = e.func.find(' ') != String::npos;
        CV_Error(e.code, filename + ": " + (isSwapped ? e.func : e.err));
    } catch (const std::exception& e) {  // OpenCV's parsers let std::length_error through
        CV_Error(Error::StsParseError, filename + ": " + e.what());
    }
}

}  // namespace gmlpnp
}  // namespace cv
