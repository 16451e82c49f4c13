// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_SAMPLES_STUDY_HPP
#define GMLPNP_SAMPLES_STUDY_HPP

#include <functional>
#include <string>
#include <vector>

#include "common/command_line.hpp"
#include "common/comparison.hpp"
#include "common/isotropy_report.hpp"

namespace samples {

/** The options that all studies share, for a program's own keys. */
extern const char* const kStudyKeys;

struct StudyOptions
{
    std::string output;  //!< folder of everything that is written; empty: nothing is
    int seed;
    int repeat;  //!< calls per method and pair; the time is their median
    bool residuals;
    std::vector<Method> methods;
};

/** @throws std::runtime_error for values that are out of range, unknown methods, and an output folder that cannot be
made. */
StudyOptions studyOptions(const Arguments& arguments);

/** All solvers on many pairs of pictures. */
struct Study
{
    std::string title;
    std::vector<std::string> pairs;  //!< a name each
    //! Makes the correspondences of a pair, with their truth. @throws TooFewMatches: the pair fails, the study goes on.
    std::function<CorrespondenceSet(size_t)> correspondences;
    std::vector<Quantity> quantities;  //!< none where no truth is known
    std::function<std::vector<double>(const Pose& estimate, const Pose& truth)> errors;
    ObjectFrame frame;
    LengthUnit unit{"cm", 100.0};  //!< in which residuals of files in metres are shown
    //! Called for each pair that has correspondences, with the answers in the order of the methods; may be empty.
    std::function<void(size_t, const CorrespondenceSet&, const std::vector<Outcome>&)> visit;
};

/** The rotation's angle [deg] and the distance of the camera's centres [cm], of files in metres. */
void measureMotion(Study& study);

/** Runs the study: a bar while it runs, then tables on stdout and, in the output folder, table.md, errors.csv and
with --residuals residuals.md and residuals.csv.
@return the program's exit code: 1 where no pair at all gave correspondences. */
int runStudy(const Study& study, const StudyOptions& options);

}  // namespace samples

#endif  // GMLPNP_SAMPLES_STUDY_HPP
