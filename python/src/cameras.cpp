// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include <filesystem>
#include <memory>
#include <stdexcept>

#include <opencv2/gmlpnp/camera.hpp>

#include "arrays.hpp"
#include "common/output_file.hpp"
#include "docstrings.hpp"
#include "module.hpp"

namespace bindings {

namespace {

using namespace py::literals;
using cv::gmlpnp::CameraModel;
using Camera = std::shared_ptr<CameraModel>;

const char* const kSave = R"(save(filename) -> None

Writes the camera to a YAML, XML or JSON file, by its extension, that load() reads back to an equal camera. The file is
written whole or not at all: after an error what stood there before still does.)";

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
    py::class_<CameraModel, Camera>(m, "CameraModel", doc("CameraModel"))
        .def_static("pinhole", pinhole, "K"_a, "D"_a = py::none(), doc("CameraModel.pinhole"))
        .def_static("fisheye", fisheye, "K"_a, "D"_a = py::none(), doc("CameraModel.fisheye"))
        .def_static("omnidir", omnidir, "K"_a, "D"_a, "xi"_a, doc("CameraModel.omnidir"))
        .def_static("eucm", eucm, "K"_a, "alpha"_a, "beta"_a, doc("CameraModel.eucm"))
        .def_static("doubleSphere", doubleSphere, "K"_a, "xi"_a, "alpha"_a, doc("CameraModel.doubleSphere"))
        .def_static("equirectangular", equirectangular, "size"_a, doc("CameraModel.equirectangular"))
        .def_static("load", load, "filename"_a, "model"_a = "", doc("CameraModel.load"))
        .def("save", save, "filename"_a, kSave)
        .def("unproject", unproject, "imagePoints"_a, doc("CameraModel.unproject"))
        .def("project", project, "points"_a, doc("CameraModel.project"))
        .def("__repr__", textOf)
        .def(py::pickle(&toText, &fromText));
}

}  // namespace bindings
