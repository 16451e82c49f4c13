// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include <sstream>

#include <opencv2/gmlpnp.hpp>

#include "constants.hpp"
#include "fields.hpp"
#include "module.hpp"

namespace bindings {

namespace {

using cv::gmlpnp::Params;
using cv::gmlpnp::RansacParams;
using cv::gmlpnp::Result;

//! A value on one line: vectors in full, of matrices the shape.
std::string textOf(const py::object& value)
{
    if (!py::isinstance<py::array>(value))
        return py::repr(value);
    const auto array = py::reinterpret_borrow<py::array>(value);
    std::ostringstream text;
    if (array.size() == 3) {
        const py::array_t<double> numbers(array.attr("ravel")());
        text << "[" << numbers.at(0) << ", " << numbers.at(1) << ", " << numbers.at(2) << "]";
    } else {
        text << "<" << array.shape(0) << "x" << array.shape(1) << ">";
    }
    return text.str();
}

std::string listOf(const py::object& self, const std::vector<std::string>& names)
{
    std::string text;
    for (const std::string& name : names)
        text += ", " + name + "=" + textOf(self.attr(name.c_str()));
    return text;
}

std::vector<std::string> without(const std::string& name, std::vector<std::string> names)
{
    names.erase(std::remove(names.begin(), names.end(), name), names.end());
    return names;
}

void addParams(py::module_& m)
{
    Fields<Params> fields(m, "Params");
    fields.add("method", &Params::method)
        .add("maxRounds", &Params::maxRounds)
        .add("tolerance", &Params::tolerance)
        .add("robust", &Params::robust)
        .add("useExtrinsicGuess", &Params::useExtrinsicGuess)
        .add("rvec", &Params::rvec)
        .add("tvec", &Params::tvec)
        .add("objectNoise", &Params::objectNoise)
        .add("bearingNoise", &Params::bearingNoise)
        .add("objectCovariances", &Params::objectCovariances)
        .add("pixelCovariances", &Params::pixelCovariances);
    fields.finish().def("__repr__", [names = without("method", fields.names())](const py::object& self) {
        return "Params(method=" + methodName(self.attr("method").cast<int>()) + listOf(self, names) + ")";
    });
}

void addRansacParams(py::module_& m)
{
    Fields<RansacParams> fields(m, "RansacParams");
    fields.add("threshold", &RansacParams::threshold)
        .add("confidence", &RansacParams::confidence)
        .add("maxIterations", &RansacParams::maxIterations)
        .add("seed", &RansacParams::seed)
        .add("ordered", &RansacParams::ordered);
    fields.finish().def("__repr__", [names = fields.names()](const py::object& self) {
        return "RansacParams(" + listOf(self, names).substr(2) + ")";
    });
}

void addResult(py::module_& m)
{
    Fields<Result> fields(m, "Result");
    fields.add("status", &Result::status)
        .add("rounds", &Result::rounds)
        .add("cost", &Result::cost)
        .add("rvec", &Result::rvec)
        .add("tvec", &Result::tvec)
        .add("poseCovariance", &Result::poseCovariance)
        .add("poseCovarianceRt", &Result::poseCovarianceRt)
        .add("cameraCenter", &Result::cameraCenter)
        .add("cameraCenterCovariance", &Result::cameraCenterCovariance)
        .add("objectNoise", &Result::objectNoise)
        .add("bearingNoise", &Result::bearingNoise)
        .add("objectNoiseStdErr", &Result::objectNoiseStdErr)
        .add("bearingNoiseStdErr", &Result::bearingNoiseStdErr)
        .add("objectNoiseRank", &Result::objectNoiseRank)
        .add("noiseModel", &Result::noiseModel)
        .add("noiseEvidence", &Result::noiseEvidence)
        .add("poseEvidence", &Result::poseEvidence)
        .add("tailShare", &Result::tailShare)
        .add("tailDof", &Result::tailDof)
        .add("weights", &Result::weights)
        .add("usedPoints", &Result::usedPoints);
    fields.finish().def("__repr__", [names = without("status", fields.names())](const py::object& self) {
        const int status = self.attr("status").cast<int>();
        const bool solved = status == cv::gmlpnp::STATUS_CONVERGED || status == cv::gmlpnp::STATUS_MAX_ROUNDS;
        return "Result(status=" + statusName(status) + (solved ? listOf(self, names) : std::string()) + ")";
    });
}

}  // namespace

void addTypes(py::module_& m)
{
    addParams(m);
    addRansacParams(m);
    addResult(m);
}

}  // namespace bindings
