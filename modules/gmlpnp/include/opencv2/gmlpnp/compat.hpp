// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_COMPAT_HPP
#define OPENCV_GMLPNP_COMPAT_HPP

// This header, and no other file, knows the differences between the versions of OpenCV that the module supports.

#include <opencv2/core.hpp>
#include <opencv2/core/version.hpp>

#if CV_VERSION_MAJOR >= 5
#include <opencv2/geometry.hpp>  // solvePnP and friends moved here
#else
#include <opencv2/calib3d.hpp>
#endif

namespace cv {
namespace gmlpnp {

// These are the flags of cv::solvePnP. With them `cv::gmlpnp::` can replace `cv::` in front of any flag.
using cv::SOLVEPNP_AP3P;
using cv::SOLVEPNP_EPNP;
using cv::SOLVEPNP_IPPE;
using cv::SOLVEPNP_IPPE_SQUARE;
using cv::SOLVEPNP_ITERATIVE;
using cv::SOLVEPNP_P3P;
using cv::SOLVEPNP_SQPNP;
#if CV_VERSION_MAJOR < 5
using cv::SOLVEPNP_DLS;
using cv::SOLVEPNP_UPNP;
#endif

// These flags of cv::solvePnPRansac choose another search.
using cv::USAC_ACCURATE;
using cv::USAC_DEFAULT;
using cv::USAC_FAST;
using cv::USAC_FM_8PTS;
using cv::USAC_MAGSAC;
using cv::USAC_PARALLEL;
using cv::USAC_PROSAC;

// These are its options.
using cv::UsacParams;

}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_COMPAT_HPP
