// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "fuzzed_arguments.hpp"
#include "outcome.hpp"

#include <cmath>

#include <opencv2/gmlpnp/draw.hpp>

// The lenses: their factories, both directions, writing and reading, and drawing through them.

namespace {

using namespace fuzz;
using cv::gmlpnp::CameraModel;

cv::Ptr<CameraModel> lensOf(Bytes& bytes, const Arguments& in)
{
    const auto K = in.cameraMatrix.in(), D = in.distCoeffs.in();
    // One after the other: compilers differ in the order of a call's arguments.
    const double first = bytes.number(), second = bytes.number();
    cv::Ptr<CameraModel> lens;
    call([&] {
        switch (bytes.between(0, 7)) {
            case 0:
                lens = CameraModel::pinhole(K, D);
                break;
            case 1:
                lens = CameraModel::fisheye(K, D);
                break;
            case 2:
                lens = CameraModel::omnidir(K, D, first);
                break;
            case 3:
                lens = CameraModel::eucm(K, first, second);
                break;
            case 4:
                lens = CameraModel::doubleSphere(K, first, second);
                break;
            case 5:
                lens = CameraModel::equirectangular({bytes.take<int>(), bytes.take<int>()});
                break;
            default:
                lens = in.camera;
        }
    });
    return lens;
}

// A pixel is near its ray's pixel, and its ray has length one: for every lens but the careless.
void pixelsAndRays(Bytes& bytes, const CameraModel& lens)
{
    for (int i = 0; i < 8; ++i) {
        const cv::Point2d pixel{bytes.number(), bytes.number()};
        cv::Vec3d ray = cv::Vec3d::all(-7);
        cv::Matx32d jacobian;
        if (!lens.unprojectPoint(pixel, ray, &jacobian)) {
            require(ray == cv::Vec3d::all(-7), "no ray, none written");
            continue;
        }
        require(std::abs(cv::norm(ray) - 1) < 1e-9, "a unit ray");
        require(cv::checkRange(jacobian, true, nullptr, -DBL_MAX, DBL_MAX), "a finite derivative");
        cv::Point2d again(-7, -7);
        if (lens.projectPoint(ray * std::abs(bytes.number()), again))
            require(std::isfinite(again.x) && std::isfinite(again.y), "a finite pixel");
        else
            require(again == cv::Point2d(-7, -7), "no pixel, none written");
    }
}

void writeAndRead(Bytes& bytes, const CameraModel& lens)
{
    cv::FileStorage out(".yml", cv::FileStorage::WRITE | cv::FileStorage::MEMORY);
    out << "camera"
        << "{";
    lens.write(out);
    out << "}";
    const cv::FileStorage in(out.releaseAndGetString(), cv::FileStorage::READ | cv::FileStorage::MEMORY);
    const cv::Ptr<CameraModel> read = CameraModel::read(in["camera"]);
    const cv::Point2d pixel{bytes.number(), bytes.number()};
    cv::Vec3d before, after;
    require(lens.unprojectPoint(pixel, before) == read->unprojectPoint(pixel, after) && before == after,
            "the camera that was written is the one that is read");
}

void arrays(Bytes& bytes, const Arguments& in, const CameraModel& lens)
{
    cv::Mat rays, valid, jacobian, pixels, seen;
    std::vector<cv::Point2f> points(1);
    call([&] { lens.unproject(in.imagePoints.in(), rays, valid, jacobian); });
    call([&] { lens.project(in.rays.in(), pixels, seen); });
    call([&] { lens.project(in.objectPoints.in(), points); });
    call(
        [&] { lens.unproject(in.imagePoints.in(), bytes.flip() ? cv::_OutputArray(points) : cv::_OutputArray(rays)); });
    require(rays.rows == valid.rows || valid.empty(), "a row for each pixel");
    require(pixels.rows == seen.rows, "a row for each point");
}

void draw(Bytes& bytes, const Arguments& in, const cv::Ptr<CameraModel>& lens)
{
    cv::gmlpnp::Result result;
    result.rvec = in.params.rvec;
    result.tvec = in.params.tvec;
    if (bytes.flip())
        result.poseCovariance = cv::Mat::eye(6, 6, CV_64F) * std::abs(bytes.number());
    const cv::Size size{bytes.between(0, 100), bytes.between(0, 100)};
    cv::Mat image = cv::Mat::zeros(size, CV_8UC(bytes.between(1, 4)));
    const double length = bytes.number();
    const int thickness = bytes.pick({3, 1, 0, -1, 100, 2147483647});
    call([&] { cv::gmlpnp::drawPoseUncertainty(image, lens, result, length, in.objectPoints.in(), thickness); });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    Bytes bytes(data, size);
    const Arguments in(bytes);
    const cv::Ptr<CameraModel> lens = lensOf(bytes, in);
    if (lens) {
        if (lens != in.camera) {
            pixelsAndRays(bytes, *lens);
            writeAndRead(bytes, *lens);
        }
        arrays(bytes, in, *lens);
    }
    draw(bytes, in, lens);
    require(in.unchanged(), "inputs that stay");
    return 0;
}
