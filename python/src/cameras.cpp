// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include <filesystem>
#include <memory>
#include <stdexcept>

#include <opencv2/gmlpnp/camera.hpp>

#include "arrays.hpp"
#include "common/output_file.hpp"
#include "module.hpp"

namespace bindings {

namespace {

using namespace py::literals;
using cv::gmlpnp::CameraModel;
using Camera = std::shared_ptr<CameraModel>;

const char* const kDoc = R"(A lens: it turns pixels into unit rays and points into pixels.

Made by its static methods. Camera frame: x right, y down, z forward; pixel (0, 0) is the centre of the top-left
pixel. A camera never changes and may be used from several threads at once. Camera matrices are 3x3; where the lens
has a skew it is K[0, 1]. Values out of their range raise gmlpnp.error, naming the argument.)";

const char* const kPinhole = R"(pinhole(K[, D]) -> retval

The camera of cv2.projectPoints, inverted to convergence.
K: 3x3 camera matrix (no skew). D: None or 4, 5, 8, 12 or 14 distortion coefficients, in OpenCV's order.)";

const char* const kFisheye = R"(fisheye(K[, D]) -> retval

The Kannala-Brandt camera of cv2.fisheye, on the whole sphere. K: 3x3. D: None or k1, k2, k3, k4.)";

const char* const kOmnidir = R"(omnidir(K, D, xi) -> retval

The unified (MEI) camera of cv2.omnidir. K: 3x3. D: None or k1, k2, p1, p2. xi: mirror parameter, 0 or more.)";

const char* const kEucm = R"(eucm(K, alpha, beta) -> retval

The enhanced unified camera. K: 3x3. alpha: from 0 (pinhole) to 1. beta: positive.)";

const char* const kDoubleSphere = R"(doubleSphere(K, xi, alpha) -> retval

The double sphere camera. K: 3x3. xi: between -1 and 1. alpha: from 0 to 1.)";

const char* const kEquirectangular = R"(equirectangular(size) -> retval

An equirectangular panorama, the optical axis in the middle of the picture. size: (width, height), px.)";

const char* const kLoad = R"(load(filename[, model]) -> retval

Reads a camera from YAML, XML or JSON, from the top level or its entry `camera`: this module's own fields, OpenCV's
calibration files, ROS camera_info, KITTI-360.
model: the lens where the file does not tell, "pinhole" (default) or "fisheye".)";

const char* const kSave = R"(save(filename) -> None

Writes the camera to a YAML, XML or JSON file, by its extension, that load() reads back to an equal camera. The file is
written whole or not at all: after an error what stood there before still does.)";

const char* const kUnproject = R"(unproject(imagePoints) -> rays, valid, jacobian

Unit rays of pixels.
imagePoints: N pixels, (N, 2), (N, 1, 2) or (1, N, 2).
rays: (N, 3) float64, unit rays in the camera frame; zero where a pixel has no ray.
valid: (N, 1) uint8, 255 where the pixel has a ray, 0 where it has none; rays[valid.ravel() > 0] are the rays.
jacobian: (N, 6) float64, the 3x2 derivative of the ray with respect to the pixel, row-major, rad/px.)";

const char* const kProject = R"(project(points) -> imagePoints, valid

Pixels of points in the camera frame; their length does not matter.
points: N points, (N, 3), (N, 1, 3) or (1, N, 3).
imagePoints: (N, 2) float64, px; zero where the lens does not see the point.
valid: (N, 1) uint8, 255 where the lens sees the point, 0 where it does not.)";

Camera pinhole(const py::object& K, const py::object& D)
{
    return CameraModel::pinhole(Input(K, "K"), Input(D, "D"));
}

Camera fisheye(const py::object& K, const py::object& D)
{
    return CameraModel::fisheye(Input(K, "K"), Input(D, "D"));
}

Camera omnidir(const py::object& K, const py::object& D, double xi)
{
    return CameraModel::omnidir(Input(K, "K"), Input(D, "D"), xi);
}

