// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_SAMPLES_FEATURE_MATCHING_HPP
#define GMLPNP_SAMPLES_FEATURE_MATCHING_HPP

#include "common/correspondences.hpp"
#include "common/tum_rgbd.hpp"

namespace samples {

/** How correspondences are made from two RGB-D frames. */
struct MatchingOptions
{
    cv::Matx33d cameraMatrix;
    std::vector<double> distCoeffs;
    int features = 1000;        //!< ORB features per image
    double ransacPixels = 3.0;  //!< threshold of rejectOutliers(), px; 0: every match is kept
    int seed = 1;               //!< of the random numbers it draws
};

/** Correspondences between two frames: the first frame's ORB features lifted to its camera frame by the depth image,
the second frame's pixels. Equal input gives equal output.
@throws std::runtime_error where an image is missing, TooFewMatches where too few matches remain. */
CorrespondenceSet matchFrames(const TumSequence& sequence, const FramePair& pair, const MatchingOptions& options);

}  // namespace samples

#endif  // GMLPNP_SAMPLES_FEATURE_MATCHING_HPP
