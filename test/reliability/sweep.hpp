// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_RELIABILITY_SWEEP_HPP
#define GMLPNP_RELIABILITY_SWEEP_HPP

#include <array>

#include "search.hpp"
#include "solvers.hpp"

namespace reliability {

struct Settings
{
    int problems = 1000000;
    int searched = 0;  //!< the first so many problems are also searched, where they can be
    int starts = 50;   //!< of a search
    int seed = 1;
    int threads = 1;
};

/** How often something was seen of one function. */
struct Tally
{
    long calls = 0, solved = 0, threw = 0, foreignException = 0, inputChanged = 0, outputTouched = 0, badPose = 0,
         badResult = 0;
    long solvable = 0, refused = 0, lost = 0;
    long searched = 0, above = 0;                      //!< solvable, compared with a search, more than a nat above it
    long searchedUnsolvable = 0, aboveUnsolvable = 0;  //!< likewise of the others
};

/** One call that was not as it should be. */
struct Failure
{
    int index;
    size_t solver;  //!< in allSolvers()
    std::string what;
    double above;  //!< nat, where it was searched
};

struct Sweep
{
    std::vector<Tally> tallies;     //!< of allSolvers()
    std::vector<Failure> failures;  //!< of our functions, by index
};

Sweep sweep(const Settings& settings);

}  // namespace reliability

#endif  // GMLPNP_RELIABILITY_SWEEP_HPP