Camera eucm(const py::object& K, double alpha, double beta)
{
    return CameraModel::eucm(Input(K, "K"), alpha, beta);
}

Camera doubleSphere(const py::object& K, double xi, double alpha)
{
    return CameraModel::doubleSphere(Input(K, "K"), xi, alpha);
}

Camera equirectangular(const std::pair<int, int>& size)
{
    return CameraModel::equirectangular(cv::Size(size.first, size.second));
}

Camera load(const std::string& filename, const std::string& model)
{
    return CameraModel::load(filename, model);
}

//! In the format of the extension, as cv::FileStorage chooses it.
std::string textAs(const std::string& extension, const CameraModel& camera)
{
    cv::FileStorage storage("camera" + extension, cv::FileStorage::WRITE | cv::FileStorage::MEMORY);
    storage << "camera"
            << "{";
    camera.write(storage);
    storage << "}";
    return storage.releaseAndGetString();
}

std::string toText(const CameraModel& camera)
{
    return textAs(".json", camera);
}

void save(const CameraModel& camera, const std::string& filename)
{
    const std::string extension = std::filesystem::path(filename).extension().string();
    if (extension == ".gz")  // cv::FileStorage would compress
        CV_Error(cv::Error::StsBadArg, filename + ": is not compressed, for load() would not read it");
    const std::string text = textAs(extension, camera);  // not into the file: cv::FileStorage notices no full disk
    try {
        withoutGil([&] { files::writeFile(filename, [&](std::ostream& out) { out << text; }); });
    } catch (const std::runtime_error& error) {
        CV_Error(cv::Error::StsObjectNotFound, error.what());
    }
}

Camera fromText(const std::string& text)
{
    const cv::FileStorage storage(text, cv::FileStorage::READ | cv::FileStorage::MEMORY);
    return CameraModel::read(storage["camera"]);
}

//! {"model": "pinhole", ...} on one line.
std::string textOf(const py::object& camera)
{
    const py::object parsed = py::module_::import("json").attr("loads")(toText(camera.cast<const CameraModel&>()));
    return "CameraModel(" + std::string(py::repr(parsed["camera"])) + ")";
}

py::tuple unproject(const CameraModel& camera, const py::object& imagePoints)
{
    const Input pixels(imagePoints, "imagePoints");
    cv::Mat rays, valid, jacobian;
    withoutGil([&] { camera.unproject(pixels, rays, valid, jacobian); });
    return py::make_tuple(toPython(rays), toPython(valid), toPython(jacobian));
}

py::tuple project(const CameraModel& camera, const py::object& points)
{
    const Input given(points, "points");
    cv::Mat pixels, valid;
    withoutGil([&] { camera.project(given, pixels, valid); });
    return py::make_tuple(toPython(pixels), toPython(valid));
}

}  // namespace

void addCameras(py::module_& m)
{
    py::class_<CameraModel, Camera>(m, "CameraModel", kDoc)
        .def_static("pinhole", pinhole, "K"_a, "D"_a = py::none(), kPinhole)
        .def_static("fisheye", fisheye, "K"_a, "D"_a = py::none(), kFisheye)
        .def_static("omnidir", omnidir, "K"_a, "D"_a, "xi"_a, kOmnidir)
        .def_static("eucm", eucm, "K"_a, "alpha"_a, "beta"_a, kEucm)
        .def_static("doubleSphere", doubleSphere, "K"_a, "xi"_a, "alpha"_a, kDoubleSphere)
        .def_static("equirectangular", equirectangular, "size"_a, kEquirectangular)
        .def_static("load", load, "filename"_a, "model"_a = "", kLoad)
        .def("save", save, "filename"_a, kSave)
        .def("unproject", unproject, "imagePoints"_a, kUnproject)
        .def("project", project, "points"_a, kProject)
        .def("__repr__", textOf)
        .def(py::pickle(&toText, &fromText));
}

}  // namespace bindings
