// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_ESTIMATOR_AVERAGING_HPP
#define OPENCV_GMLPNP_ESTIMATOR_AVERAGING_HPP

#include "alternation.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

/** The kinds of noise that compete: object, bearing, both. */
constexpr int KINDS = 3;

/** The fit with one kind of noise. */
struct KindFit
{
    Estimate estimate;
    double penalty = 0;  //!< nat
    double prior = 0;    //!< nat; it decides where the data cannot tell

    double L() const { return estimate.sums.L + penalty; }
    double posterior() const { return L() + prior; }
};

/** A few fits without the heap. */
class KindFits
{
public:
    KindFit& add(const KindFit& fit) { return fits_[count_++] = fit; }
    int size() const { return count_; }
    const KindFit& operator[](int k) const { return fits_[k]; }
    const KindFit* begin() const { return fits_.data(); }
    const KindFit* end() const { return fits_.data() + count_; }

private:
    std::array<KindFit, KINDS> fits_;
    int count_ = 0;
};

/** The fits that are neither by likelihood nor by posterior negligible beside the best. */
KindFits withoutNegligible(const KindFits& fits);

/** By how much isotropic noise may speak for another kind [nat] before the fit of a kind is negligible. */
double negligibleMargin();

/** The posterior mean of the pose over the kinds of noise, with the noise of the likeliest. Where the data cannot tell
bearing noise from object noise (one depth), the two pull the pose to either side of the truth along the viewing
direction. The spread about that mean is by the likelihoods alone, because the prior's decision is no knowledge.
@param sums how accurate the sums must be. */
Estimate averaged(const Correspondences& data, const KindFits& fits, SumsNeeded sums);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_ESTIMATOR_AVERAGING_HPP
