// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_SAMPLES_UNITS_HPP
#define GMLPNP_SAMPLES_UNITS_HPP

#include <string>

namespace samples {

/** The unit in which lengths are shown, and how many of it make one of the file's. */
struct LengthUnit
{
    std::string name;
    double perFileUnit;
};

//! Metres are shown as centimetres, anything else as it is.
inline LengthUnit shownUnit(const std::string& fileUnit)
{
    if (fileUnit == "m")
        return {"cm", 100.0};
    return {fileUnit.empty() ? "units" : fileUnit, 1.0};
}

}  // namespace samples

#endif  // GMLPNP_SAMPLES_UNITS_HPP
