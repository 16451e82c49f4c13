// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include <exception>
#include <utility>

#include <opencv2/core.hpp>

#include "module.hpp"

namespace bindings {

namespace {

const char* const kDoc = R"(Misuse: wrong shapes, types, sizes, options or flags. Bad data is no error but a False.

Attributes as of cv2.error: code (-215: assertion, -5: bad argument), err (what is wrong), func, file, line, msg.)";

//! Never released: modules are not unloaded.
PyObject* errorClass = nullptr;

void raise(const cv::Exception& e)
{
    const py::object error = py::reinterpret_borrow<py::object>(errorClass)(py::str(e.what()));
    error.attr("code") = e.code;
    error.attr("err") = e.err;
    error.attr("func") = e.func;
    error.attr("file") = e.file;
    error.attr("line") = e.line;
    error.attr("msg") = e.msg;
    PyErr_SetObject(errorClass, error.ptr());
}

}  // namespace

void addErrors(py::module_& m)
{
    py::dict attributes;  // of an error that Python code raises itself
    attributes["code"] = 0;
    attributes["line"] = 0;
    for (const char* text : {"err", "func", "file", "msg"})
        attributes[text] = "";
    errorClass = PyErr_NewExceptionWithDoc("gmlpnp.error", kDoc, PyExc_RuntimeError, attributes.ptr());
    if (errorClass == nullptr)
        throw py::error_already_set();
    m.attr("error") = py::reinterpret_borrow<py::object>(errorClass);
    py::register_local_exception_translator([](std::exception_ptr thrown) {
        try {
            std::rethrow_exception(std::move(thrown));
        } catch (const cv::Exception& e) {
            raise(e);
        }
    });
}

}  // namespace bindings
