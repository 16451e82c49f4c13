// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_RANSAC_SEARCH_HPP
#define OPENCV_GMLPNP_RANSAC_SEARCH_HPP

#include "../rays/correspondences.hpp"
#include "metric.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

struct RansacOptions
{
    double confidence;          //!< probability that an all-inlier sample was drawn, at which the search ends
    int maxIterations;          //!< samples of three points at most
    uint64 seed;                //!< of the sampler
    bool ordered;               //!< whether the best correspondences come first: PROSAC
    double chance;              //!< probability that a wrong correspondence is within the threshold of any pose
    std::optional<Pose> guess;  //!< tried first, object frame
};

struct Consensus
{
    Pose pose;       //!< object frame; refined on its inliers
    int iterations;  //!< samples drawn
};

/** The pose of least  sum_i min(|e_i|^2, 1), where e_i is infinite behind the camera (MSAC: Torr and Zisserman 2000).
It is sought among P3P poses of random samples, of which each new best is refined (LO-RANSAC: Chum, Matas, Kittler
2003), until the asked confidence is reached.
@param data at least 4 correspondences.
@param metrics one a point.
@return none where no pose has 4 inliers, or where as many are explained by chance. */
CV_EXPORTS std::optional<Consensus> findConsensus(const Correspondences& data, const std::vector<Metric>& metrics,
                                                  const RansacOptions& options);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_RANSAC_SEARCH_HPP
