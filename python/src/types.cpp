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

const char* const kParamsDoc = R"(Params([name=value, ...])

Options of a solve. Every option is an attribute and a keyword of the constructor, and has a sensible default:

    params = gmlpnp.Params(method=gmlpnp.SOLVEPNP_GMLPNP, maxRounds=10)

Arrays are copied, both ways: to change one, assign the whole array.)";

const char* const kRansacParamsDoc = R"(RansacParams([name=value, ...])

Options of RANSAC. Every option is an attribute and a keyword of the constructor, and has a sensible default.)";

const char* const kResultDoc = R"(A pose with its noise and its uncertainty: X = R p + t, R the rotation of rvec.

Vectors are (3, 1) float64 arrays like the rvec of cv2, matrices float64 arrays; each access gives a copy. Where a
solve returned False only status means anything.)";

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
    Fields<Params> fields(m, "Params", kParamsDoc);
    fields.add("method", &Params::method, "SOLVEPNP_GMLPNP or SOLVEPNP_GMLPNP_MARGINAL (default).")
        .add("maxRounds", &Params::maxRounds, "Noise/pose rounds at most; 0: the method's own default.")
        .add("tolerance", &Params::tolerance,
             "Change of the cost [nat] below which a round is the last; 0: run all rounds.")
        .add("robust", &Params::robust,
             "Heavy tails where the residuals ask for them (default True): points that are far noisier than most, and "
             "wrong matches that look right, then weigh little. Marginal method only.")
        .add("useExtrinsicGuess", &Params::useExtrinsicGuess,
             "Start at (rvec, tvec) instead of the global solver (default False).")
        .add("rvec", &Params::rvec, "Guess: rotation vector, (3, 1), rad, object to camera.")
        .add("tvec", &Params::tvec, "Guess: translation, (3, 1), the caller's length.")
        .add("objectNoise", &Params::objectNoise,
             "Known object noise Sigma, (3, 3), object frame, length^2; None: estimated.")
        .add("bearingNoise", &Params::bearingNoise,
             "Known bearing noise Gamma, (3, 3), camera frame, rad^2; None: estimated by the marginal method, zero in "
             "the published one.")
        .add("objectCovariances", &Params::objectCovariances,
             "Known covariance of each object point, added to Sigma: (N, 9), rows of a row-major 3x3, object frame, "
             "length^2; None: none.")
        .add("pixelCovariances", &Params::pixelCovariances,
             "Known covariance of each pixel, added to Gamma through the camera: (N, 1) variances or (N, 4), rows of a "
             "row-major 2x2, px^2; None: none. Not for solveRays.");
    fields.finish().def("__repr__", [names = without("method", fields.names())](const py::object& self) {
        return "Params(method=" + methodName(self.attr("method").cast<int>()) + listOf(self, names) + ")";
    });
}

void addRansacParams(py::module_& m)
{
    Fields<RansacParams> fields(m, "RansacParams", kRansacParamsDoc);
    fields
        .add("threshold", &RansacParams::threshold,
             "Largest residual of an inlier: px, of solveRaysRansac rad (below pi/2). 0 (default): 8 px, 0.01 rad.")
        .add("confidence", &RansacParams::confidence,
             "At which the search ends: that a sample of inliers was drawn (default 0.99).")
        .add("maxIterations", &RansacParams::maxIterations,
             "Samples of three points at most (default 10000); few are needed where many points are inliers.")
        .add("seed", &RansacParams::seed, "Of the sampler (default 0): equal seeds, equal results.")
        .add("ordered", &RansacParams::ordered,
             "Correspondences come best first: samples start with them (PROSAC; default False).");
    fields.finish().def("__repr__", [names = fields.names()](const py::object& self) {
        return "RansacParams(" + listOf(self, names).substr(2) + ")";
    });
}

void addResult(py::module_& m)
{
    Fields<Result> fields(m, "Result", kResultDoc);
    fields
        .add("status", &Result::status,
             "One of STATUS_...; STATUS_CONVERGED and STATUS_MAX_ROUNDS are successes, the rest are failures.")
        .add("rounds", &Result::rounds, "Passes over the points that moved pose and noise.")
        .add("cost", &Result::cost, "Negative log-likelihood at the returned values, nat.")
        .add("rvec", &Result::rvec, "Rotation vector, (3, 1), rad, object to camera.")
        .add("tvec", &Result::tvec, "Translation, (3, 1), the caller's length.")
        .add("poseCovariance", &Result::poseCovariance,
             "(6, 6) covariance of the left perturbation (phi, delta): R_true = Exp(phi) R, t_true = Exp(phi) t + "
             "delta; rad and length. None where the data leave no residual to judge it by (three points).")
        .add("poseCovarianceRt", &Result::poseCovarianceRt,
             "(6, 6) covariance of (rvec, tvec), rad and length; None as above.")
        .add("cameraCenter", &Result::cameraCenter, "Centre of the camera -R^T t, (3, 1), object frame, length.")
        .add("cameraCenterCovariance", &Result::cameraCenterCovariance,
             "(3, 3) covariance of cameraCenter, length^2; None as above.")
        .add("objectNoise", &Result::objectNoise,
             "Sigma, (3, 3), noise of the object points, object frame, length^2: estimated, or as given.")
        .add("bearingNoise", &Result::bearingNoise,
             "Gamma, (3, 3), noise of the unit rays, camera frame, rad^2: estimated, or as given.")
        .add("objectNoiseStdErr", &Result::objectNoiseStdErr,
             "(3, 3) standard errors of the entries of objectNoise, length^2, both noises taken for unknown; far above "
             "its trace where the data do not tell. None where it was given, and for the published method.")
        .add("bearingNoiseStdErr", &Result::bearingNoiseStdErr,
             "(3, 3) standard errors of the entries of bearingNoise, rad^2; likewise.")
        .add("objectNoiseRank", &Result::objectNoiseRank,
             "Numerical rank of objectNoise; below 3 it is no estimate of the noise along its null space.")
        .add("noiseModel", &Result::noiseModel, "One of NOISE_...: the likeliest explanation of the residuals.")
        .add(
            "noiseEvidence", &Result::noiseEvidence,
            "By how much the likelihood prefers noiseModel to the next best, nat; inf where there was no choice. Below "
            "about 3 the data cannot tell, and poseCovariance holds the spread of the explanations.")
        .add("poseEvidence", &Result::poseEvidence,
             "By how much this pose is likelier than the best other minimum, nat; inf where there is none or none was "
             "looked for (a guess, RANSAC). Below about 3 the data cannot tell, as with a small flat object far away: "
             "see solveAll. The covariances know of this minimum only.")
        .add(
            "tailShare", &Result::tailShare,
            "Share of the points whose noise is wider than objectNoise and bearingNoise say: for them 6.25 times these "
            "are the scale matrices of a Student-t of 2 degrees of freedom. 0: Gaussian noise.")
        .add("tailDof", &Result::tailDof,
             "Degrees of freedom of the one Student-t that is nearest to this mixture; inf: Gaussian.")
        .add("weights", &Result::weights, "(N, 1) weight of each point, at most 1; 0 for pixels without a ray.")
        .add("usedPoints", &Result::usedPoints, "Points that had a ray.");
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
