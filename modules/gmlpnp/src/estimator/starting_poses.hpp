// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_ESTIMATOR_STARTING_POSES_HPP
#define OPENCV_GMLPNP_ESTIMATOR_STARTING_POSES_HPP

#include "initial_pose.hpp"
#include "options.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

// Which minimum: the first of the three questions of solve.cpp.

/** A minimum of the isotropic cost. */
struct Start
{
    Pose pose;
    double evidence;  //!< by how much it is likelier than the best other minimum [nat]
};

struct StartingPoses
{
    std::vector<Start> poses;  //!< best first
    bool chosen;               //!< whether the first alone is wanted, unless no pose comes of it
};

/** The minima from which poses are sought, or the one that the guess leads to. */
CV_EXPORTS StartingPoses startingPoses(const Correspondences& data, const Options& options);

/** The minimum of the isotropic cost near a pose. */
StartingPoses startNear(const Correspondences& data, const Pose& pose);

/** By how much one of several is likelier than the best other [nat].
@param costOf the negative log-likelihood of an element [nat]. */
template <class Elements, class Cost>
double evidenceOf(size_t which, const Elements& elements, const Cost& costOf)
{
    double least = std::numeric_limits<double>::infinity();
    for (size_t k = 0; k < elements.size(); ++k)
        if (k != which)
            least = std::min(least, costOf(elements[k]) - costOf(elements[which]));
    return least;
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_ESTIMATOR_STARTING_POSES_HPP
