// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_API_SOLVEPNP_HPP
#define OPENCV_GMLPNP_API_SOLVEPNP_HPP

#include "../precomp.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

// Whether cv::solvePnP knows the flag: those are forwarded.
inline bool isOpenCVFlag(int flags)
{
    return flags >= 0 && flags < SOLVEPNP_MAX_COUNT;
}

// Whether cv::solvePnPRansac knows the flag.
inline bool isOpenCVRansacFlag(int flags)
{
    return isOpenCVFlag(flags) || (flags >= USAC_DEFAULT && flags <= USAC_MAGSAC);
}

// solvePnP with one of our flags and any lens; StsBadArg for every other flag.
bool solvePnPWith(const Ptr<CameraModel>& camera, InputArray objectPoints, InputArray imagePoints, OutputArray rvec,
                  OutputArray tvec, bool useExtrinsicGuess, int flags);

// solvePnPRansac, likewise; `params` holds flag and guess.
bool solvePnPRansacWith(const Ptr<CameraModel>& camera, InputArray objectPoints, InputArray imagePoints,
                        OutputArray rvec, OutputArray tvec, OutputArray inliers, const RansacParams& ransac,
                        const Params& params);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_API_SOLVEPNP_HPP
