// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_PYTHON_ARRAYS_HPP
#define GMLPNP_PYTHON_ARRAYS_HPP

#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <opencv2/gmlpnp.hpp>

// numpy at the one side, cv::Mat at the other. All functions here need the GIL.

namespace bindings {

namespace py = pybind11;

/** An array that is read: a numpy array or anything numpy makes one of; None is an empty Mat.

float32 stays float32, so that the flags of OpenCV see what they see through cv2; all other real numbers become
float64. Memory is shared where type and layout allow, and kept alive. As in cv2, the last of three axes becomes the
channels. @throws cv::Exception StsBadArg for anything but real numbers, naming the argument. */
class Input
{
public:
    Input(const py::object& object, const char* name);

    const cv::Mat& mat() const { return mat_; }
    operator cv::_InputArray() const { return cv::_InputArray(mat_); }

private:
    py::object owner_;
    cv::Mat mat_;
};

/** A rotation vector or translation that is written, and read where it is a guess.

As in cv2, a float array of shape (3, 1) or (3,) is filled and returned itself; in place of None or anything else a
new 3x1 array is returned. */
class InOutVector
{
public:
    InOutVector(const py::object& object, const char* name);

    cv::Mat mat;  //!< 3x1, or empty

    //! The array that was given, now with the values of `mat`, or a new one; None where `mat` is empty.
    py::object toPython() const;

private:
    py::object fillable_;  // None: there is no array to fill
};

//! A copy: rows x cols, with several channels rows x cols x channels. None for an empty Mat, as in cv2.
py::object toPython(const cv::Mat& mat);
py::object toPython(const cv::Vec3d& vec);  //!< 3x1
py::object toPython(double value);
py::object toPython(int value);
py::object toPython(bool value);
py::tuple toPython(const std::vector<cv::Mat>& mats);

//! Values of attributes; the array is copied. @throws cv::Exception or TypeError, naming the attribute.
void fromPython(const py::object& object, const char* name, cv::Mat& mat);
void fromPython(const py::object& object, const char* name, cv::Vec3d& vec);
void fromPython(const py::object& object, const char* name, double& value);
void fromPython(const py::object& object, const char* name, int& value);
void fromPython(const py::object& object, const char* name, bool& value);

}  // namespace bindings

#endif  // GMLPNP_PYTHON_ARRAYS_HPP
