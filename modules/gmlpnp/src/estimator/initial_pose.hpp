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

/** Minima up to this ratio to the best cost are kept, because noise of one shape for all points may have swapped them.
Fitted: gmlpnp_reliability --searched (doc/reliability.md). */
constexpr double INITIAL_COST_RATIO = 2;

/** The ratio up to which a proof must exclude other minima. With more, most scenes would be left without a proof. */
constexpr double CERTIFIED_COST_RATIO = 1.1;

/** The distinct minima with most points in front of the camera, best first; empty where there is none. They need no
guess, and the rays may have any direction.
@param costRatio of the costs of a minimum and of the best, up to which it is returned.
@param certified ratio: where one minimum is proved to be the only one up to it, it is returned alone. With an infinite
ratio no proof is tried. */
CV_EXPORTS std::vector<PoseCandidate> initialPoses(const Correspondences& data, double costRatio = INITIAL_COST_RATIO,
                                                   double certified = CERTIFIED_COST_RATIO);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_ESTIMATOR_INITIAL_POSE_HPP
