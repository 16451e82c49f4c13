// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "arrays.hpp"

#include <climits>
#include <cstring>

namespace bindings {

namespace {

constexpr int DENSE = py::array::c_style | py::array::forcecast | py::detail::npy_api::NPY_ARRAY_ALIGNED_;

template <class T>
using Dense = py::array_t<T, DENSE>;

[[noreturn]] void refuse(const char* name, const std::string& why)
{
    CV_Error(cv::Error::StsBadArg, cv::format("'%s' %s", name, why.c_str()));
}

py::array arrayFrom(const py::object& object, const char* name)
{
    const py::array array = py::array::ensure(object);
    if (!array)
        refuse(name, "cannot be read as an array of numbers");
    const char kind = array.dtype().kind();
    if (kind != 'f' && kind != 'i' && kind != 'u')
        refuse(name,
               "must hold real numbers; numpy makes an array of " + std::string(py::str(array.dtype())) + " of it");
    for (py::ssize_t axis = 0; axis < array.ndim(); ++axis)
        if (array.shape(axis) > INT_MAX)
            refuse(name, "is too large");
    if (kind == 'f' && array.itemsize() == sizeof(float))
        return Dense<float>(array);
    return Dense<double>(array);
}

cv::Mat matOver(const py::array& array)
{
    const int depth = array.itemsize() == sizeof(float) ? CV_32F : CV_64F;
    std::vector<int> sizes;
    for (py::ssize_t axis = 0; axis < array.ndim(); ++axis)
        sizes.push_back(static_cast<int>(array.shape(axis)));
    int channels = 1;
    if (sizes.size() == 3 && sizes[2] > 0 && sizes[2] <= CV_CN_MAX) {
        channels = sizes[2];
        sizes.pop_back();
    }
    while (sizes.size() < 2)
        sizes.push_back(1);
    const int type = CV_MAKETYPE(depth, channels);
    if (array.size() == 0)
        return cv::Mat(sizes, type);
    return cv::Mat(sizes, type, const_cast<void*>(array.data()));  // read only, but Mat has no way to say so
}

bool isFillable(const py::object& object)
{
    if (!py::isinstance<Dense<float>>(object) && !py::isinstance<Dense<double>>(object))
        return false;
    const auto array = py::reinterpret_borrow<py::array>(object);
    const bool column = array.ndim() == 1 || (array.ndim() == 2 && array.shape(1) == 1);
    return array.writeable() && (array.flags() & py::array::c_style) && column && array.size() == 3;
}

}  // namespace

Input::Input(const py::object& object, const char* name)
{
    if (object.is_none())
        return;
    const py::array array = arrayFrom(object, name);
    owner_ = array;
    mat_ = matOver(array);
}

InOutVector::InOutVector(const py::object& object, const char* name)
{
    mat = Input(object, name).mat().clone();
    if (mat.total() * static_cast<size_t>(mat.channels()) == 3)
        mat = mat.reshape(1, std::vector<int>{3, 1});
    fillable_ = isFillable(object) ? object : py::none();
}

py::object InOutVector::toPython() const
{
    if (fillable_.is_none())
        return bindings::toPython(mat);
    auto array = py::reinterpret_borrow<py::array>(fillable_);
    cv::Mat values;
    mat.convertTo(values, array.itemsize() == sizeof(float) ? CV_32F : CV_64F);
    CV_Assert(values.isContinuous() && values.total() == 3);
    std::memcpy(array.mutable_data(), values.data, static_cast<size_t>(array.nbytes()));
    return fillable_;
}

py::object toPython(const cv::Mat& mat)
{
    if (mat.empty())
        return py::none();
    const cv::Mat dense = mat.isContinuous() ? mat : mat.clone();
    std::vector<py::ssize_t> shape(dense.size.p, dense.size.p + dense.dims);
    if (dense.channels() > 1)
        shape.push_back(dense.channels());
    switch (dense.depth()) {
        case CV_8U:
            return py::array_t<unsigned char>(shape, dense.data);
        case CV_32S:
            return py::array_t<int>(shape, dense.ptr<int>());
        case CV_32F:
            return py::array_t<float>(shape, dense.ptr<float>());
        case CV_64F:
            return py::array_t<double>(shape, dense.ptr<double>());
        default:
            CV_Error(cv::Error::StsUnsupportedFormat, cv::format("no numpy type for depth %d", dense.depth()));
    }
}

py::object toPython(const cv::Vec3d& vec)
{
    return toPython(cv::Mat(vec));
}

py::object toPython(double value)
{
    return py::float_(value);
}

py::object toPython(int value)
{
    return py::int_(value);
}

py::object toPython(bool value)
{
    return py::bool_(value);
}

py::tuple toPython(const std::vector<cv::Mat>& mats)
{
    py::tuple arrays(mats.size());
    for (size_t i = 0; i < mats.size(); ++i)
        arrays[i] = toPython(mats[i]);
    return arrays;
}

void fromPython(const py::object& object, const char* name, cv::Mat& mat)
{
    mat = Input(object, name).mat().clone();
}

void fromPython(const py::object& object, const char* name, cv::Vec3d& vec)
{
    const Input given(object, name);
    if (given.mat().total() * static_cast<size_t>(given.mat().channels()) != 3)
        refuse(name, "must hold 3 numbers");
    cv::Mat values;
    given.mat().reshape(1, std::vector<int>{3, 1}).convertTo(values, CV_64F);
    vec = values;
}

namespace {

template <class T>
void fromScalar(const py::object& object, const char* name, const char* type, T& value)
{
    try {
        value = object.cast<T>();
    } catch (const py::cast_error&) {
        throw py::type_error(cv::format("'%s' must be %s, not %s", name, type,
                                        std::string(py::str(py::type::of(object).attr("__name__"))).c_str()));
    }
}

}  // namespace

void fromPython(const py::object& object, const char* name, double& value)
{
    fromScalar(object, name, "a number", value);
}

void fromPython(const py::object& object, const char* name, int& value)
{
    fromScalar(object, name, "an integer", value);
}

void fromPython(const py::object& object, const char* name, bool& value)
{
    if (object.is_none())  // which pybind11 takes for False
        throw py::type_error(cv::format("'%s' must be a truth value, not NoneType", name));
    fromScalar(object, name, "a truth value", value);
}

}  // namespace bindings
