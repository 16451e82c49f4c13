// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_ESTIMATOR_INITIAL_POSE_HPP
#define OPENCV_GMLPNP_ESTIMATOR_INITIAL_POSE_HPP

#include "../rays/ray_pass.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

/** A local minimum of the isotropic object-space cost  sum_i |m_i x (R p_i + t)|^2. */
struct PoseCandidate
{
    Pose pose;
    double cost;
};

/** Minima up to this ratio to the best cost are kept: noise of one shape for all points may have swapped them. */
constexpr double INITIAL_COST_RATIO = 2;

/** A proof that there is no other minimum up to this ratio: more would leave most scenes without a proof. */
constexpr double CERTIFIED_COST_RATIO = 1.1;

/** All distinct minima with most points in front of the camera, best first, whose cost is within `costRatio` of the
best; empty where there is none. One is enough where it is proved to be the only one up to the ratio `certified`;
infinite ratios: no proof is tried. No guess is needed; any direction of the rays will do. */
CV_EXPORTS std::vector<PoseCandidate> initialPoses(const Correspondences& data, double costRatio = INITIAL_COST_RATIO,
                                                   double certified = CERTIFIED_COST_RATIO);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_ESTIMATOR_INITIAL_POSE_HPP
