// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_SAMPLES_ISOTROPY_REPORT_HPP
#define GMLPNP_SAMPLES_ISOTROPY_REPORT_HPP

#include <array>
#include <ostream>
#include <string>

#include "common/isotropy.hpp"
#include "common/units.hpp"

namespace samples {

/** How an object frame is called and its axes. */
struct ObjectFrame
{
    std::string name;                 //!< "camera frame of the first picture"
    std::array<std::string, 3> axes;  //!< "x", "y", "z"
};

/** Markdown: second moments of the residuals and those that isotropic noise would give, their eigenvalues as standard
deviations, and both p-values. */
void printIsotropy(std::ostream& out, const Isotropy& isotropy, const ObjectFrame& frame, const LengthUnit& unit);

/** What residuals under the true motion are of. */
struct ResidualsAbout
{
    std::string title;
    ObjectFrame frame;
    std::string unit;                           //!< of their lengths
    const std::vector<std::string>& pairNames;  //!< by TrueResidual::pair
};

/** One row a residual, with the second moments and the test in the head, for samples/python/draw.py.
@throws std::runtime_error where the file cannot be written. */
void writeTrueResiduals(const std::string& path, const std::vector<TrueResidual>& residuals, const Isotropy& isotropy,
                        const ResidualsAbout& about);

}  // namespace samples

#endif  // GMLPNP_SAMPLES_ISOTROPY_REPORT_HPP
