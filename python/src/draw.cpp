// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include <memory>

#include <opencv2/gmlpnp/draw.hpp>

#include "arrays.hpp"
#include "docstrings.hpp"
#include "module.hpp"

namespace bindings {

namespace {

using namespace py::literals;
using Camera = std::shared_ptr<cv::gmlpnp::CameraModel>;

cv::Mat pictureFrom(const py::object& object)
{
    if (!py::isinstance<py::array_t<unsigned char>>(object))
        CV_Error(cv::Error::StsBadArg, "image must be an array of uint8");
    auto array = py::reinterpret_borrow<py::array>(object);
    if (!(array.flags() & py::array::c_style) || !array.writeable() || array.ndim() < 2 || array.ndim() > 3)
        CV_Error(cv::Error::StsBadArg, "image must be C-contiguous, writeable, and have 2 or 3 axes");
    const int channels = array.ndim() == 3 ? static_cast<int>(array.shape(2)) : 1;
    if (channels < 1 || channels > 4)
        CV_Error(cv::Error::StsBadArg, "image must have 1, 3 or 4 channels");
    return cv::Mat(static_cast<int>(array.shape(0)), static_cast<int>(array.shape(1)), CV_8UC(channels),
                   array.mutable_data());
}

py::object drawPoseUncertainty(py::object image, const Camera& camera, const cv::gmlpnp::Result& result, double length,
                               const py::object& points, int thickness)
{
    cv::Mat picture = pictureFrom(image);
    const Input around(points, "points");
    cv::gmlpnp::drawPoseUncertainty(picture, camera, result, length, around, thickness);
    return image;
}

}  // namespace

void addDraw(py::module_& m)
{
    m.def("drawPoseUncertainty", drawPoseUncertainty, "image"_a, "camera"_a, "result"_a, "length"_a,
          "points"_a = py::none(), "thickness"_a = 3, doc("drawPoseUncertainty"));
}

}  // namespace bindings
