// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_NOISE_KINDS_HPP
#define OPENCV_GMLPNP_NOISE_KINDS_HPP

#include "../rays/ray_pass.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

// Everything here is in the solver's units: the points are centred and scaled to a root mean square distance of 1.

/** A kind of noise says which covariances are estimated. */
enum class NoiseKind
{
    FIXED,      //!< none: both are known
    ISOTROPIC,  //!< none: a variance was found beforehand and has no shape
    PUBLISHED,  //!< Sigma, by Algorithm 1 of the paper
    OBJECT,     //!< Sigma, by the marginal likelihood
    BEARING,    //!< Gamma, by the marginal likelihood
    BOTH        //!< Sigma and Gamma, by the marginal likelihood
};

/** Whether Sigma and Gamma stay as they are while the pose is sought. */
inline bool isConstant(NoiseKind kind)
{
    return kind == NoiseKind::FIXED || kind == NoiseKind::ISOTROPIC;
}

/** Whether Sigma is estimated by the marginal likelihood. */
inline bool estimatesObject(NoiseKind kind)
{
    return kind == NoiseKind::OBJECT || kind == NoiseKind::BOTH;
}

/** Whether Gamma is estimated by the marginal likelihood. */
inline bool estimatesBearing(NoiseKind kind)
{
    return kind == NoiseKind::BEARING || kind == NoiseKind::BOTH;
}

/** A known noise; without a value it is estimated. */
using KnownNoise = std::optional<Matrix3d>;

/** The smallest standard deviation of a noise. Exact data must not divide by zero. */
constexpr double NOISE_FLOOR = 1e-12;

/** Sigma = a I [length^2] and Gamma = b I [rad^2], with their L [nat]. */
struct IsotropicNoise
{
    double a, b, cost;
};

/** Sigma = a I and Gamma = b I without tails. */
inline Noise isotropic(double a, double b)
{
    return {a * Matrix3d::Identity(), b * Matrix3d::Identity(), {}};
}

/** The factor of restricted maximum likelihood, 2n / (2n - 6). The pose takes six of the 2n residual coordinates, and
with them this share of their squares. */
inline double restriction(int n)
{
    return 2. * n / std::max(2 * n - 6, 1);
}

/** Isotropic noise of each kind, fitted to the residuals at an isotropic pose by  E |v|^2 / 2 = a + b s^2. */
struct IsotropicSplit
{
    IsotropicNoise object, bearing, both;
    double meanDepth2;      //!< mean of s^2 [length^2]
    double depth2Variance;  //!< variance of s^2 relative to the square of its mean
};
CV_EXPORTS IsotropicSplit splitResiduals(const Correspondences& data, const Pose& pose);

/** Penalty [nat] on a model with two noises instead of one. */
CV_EXPORTS double penaltyOf(NoiseKind kind);

/** Prior cost [nat] of a kind of noise. It matters only where depths are nearly equal. An object of little depth then
looks the same with either noise, but not at the same distance: noise in its points makes it larger than its picture
says, noise in the picture makes it smaller. No number of points tells. Such objects are mostly known well (a marker, a
model) and the pixels are not, so the prior is for bearing noise. */
CV_EXPORTS double priorCost(NoiseKind kind, const IsotropicSplit& split);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_NOISE_KINDS_HPP
