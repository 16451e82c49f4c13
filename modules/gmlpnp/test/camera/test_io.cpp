// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../test_data.hpp"
#include "camera_util.hpp"

#include <cstdio>
#include <fstream>

namespace opencv_test {
namespace {

using namespace camera;

Ptr<CameraModel> readText(const String& text, const String& model = String())
{
    const FileStorage fs(text, FileStorage::READ | FileStorage::MEMORY);
    return CameraModel::read(fs.root(), model);
}

class TemporaryFile
{
public:
    TemporaryFile(const std::string& text, const char* extension) : name(tempfile(extension))
    {
        std::ofstream(name, std::ios::binary) << text;
    }
    ~TemporaryFile() { std::remove(name.c_str()); }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    const String name;
};

Ptr<CameraModel> loadText(const std::string& text, const String& model = String(), const char* extension = ".yml")
{
    return CameraModel::load(TemporaryFile(text, extension).name, model);
}

void expectSame(const Ptr<CameraModel>& a, const Ptr<CameraModel>& b, double maxAngle = 40)
{
    for (const Vec3d& m : polarGrid(maxAngle * kDegree)) {
        Point2d p, q;
        ASSERT_TRUE(a->projectPoint(m, p));
        ASSERT_TRUE(b->projectPoint(m, q));
        ASSERT_EQ(p, q) << m;
    }
}

const char* const kHeader = "%YAML:1.0\n---\n";
const char* const kK =
    ": !!opencv-matrix\n   rows: 3\n   cols: 3\n   dt: d\n"
    "   data: [ 407.5, 0., 630.5, 0., 409.25, 431.5, 0., 0., 1. ]\n";
const char* const kD = ": !!opencv-matrix\n   rows: 1\n   cols: 4\n   dt: d\n   data: [ -0.01, 0.02, 0.003, -0.004 ]\n";
const Matx33d kMatrix = matrixK(407.5, 409.25, 630.5, 431.5);
const Vec4d kCoefficients(-0.01, 0.02, 0.003, -0.004);

std::string calibration(const std::string& K, const std::string& D, const std::string& more = "")
{
    return kHeader + K + kK + D + kD + more;
}

TEST(Gmlpnp_CameraIo, openCVCalibrations)
{
    const Ptr<CameraModel> pinhole = CameraModel::pinhole(kMatrix, kCoefficients);
    expectSame(readText(calibration("camera_matrix", "distortion_coefficients")), pinhole);
    expectSame(readText(calibration("cameraMatrix", "distCoeffs")), pinhole);
    expectSame(readText(calibration("K", "D")), pinhole);
    expectSame(readText(calibration("camera_matrix", "distortion_coefficients", "fisheye_model: 0\n")), pinhole);

    const Ptr<CameraModel> fisheye = CameraModel::fisheye(kMatrix, kCoefficients);
    expectSame(readText(calibration("camera_matrix", "distortion_coefficients", "fisheye_model: 1\n")), fisheye);
    expectSame(readText(calibration("K", "D"), "fisheye"), fisheye);
    expectSame(readText(calibration("K", "D", "distortion_model: equidistant\n")), fisheye);

    const Ptr<CameraModel> omnidir = CameraModel::omnidir(kMatrix, kCoefficients, 1.25);
    expectSame(readText(calibration("K", "D", "xi: 1.25\n")), omnidir, 110);
    expectSame(
        readText(calibration("K", "D", "xi: !!opencv-matrix\n   rows: 1\n   cols: 1\n   dt: d\n   data: [ 1.25 ]\n")),
        omnidir, 110);
}

TEST(Gmlpnp_CameraIo, whatOpenCVWrites)
{
    for (const char* extension : {".yml", ".xml", ".json"}) {
        FileStorage out(extension, FileStorage::WRITE | FileStorage::MEMORY);
        out << "K" << Mat(kMatrix) << "D" << Mat(kCoefficients) << "xi" << Mat(1, 1, CV_64F, Scalar(1.25));
        const String text = out.releaseAndGetString();
        expectSame(readText(text), CameraModel::omnidir(kMatrix, kCoefficients, 1.25), 110);
        expectSame(loadText(text, "", extension), CameraModel::omnidir(kMatrix, kCoefficients, 1.25), 110);

        FileStorage plain(extension, FileStorage::WRITE | FileStorage::MEMORY);
        plain << "camera_matrix" << Mat(kMatrix) << "distortion_coefficients" << Mat();
        expectSame(readText(plain.releaseAndGetString()), CameraModel::pinhole(kMatrix));
    }
}

TEST(Gmlpnp_CameraIo, filesWithoutHeaderWithTabsAndComments)
{
    const Ptr<CameraModel> pinhole = CameraModel::pinhole(kMatrix, kCoefficients);
    const std::string ros =
        "image_width: 640\ncamera_name: left\ncamera_matrix:\n  rows: 3\n  cols: 3\n"
        "  data: [407.5, 0, 630.5, 0, 409.25, 431.5, 0, 0, 1]\ndistortion_model: plumb_bob\n"
        "distortion_coefficients:\n  rows: 1\n  cols: 4\n  data: [-0.01, 0.02, 0.003, -0.004]\n";
    expectSame(loadText(ros), pinhole);
    expectSame(loadText("# a comment\n\n" + ros), pinhole);
    expectSame(loadText("---\n" + ros), pinhole);
    expectSame(loadText("%YAML:1.0\n" + ros), pinhole);
    expectSame(loadText("%YAML:1.0\n---\n" + ros), pinhole);
    expectSame(loadText("\xEF\xBB\xBF%YAML:1.0\r\n---\r\nK:\t[407.5, 0, 630.5, 0, 409.25, 431.5, 0, 0, 1]\r\n"
                        "D:\t[-0.01, 0.02, 0.003, -0.004]\r\n"),
               pinhole);
    expectSame(loadText("camera:\n  model: pinhole\n  K: [407.5, 0, 630.5, 0, 409.25, 431.5, 0, 0, 1]\n"
                        "  D: [-0.01, 0.02, 0.003, -0.004]\n"),
               pinhole);
}

TEST(Gmlpnp_CameraIo, mei)
{
    const std::string mei =
        "%YAML:1.0\nmodel_type: MEI\ncamera_name: image_02\nmirror_parameters:\n   xi: 1.25\n"
        "distortion_parameters:\n   k1: -0.01\n   k2: 0.02\n   p1: 0.003\n   p2: -0.004\n"
        "projection_parameters:\n   gamma1: 407.5\n   gamma2: 409.25\n   u0: 630.5\n   v0: 431.5\n";
    expectSame(loadText(mei), CameraModel::omnidir(kMatrix, kCoefficients, 1.25), 110);
    std::string broken = mei;
    broken.replace(broken.find("gamma2"), 6, "gamma3");
    expectError(Error::StsParseError, "gamma2", [&] { loadText(broken); });
}

TEST(Gmlpnp_CameraIo, malformedFilesNameTheFieldAndTheFile)
{
    const auto refuses = [](const std::string& text, const std::string& word, int code = Error::StsParseError) {
        expectError(code, word, [&] { readText(kHeader + text); });
        expectError(code, word, [&] { loadText(text); });
        expectError(code, ".yml: ", [&] { loadText(text); });
    };
    const std::string K = "K: [407.5, 0, 630.5, 0, 409.25, 431.5, 0, 0, 1]\n", D = "D: [0, 0, 0, 0]\n";
    refuses("a: 1\n", "camera field missing");
    refuses("D: []\n", "camera_matrix");
    refuses(K, "distortion_coefficients");
    refuses("K: hello\n" + D, "'K'");
    refuses("K: [1, 2, a, 4, 5, 6, 7, 8, 9]\n" + D, "'K'");
    refuses("K: [1, 2, 3, 4]\n" + D, "'K'");
    refuses("K: {rows: 3, cols: 3, data: [1, 2]}\n" + D, "'K'");
    refuses("K: {rows: -3, cols: -3, data: [1, 2, 3, 4, 5, 6, 7, 8, 9]}\n" + D, "'K'");
    refuses("K: {rows: 99999999, cols: 99999999, data: [1]}\n" + D, "'K'");
    refuses("K: {cols: 3, data: [1]}\n" + D, "'K'");
    refuses("K: {rows: 3, cols: 3}\n" + D, "'K'");
    refuses(K + D + "xi: far\n", "'xi'");
    refuses(K + D + "xi: [1, 2]\n", "'xi'");
    refuses(K + D + "model: pinhole2\n", "pinhole2");
    refuses(K + D + "model: 3\n", "'model'");
    refuses(K + D + "distortion_model: thin\n", "thin");
    refuses(K + "model: eucm\nalpha: 0.5\n", "'beta'");
    refuses("model: equirectangular\nwidth: 100\n", "'height'");
    refuses("model_type: MEI\n", "mirror_parameters");
    refuses(K + "D: [0, 0, 0]\n", "'D'", Error::StsAssert);
    refuses("K: [0, 0, 630.5, 0, 409.25, 431.5, 0, 0, 1]\n" + D, "'K'", Error::StsBadArg);
    refuses(K + D + "xi: .NaN\n", "'xi'", Error::StsBadArg);
    EXPECT_EQ(Error::StsParseError, errorCode([] { CameraModel::read(FileNode()); }));
    expectError(Error::StsObjectNotFound, "/no/such/file.yml", [] { CameraModel::load("/no/such/file.yml"); });
}

TEST(Gmlpnp_CameraIo, errorsOfTheParserNameTheLine)
{
    expectError(Error::StsParseError, ".yml: (4)", [] { loadText("%YAML:1.0\n---\na: 1\n]b\n"); });
}

TEST(Gmlpnp_CameraIo, ofSeveralDocumentsTheFirstCounts)
{
    const std::string whole = calibration("K", "D");
    for (const char* more : {"...\n", "---\nK: 1\n", "...\n---\nK: 1\n", "# a\n\n", "  # a\n...\n"})
        expectSame(loadText(whole + more), CameraModel::pinhole(kMatrix, kCoefficients));
    expectSame(loadText("--- # a\n\n  K: [407.5, 0, 630.5, 0, 409.25, 431.5, 0, 0, 1]\n  D: []\n...\n"),
               CameraModel::pinhole(kMatrix));
}

// The message is that of calibrationText(): the parser of OpenCV has not seen the text.
TEST(Gmlpnp_CameraIo, whatLeavesTheMappingNeverReachesTheParser)
{
    expectError(Error::StsParseError, ".yml: has a line that leaves its mapping", [] { loadText("  a: 1\nb: 2\n"); });
}

// Whatever stands in a file: a camera or a cv::Exception that names the file.
TEST(Gmlpnp_CameraIo, damagedFilesThrow)
{
    const std::string whole = calibration("K", "D", "xi: 1.25\n");
    for (size_t length = 0; length < whole.size(); length += 3) {
        std::string message;
        if (errorCode([&] { loadText(whole.substr(0, length)); }, &message) != 0) {
            EXPECT_NE(message.find(".yml: "), std::string::npos) << message;
        }
    }
    for (const std::string& text : {std::string(), std::string(" \n\t\n"), std::string("# only\n# comments"),
                                    std::string("%"), std::string("{"), std::string("<a>"), std::string("[1, 2]"),
                                    std::string("- 1\n- 2\n"), std::string("K\0D", 3), std::string("\x1f\x8b\x08 gz")})
        EXPECT_NE(errorCode([&] { loadText(text); }), 0) << text;
}

// It has no size and no end.
TEST(Gmlpnp_CameraIo, aDeviceIsNoCalibration)
{
    if (std::ifstream("/dev/zero")) {
        EXPECT_EQ(Error::StsParseError, errorCode([] { CameraModel::load("/dev/zero"); }));
    }
}

TEST(Gmlpnp_CameraIo, kitti360)
{
    for (const char* name : {"kitti360/calibration/image_02.yaml", "kitti360/calibration/image_03.yaml"}) {
        const std::string file = dataFile(name);
        if (file.empty())
            GMLPNP_SKIP(kNoData);
        const Ptr<CameraModel> camera = CameraModel::load(file);
        for (int v = 0; v < 1400; v += 20)
            for (int u = 0; u < 1400; u += 20) {
                Vec3d ray;
                Point2d again;
                if (!camera->unprojectPoint(Point2d(u, v), ray)) {
                    ASSERT_GT(cv::norm(Point2d(u, v) - Point2d(705, 705)), 690) << u << " " << v;  // black corners
                    continue;
                }
                ASSERT_TRUE(camera->projectPoint(ray, again));
                ASSERT_LT(cv::norm(again - Point2d(u, v)), 1e-9) << u << " " << v;
            }
    }
}

// The calibration's own board poses reproject its corners to its rms of 0.81 px.
TEST(Gmlpnp_CameraIo, omnidirectionalChessboard)
{
    const BoardCalibration boards = omnidirChessboard();
    if (boards.views.empty())
        GMLPNP_SKIP(kNoData);
    double squares = 0;
    int n = 0;
    for (const BoardView& view : boards.views) {
        squares += squaredPixelErrors(*boards.camera, view, view.rvec, view.tvec);
        n += view.corners.rows;
    }
    ASSERT_EQ(n, 15 * 54);
    EXPECT_NEAR(std::sqrt(squares / n), 0.81, 0.02);
}

}  // namespace
}  // namespace opencv_test
