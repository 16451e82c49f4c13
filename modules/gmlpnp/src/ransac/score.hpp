// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_RANSAC_SCORE_HPP
#define OPENCV_GMLPNP_RANSAC_SCORE_HPP

#include "../rays/ray_pass.hpp"
#include "metric.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

/** The truncated cost of a pose over all points (MSAC). */
struct Score
{
    double cost;  //!< sum min(|e|^2, 1)
    int inliers;  //!< points with |e| <= 1
};

/** The points in random order, as columns. Points and poses are normalised as in Correspondences. The residual e is
that of ransac/metric.hpp. */
class CV_EXPORTS ScoredPoints
{
public:
    ScoredPoints(const Correspondences& data, const std::vector<Metric>& metrics, RNG& rng, const RayKernels& kernels);
    ScoredPoints(const Correspondences& data, const std::vector<Metric>& metrics, RNG& rng)
        : ScoredPoints(data, metrics, rng, rayKernels(data.size()))
    {}

    int size() const { return static_cast<int>(columns_.rows()); }

    /** Returns the cost of a pose over all points. */
    Score score(const Pose& pose) const;

    /** Returns the cost over the first SCREENED points of the random order. It gives up early and returns an infinite
    cost as soon as the cost is too high: a pose with a cost of `best` over these points would have stayed below it with
    a probability of about 0.999. */
    Score scoreAgainst(const Pose& pose, double best) const;

    /** Says of each point whether it is an inlier, in the caller's order. */
    std::vector<bool> inliers(const Pose& pose) const;

    /** Takes one robust Gauss-Newton step over the first `count` points of the random order. The weight of a point
    falls to zero at |e| = `width` (Tukey).
    @return false, and the pose as it was, where the points do not determine a step. */
    bool step(Pose& pose, double width, int count) const;

    /** Statistics: with one inlier in ten points there are about fifty among so many. */
    static constexpr int SCREENED = 512;

private:
    ScoredArrays arrays() const;
    Score sumUntil(const Pose& pose, int count, double best) const;

    const RayKernels& kernels_;
    std::vector<int> order_;                             // the caller's row of each row
    Eigen::Matrix<double, Eigen::Dynamic, 12> columns_;  // point, ray, and both rows of the metric
};

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_RANSAC_SCORE_HPP
