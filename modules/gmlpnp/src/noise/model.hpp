// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_NOISE_MODEL_HPP
#define OPENCV_GMLPNP_NOISE_MODEL_HPP

#include "../rays/ray_pass.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

// All of this is in the solver's units: points centred and scaled to a root mean square distance of 1.

/** Smallest standard deviation a noise may have: exact data must not divide by zero. */
constexpr double NOISE_FLOOR = 1e-12;
/** Smallest eigenvalue of a covariance, relative to its largest. */
constexpr double TINY_FLOOR = 1e-12;
/** Weight of the isotropic prior in points: C <- (n C + kappa tr(C)/3 I) / (n + kappa). */
constexpr double SHRINKAGE = 2;

/** Algorithm 1's covariance, (1/n) sum e e^T with the residuals e = C z  (Eq. (7) of the paper). */
CV_EXPORTS Matrix3d publishedUpdate(const Matrix3d& C, const Matrix3d& Z, int n);

/** EM step of the marginal likelihood: C + C (Z - G) C / n. Always SPD, never raises L, slow. */
CV_EXPORTS Matrix3d emUpdate(const Matrix3d& C, const Matrix3d& Z, const Matrix3d& G, int n);

/** MM step: the C' with C' G C' = C Z C, which minimises a majorant of L. SPD, never raises L, fast. */
CV_EXPORTS Matrix3d mmUpdate(const Matrix3d& C, const Matrix3d& Z, const Matrix3d& G);

/** The MM step taken twice as far along the geodesic of SPD matrices, C' C^-1 C'. Where the data observe a direction
well MM goes half the way in one round, where they do not less; so twice the step never overshoots near the end. */
CV_EXPORTS Matrix3d acceleratedMm(const Matrix3d& C, const Matrix3d& Z, const Matrix3d& G);

/** C lifted by `relative` of its trace, and by NOISE_FLOOR^2. */
CV_EXPORTS Matrix3d regular(const Matrix3d& C, double relative);

/** C drawn towards its isotropic part with the weight of kappa points, then floored. */
CV_EXPORTS Matrix3d shrunk(const Matrix3d& C, double n, double kappa);

/** Object noise in a model of bearing noise alone, as a share of the variance at mean depth: a point at the very centre
of projection must not weigh infinitely. */
constexpr double BEARING_ONLY_SHARE = 1e-6;

/** The pose takes six of the 2n residual coordinates, and with them this share of their squares. */
inline double freedom(int n)
{
    return 2. * n / std::max(2 * n - 6, 1);
}

/** Sigma = a I [length^2], Gamma = b I [rad^2], and L with them [nat]. */
struct IsotropicNoise
{
    double a, b, cost;
};

/** Sigma = a I, Gamma = b I, no tails. */
inline Noise isotropic(double a, double b)
{
    return {a * Matrix3d::Identity(), b * Matrix3d::Identity(), {}};
}

/** Isotropic noises from the residuals at an isotropic pose: E 1/2 |v|^2 = a + b s^2. */
struct IsotropicSplit
{
    IsotropicNoise object, bearing, both;
    double meanDepth2;      //!< mean s^2 [length^2]
    double depth2Variance;  //!< variance of s^2, of the square of its mean
};
CV_EXPORTS IsotropicSplit splitResiduals(const Correspondences& data, const Pose& pose);

/** Which noises are estimated; ISOTROPIC: found beforehand, and without a shape. */
enum class NoiseKind
{
    FIXED,
    ISOTROPIC,
    PUBLISHED,
    OBJECT,
    BEARING,
    BOTH
};

/** Whether Sigma and Gamma stay as they are while the pose is sought. */
inline bool isConstant(NoiseKind kind)
{
    return kind == NoiseKind::FIXED || kind == NoiseKind::ISOTROPIC;
}

/** The noise of the next round by Fisher scoring; OBJECT or BEARING, `sums` with the products of that kind. */
CV_EXPORTS Noise scoredNoise(NoiseKind kind, const Noise& noise, const RaySums& sums, const Matrix3d& R);

/** tr(A E) of the six symmetric unit matrices E, xx xy xz yy yz zz, whose two entries are 1. */
Vector6d againstUnits(const Matrix3d& A);

/** sum 1/2 tr(Q E Q E') for all pairs of units, from RaySums::QQ: expected curvature of L. */
Matrix6d curvature(const Matrix6d& QQ);

/** Sigma and Gamma of the next round: the published update, or accelerated MM and shrinkage. */
CV_EXPORTS Noise updatedNoise(NoiseKind kind, const Noise& noise, const RaySums& sums, const Matrix3d& R, int n);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_NOISE_MODEL_HPP
