// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_SAMPLES_COMPARISON_HPP
#define GMLPNP_SAMPLES_COMPARISON_HPP

#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

#include "common/methods.hpp"

namespace samples {

/** An error that is measured, such as the rotation's in degrees. */
struct Quantity
{
    std::string name, unit;
    int decimals;
};

/** A method's answer to one pair; `errors`, one a quantity, may have a sign. */
struct Outcome
{
    Estimate estimate;
    std::vector<double> errors;
};

/** One pair of pictures. */
struct Trial
{
    std::string name;
    size_t points = 0;
    std::string failure;            //!< why there are no correspondences; empty where there are
    std::vector<Outcome> outcomes;  //!< one a method, none where there are no correspondences
};

/** Methods on the same pairs. A pair without correspondences is a failure of every method. */
struct Comparison
{
    std::vector<Quantity> quantities;
    std::vector<Method> methods;
    std::vector<Trial> trials;
};

/** The absolute errors of a method in the pairs that it solved. */
std::vector<double> absoluteErrors(const Comparison& comparison, size_t method, size_t quantity);

/** Markdown: each method's solved and failed pairs, mean absolute errors with 95 % intervals, medians and time; three
quantities a table. The errors are over the pairs that the method itself solved: read them beside its failures. */
void printErrors(std::ostream& out, const Comparison& comparison, uint64_t seed);

/** Markdown: for each of this module's estimators against every other method the mean paired difference of absolute
errors with its 95 % interval, over the pairs that both solved, and in percent of the other's mean. Negative: this
module's errors are smaller. */
void printDifferences(std::ostream& out, const Comparison& comparison, uint64_t seed);

/** One row a pair and method: what was solved, the pose, the errors, the time. Where there are errors,
samples/python/draw.py draws the file.
@throws std::runtime_error where the file cannot be written. */
void writeComparison(const std::string& path, const Comparison& comparison, const std::string& title);

}  // namespace samples

#endif  // GMLPNP_SAMPLES_COMPARISON_HPP
