// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_PYTHON_SOLVEPNP_HPP
#define GMLPNP_PYTHON_SOLVEPNP_HPP

#include <tuple>

#include "arrays.hpp"

// What the functions with signatures of cv2 have in common.

namespace bindings {

//! (type, maxCount, epsilon), as in cv2; None is that of the functions that refine.
inline cv::TermCriteria criteriaFrom(const py::object& criteria)
{
    if (criteria.is_none())
        return {cv::TermCriteria::EPS + cv::TermCriteria::COUNT, 20, FLT_EPSILON};
    try {
        const auto [type, maxCount, epsilon] = criteria.cast<std::tuple<int, int, double>>();
        return {type, maxCount, epsilon};
    } catch (const py::cast_error&) {
        throw py::type_error("'criteria' must be a tuple (type, maxCount, epsilon)");
    }
}

//! What every function there starts with.
struct Data
{
    Data(const py::object& objectPoints, const py::object& imagePoints, const py::object& cameraMatrix,
         const py::object& distCoeffs)
        : points(objectPoints, "objectPoints"),
          pixels(imagePoints, "imagePoints"),
          K(cameraMatrix, "cameraMatrix"),
          D(distCoeffs, "distCoeffs")
    {}

    Input points, pixels, K, D;
};

}  // namespace bindings

#endif  // GMLPNP_PYTHON_SOLVEPNP_HPP
