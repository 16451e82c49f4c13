// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_NOISE_MODEL_HPP
#define OPENCV_GMLPNP_NOISE_MODEL_HPP

#include "kinds.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

/** The smallest eigenvalue of a covariance relative to its largest. */
constexpr double TINY_FLOOR = 1e-12;
/** Weight of the isotropic prior in points: C <- (n C + kappa tr(C)/3 I) / (n + kappa).
Fitted: doc/lab/noise.md, "shrinkage". */
constexpr double SHRINKAGE = 2;

/** The covariance of Algorithm 1, (1/n) sum e e^T with the residuals e = C z  (Eq. (7) of the paper). */
CV_EXPORTS Matrix3d publishedUpdate(const Matrix3d& C, const Matrix3d& Z, int n);

/** The EM step of the marginal likelihood, C + C (Z - G) C / n. It is always SPD, never raises L, and is slow. */
CV_EXPORTS Matrix3d emUpdate(const Matrix3d& C, const Matrix3d& Z, const Matrix3d& G, int n);

/** The MM step: the C' with  C' G C' = C Z C  minimises a majorant of L. It is SPD, never raises L, and is fast. */
CV_EXPORTS Matrix3d mmUpdate(const Matrix3d& C, const Matrix3d& Z, const Matrix3d& G);

/** The MM step taken twice as far along the geodesic of SPD matrices, C' C^-1 C'. In a direction that the data observe
well MM goes half the way in one round. Elsewhere it moves less. So twice the step never overshoots near the end. */
CV_EXPORTS Matrix3d acceleratedMm(const Matrix3d& C, const Matrix3d& Z, const Matrix3d& G);

/** C lifted by `relative` of its trace and by NOISE_FLOOR^2. */
CV_EXPORTS Matrix3d regular(const Matrix3d& C, double relative);

/** C drawn towards its isotropic part with the weight of kappa points, and then lifted by the floor. */
CV_EXPORTS Matrix3d shrunk(const Matrix3d& C, double n, double kappa);

/** Sigma and Gamma of the next round, by the published update or by accelerated MM and shrinkage. */
CV_EXPORTS Noise updatedNoise(NoiseKind kind, const Noise& noise, const RaySums& sums, const Matrix3d& R, int n);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_NOISE_MODEL_HPP
