// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_NOISE_TAILS_HPP
#define OPENCV_GMLPNP_NOISE_TAILS_HPP

#include "../rays/ray_pass.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

/** Estimates the tails, a round at a time (doc/theory.md, section 3). */
class CV_EXPORTS TailSearch
{
public:
    /** @param scaleKnown whether part of the noise is known, so that its scale is not fitted with the tails.
    @param n points. */
    TailSearch(bool scaleKnown, int n) : scaleKnown_(scaleKnown), n_(n) { factors_.fill(1); }

    /** The share of points with wider noise becomes its posterior mean by the squared residuals `c` at `noise`, or 0
    where a Gaussian explains them. Where the scale is not known, Sigma and Gamma change by the factor that goes with
    the change of the share.
    @param sums of the pass that gave c. */
    void update(Noise& noise, const double* c, const RaySums& sums);

    /** Whether isotropic noise shows tails that no other shape of it could take away. */
    bool areWild(const RaySums& sums) const;

private:
    bool scaleKnown_;
    int n_;
    std::array<double, TRIED_TAILS> factors_;  // for each share that is tried: its best noise over the present one
};

/** Whether the step from one share to the other moves L by less than the tolerance [nat], or hardly moves the weights.
 */
bool sameTails(const Tails& a, const Tails& b, int n, double tolerance);

/** The Fisher information of a residual with tails, as a share of that of a Gaussian one. */
struct TailInformation
{
    double pose;   //!< about the pose, over the mean weight because H is summed with weights
    double noise;  //!< about the shape of Sigma or Gamma
};
CV_EXPORTS TailInformation tailInformation(const Tails& tails);

/** Degrees of freedom of the Student-t that is nearest by the divergence of Kullback and Leibler. Gaussian noise has
infinitely many. */
CV_EXPORTS double nearestStudentT(const Tails& tails);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_NOISE_TAILS_HPP
