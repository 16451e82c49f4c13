// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_NOISE_FIT_HPP
#define OPENCV_GMLPNP_NOISE_FIT_HPP

#include "kinds.hpp"
#include "tails.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

/** Where the fit of a noise starts. */
struct NoiseStart
{
    Noise noise;
    NoiseKind kind;
    //! Whether the noise that the kind does not estimate is known. Otherwise it is absent.
    bool otherKnown = false;
};

/** How the noise of the next round is found. */
enum class NoiseStep
{
    MM,               //!< by minorise-maximise steps (or the published update): finds its way from an isotropic start
    SCORING,          //!< by Fisher scoring, with the products of the last pass
    SCORING_SAMPLED,  //!< likewise, with the products of a quarter of the points: they depend a little on the order
    SCORING_FROZEN    //!< likewise, with the products of the first pass: enough near the end
};

/** Sigma, Gamma and tails of one fit, updated round by round from the sums of passes over the points. */
class CV_EXPORTS NoiseFit
{
public:
    /** @param data the correspondences.
    @param start noise and kind of the first round.
    @param tails whether the tails are estimated, too. */
    NoiseFit(const Correspondences& data, const NoiseStart& start, bool tails);

    /** Where a pass writes the squared residuals; null where nobody reads them. */
    double* residuals() { return c_.empty() ? nullptr : c_.data(); }

    /** Gives isotropic noise tails where its residuals show some that no other shape could take away.
    @return whether it did; the sums are then out of date. */
    bool addWildTails(Noise& noise, const RaySums& sums);

    /** The noise of the next round.
    @param now the noise at which `sums` and residuals() were taken.
    @param sums of the pass at `now`; for scoring with its products.
    @param R rotation of the pass.
    @param step MM or any kind of scoring. */
    Noise next(const Noise& now, const RaySums& sums, const Matrix3d& R, NoiseStep step);

private:
    NoiseKind kind_;
    int n_;
    bool tailsFitted_;
    bool shaped_;  // whether the noise has taken the shape of the residuals: anisotropy looks like tails before
    std::vector<double> c_;
    TailSearch tails_;
};

/** The L [nat] that noise of a kind reaches at a pose that is held, within a few tenths.
@param tails whether the tails are estimated, too. */
CV_EXPORTS double costWithNoiseFitted(const Correspondences& data, const Pose& pose, const NoiseStart& start,
                                      bool tails);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_NOISE_FIT_HPP
