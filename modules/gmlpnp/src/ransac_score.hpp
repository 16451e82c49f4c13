// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_RANSAC_SCORE_HPP
#define OPENCV_GMLPNP_RANSAC_SCORE_HPP

#include "ransac.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

/** Truncated cost of a pose over all points. */
struct Score
{
    double cost;  //!< sum min(|e|^2, 1)
    int inliers;  //!< points with |e| <= 1
};

/** The points in random order, in blocks of lanes, normalised as in Correspondences; poses too. */
class CV_EXPORTS ScoredPoints
{
public:
    ScoredPoints(const Correspondences& data, const std::vector<Metric>& metrics, RNG& rng);

    int size() const { return n_; }

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
    static constexpr int LANES = 8;  // doubles at a time; sums do not depend on the size of registers
    using Lane = Eigen::Array<double, LANES, 1>;
    struct Block
    {
        Lane p[3], m[3], B[2][3];
    };

    // X = R p + t, s = m . X, and e over s, zero where s is not positive.
    struct Residuals
    {
        Lane X[3], s, e[2];
    };

    static Residuals residuals(const Block& block, const Pose& pose);
    static Lane costs(const Block& block, const Pose& pose);
    Score sumUntil(const Pose& pose, size_t blocks, double best) const;

    int n_;
    std::vector<int> order_;  // of the lanes: rows of the caller
    std::vector<Block, Eigen::aligned_allocator<Block>> blocks_;
};

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_RANSAC_SCORE_HPP
