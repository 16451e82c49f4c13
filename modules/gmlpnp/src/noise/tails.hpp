// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_NOISE_TAILS_HPP
#define OPENCV_GMLPNP_NOISE_TAILS_HPP

#include "../rays/ray_pass.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

/** Estimates the tails, a round at a time. The scale is known where not all of the noise is estimated. */
class CV_EXPORTS TailSearch
{
public:
    TailSearch(bool scaleKnown, int n) : scaleKnown_(scaleKnown), n_(n) { factors_.fill(1); }

    /** The share of points with wider noise becomes its posterior mean by the squared residuals `c` at `noise`, or 0
    where a Gaussian does. Where the scale is not known, Sigma and Gamma change by the factor that goes with the change
    of the share. `sums` are those of the pass that gave c. */
    void update(Noise& noise, const double* c, const RaySums& sums);

    /** Whether isotropic noise shows tails that no other shape of it could take away. */
    bool areWild(const RaySums& sums) const;

private:
    bool scaleKnown_;
    int n_;
    std::array<double, TRIED_TAILS> factors_;  // of the noise that suits each share that is tried, over the present one
};

/** Whether the step from one share to the other moves L by less than the tolerance [nat], or the weights hardly. */
bool sameTails(const Tails& a, const Tails& b, int n, double tolerance);

/** What a residual tells, as a share of what a Gaussian one does. */
struct TailInformation
{
    double pose;   //!< over the mean weight, as H is summed with weights
    double noise;  //!< about the shape of Sigma or Gamma
};
CV_EXPORTS TailInformation tailInformation(const Tails& tails);

/** Degrees of freedom of the Student-t that is nearest by the divergence of Kullback and Leibler; infinity: Gaussian.
 */
CV_EXPORTS double nearestStudentT(const Tails& tails);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_NOISE_TAILS_HPP
