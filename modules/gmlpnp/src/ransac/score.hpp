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

/** Truncated cost of a pose over all points. */
struct Score
{
    double cost;  //!< sum min(|e|^2, 1)
    int inliers;  //!< points with |e| <= 1
};

/** The points in random order as columns, normalised as in Correspondences; poses too. */
class CV_EXPORTS ScoredPoints
{
public:
    ScoredPoints(const Correspondences& data, const std::vector<Metric>& metrics, RNG& rng, const RayKernels& kernels);
    ScoredPoints(const Correspondences& data, const std::vector<Metric>& metrics, RNG& rng)
        : ScoredPoints(data, metrics, rng, rayKernels(data.size()))
    {}

    int size() const { return static_cast<int>(columns_.rows()); }

    Score score(const Pose& pose) const;

    /** The same over the first SCREENED points of the random order, given up (cost infinity) as soon as a pose as good
    as one of cost `best` over these would not have come to this with a probability of about 0.999. */
    Score scoreAgainst(const Pose& pose, double best) const;

    /** Whether each point is an inlier, in the caller's order. */
    std::vector<bool> inliers(const Pose& pose) const;

    /** Robust Gauss-Newton: the weight of a point falls to zero at |e| = `width` (Tukey). One step over the first
    `count` points of the random order; false where they do not determine one. */
    bool step(Pose& pose, double width, int count) const;

    static constexpr int SCREENED = 512;  // of one inlier in ten there are fifty among them

private:
    ScoredArrays arrays() const;
    Score sumUntil(const Pose& pose, int count, double best) const;

    const RayKernels& kernels_;
    std::vector<int> order_;                             // of the rows: those of the caller
    Eigen::Matrix<double, Eigen::Dynamic, 12> columns_;  // point, ray, both rows of the metric
};

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_RANSAC_SCORE_HPP
