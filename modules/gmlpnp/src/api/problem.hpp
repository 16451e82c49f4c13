// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_API_PROBLEM_HPP
#define OPENCV_GMLPNP_API_PROBLEM_HPP

#include "../rays/observations.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

// Arrays of a call as observations: checks, conversions, and the lens that turns pixels into rays.

/** The observations of a call without the points that have no ray. */
struct Problem
{
    Observations observations;
    std::vector<int> used;    //!< rows of the observations in the caller's arrays
    int total = 0;            //!< rows of the caller's arrays
    bool finite = true;       //!< whether pixels and guess are numbers; the solver looks at points and rays
    Mat_<double> rayByPixel;  //!< N x 6, where asked for: derivatives of the rays, row-major 3x2
};

/** A problem of points and rays; StsAssert or StsBadArg for misuse, naming the argument. */
Problem problemFromRays(InputArray objectPoints, InputArray rays, const Params& params);

/** A problem of points and pixels, likewise.
@param wantRayByPixel whether Problem::rayByPixel is needed. */
Problem problemFromPixels(InputArray objectPoints, InputArray imagePoints, const Ptr<CameraModel>& camera,
                          const Params& params, bool wantRayByPixel = false);

/** OpenCV's names refuse too few points by StsAssert; ours return a status. */
void requireEnough(const Problem& problem, int fewest);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_API_PROBLEM_HPP
