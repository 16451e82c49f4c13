// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_API_RESULT_HPP
#define OPENCV_GMLPNP_API_RESULT_HPP

#include "../arrays/outputs.hpp"
#include "../estimator/solve.hpp"
#include "problem.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

// The solver's answers as the caller gets them.

/** The most likely pose of a problem, or nothing and the reason. */
struct Answer
{
    Status status = STATUS_TOO_FEW_POINTS;
    std::vector<Solution> solutions;  //!< best first; empty where the status is no success

    explicit operator bool() const { return isSuccess(status); }
    const Solution& best() const { return solutions.front(); }
};

/** The solver's answer to a problem. */
Answer answerTo(const Problem& problem, const Options& options);

Result toResult(const Solution& solution, Status status, const Problem& problem);

/** Solves one problem. On a failure only Result::status is written. */
bool solveToResult(const Problem& problem, const Options& options, Result& result);

/** Rotation vector and translation of a pose. */
void addPose(const Pose& pose, OutputArray rvec, OutputArray tvec, Outputs& outputs);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_API_RESULT_HPP
