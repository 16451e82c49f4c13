// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_RELIABILITY_SOLVERS_HPP
#define GMLPNP_RELIABILITY_SOLVERS_HPP

#include <functional>
#include <vector>

#include "problem.hpp"

namespace reliability {

/** Where a call writes: a guess goes in here, too. */
struct Outputs
{
    cv::Mat_<double> rvec, tvec;
    cv::gmlpnp::Result result;
};

/** A function under test. */
struct Solver
{
    std::string name;
    int method;  //!< a flag of cv::gmlpnp::solvePnP
    bool ours;
    bool wantsPixels;  //!< the others take rays
    bool fullResult;   //!< it writes Outputs::result, the others rvec and tvec
    std::function<bool(const Problem&, Outputs&)> solve;
};

/** The one whose pose is compared with those of a search: the marginal method with a full result. */
constexpr size_t SEARCHED_SOLVER = 0;

/** solvePnP and solveRays with both of our flags, cv::solvePnP with EPNP, ITERATIVE and SQPNP. */
const std::vector<Solver>& allSolvers();

/** What was seen of one call. */
struct Verdict
{
    bool called = false;  //!< problems without pixels are not for every function
    bool solved = false;
    bool threw = false;             //!< cv::Exception
    bool foreignException = false;  //!< another
    bool inputChanged = false;
    bool outputTouched = false;  //!< although there is no pose
    bool badPose = false;    //!< success with a number that is not finite, or a rotation that is none; ours: beyond pi
    bool badResult = false;  //!< success with another such number, or with a covariance that is none
    bool refused = false;    //!< a solvable problem
    bool lost = false;       //!< success on a solvable problem, more than 0.5 rad from the truth
    Pose pose;               //!< of a success
};

Verdict judge(const Solver& solver, const Problem& problem);

}  // namespace reliability

#endif  // GMLPNP_RELIABILITY_SOLVERS_HPP
