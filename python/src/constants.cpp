// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "constants.hpp"

#include <vector>

#include <opencv2/gmlpnp.hpp>

#include "module.hpp"

namespace bindings {

namespace {

struct Constant
{
    const char* name;
    int value;
};

#define GMLPNP_CONSTANT(name)                       \
    Constant                                        \
    {                                               \
#name, static_cast < int>(cv::gmlpnp::name) \
    }

const std::vector<Constant>& methods()
{
    static const std::vector<Constant> constants = {
        GMLPNP_CONSTANT(SOLVEPNP_GMLPNP),
        GMLPNP_CONSTANT(SOLVEPNP_GMLPNP_MARGINAL),
        GMLPNP_CONSTANT(SOLVEPNP_AP3P),
        GMLPNP_CONSTANT(SOLVEPNP_EPNP),
        GMLPNP_CONSTANT(SOLVEPNP_IPPE),
        GMLPNP_CONSTANT(SOLVEPNP_IPPE_SQUARE),
        GMLPNP_CONSTANT(SOLVEPNP_ITERATIVE),
        GMLPNP_CONSTANT(SOLVEPNP_P3P),
        GMLPNP_CONSTANT(SOLVEPNP_SQPNP),
#if CV_VERSION_MAJOR < 5
        GMLPNP_CONSTANT(SOLVEPNP_DLS),
        GMLPNP_CONSTANT(SOLVEPNP_UPNP),
#endif
    };
    return constants;
}

const std::vector<Constant>& searches()
{
    static const std::vector<Constant> constants = {
        GMLPNP_CONSTANT(USAC_DEFAULT), GMLPNP_CONSTANT(USAC_PARALLEL), GMLPNP_CONSTANT(USAC_FM_8PTS),
        GMLPNP_CONSTANT(USAC_FAST),    GMLPNP_CONSTANT(USAC_ACCURATE), GMLPNP_CONSTANT(USAC_PROSAC),
        GMLPNP_CONSTANT(USAC_MAGSAC),
    };
    return constants;
}

const std::vector<Constant>& statuses()
{
    static const std::vector<Constant> constants = {
        GMLPNP_CONSTANT(STATUS_CONVERGED),  GMLPNP_CONSTANT(STATUS_MAX_ROUNDS), GMLPNP_CONSTANT(STATUS_TOO_FEW_POINTS),
        GMLPNP_CONSTANT(STATUS_DEGENERATE), GMLPNP_CONSTANT(STATUS_NOT_FINITE), GMLPNP_CONSTANT(STATUS_NO_CONSENSUS),
    };
    return constants;
}

const std::vector<Constant>& noiseModels()
{
    static const std::vector<Constant> constants = {
        GMLPNP_CONSTANT(NOISE_GIVEN),   GMLPNP_CONSTANT(NOISE_ISOTROPIC), GMLPNP_CONSTANT(NOISE_OBJECT),
        GMLPNP_CONSTANT(NOISE_BEARING), GMLPNP_CONSTANT(NOISE_BOTH),
    };
    return constants;
}

#undef GMLPNP_CONSTANT

std::string nameOf(int value, const std::vector<Constant>& constants)
{
    for (const Constant& constant : constants)
        if (constant.value == value)
            return constant.name;
    return std::to_string(value);
}

}  // namespace

std::string statusName(int status)
{
    return nameOf(status, statuses());
}

std::string methodName(int flag)
{
    return nameOf(flag, methods());
}

void addConstants(py::module_& m)
{
    for (const auto& constants : {methods(), searches(), statuses(), noiseModels()})
        for (const Constant& constant : constants)
            m.attr(constant.name) = constant.value;
}

}  // namespace bindings
