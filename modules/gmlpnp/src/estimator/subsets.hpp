// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_ESTIMATOR_SUBSETS_HPP
#define OPENCV_GMLPNP_ESTIMATOR_SUBSETS_HPP

#include "averaging.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

/** A growing sequence of subsets of the points (Correspondences::part) that ends with all of them. Where only the pose
is asked for, the first finds the kind of noise and goes most of the way. A few passes over each larger one end it: the
error that a subset leaves in the noise is squared by each. */
class Subsets
{
public:
    /** All points and no smaller subset; `all` must live as long. */
    explicit Subsets(const Correspondences& all) : all_(all) {}
    /** The subsets by which the poses of many points are found; none where there are not many.
    @param everySize whether sizes between the first subset and all points are wanted. */
    CV_EXPORTS static Subsets growing(const Correspondences& all, bool everySize);

    int count() const { return static_cast<int>(parts_.size()) + 1; }
    const Correspondences& operator[](int k) const { return k + 1 < count() ? parts_[k] : all_; }
    const Correspondences& first() const { return (*this)[0]; }

private:
    const Correspondences& all_;
    std::vector<Correspondences> parts_;
};

/** The estimate over more points from the one that a subset gave, in two or three passes. Where these do not settle it,
or the pose moves further than chance explains, the alternation goes on. The rounds of both stay within the limits.
@param size points of the subset. */
Estimate extended(const Correspondences& data, const Estimate& fromSubset, int size, const FitOptions& options);

/** The same for each of the kinds of noise that the subset has not ruled out. */
KindFits extended(const Correspondences& data, const KindFits& fromSubset, int size, const FitOptions& options);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_ESTIMATOR_SUBSETS_HPP
