// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_RAYS_RAY_PASS_HPP
#define OPENCV_GMLPNP_RAYS_RAY_PASS_HPP

#include "../kernels/dispatch.hpp"
#include "correspondences.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

/** Noise of the data: S_i = R Sigma R^T + s_i^2 Gamma. */
struct Noise
{
    Matrix3d Sigma = Matrix3d::Zero();  //!< object noise, object frame, length^2
    Matrix3d Gamma = Matrix3d::Zero();  //!< bearing noise, camera frame, rad^2
    Tails tails{};                      //!< of the share 0: Gaussian
};

/** The terms of one correspondence at a pose and a noise. The depth is eliminated (doc/theory.md, section 2). */
struct PointTerms
{
    Vector3d X;       //!< R p + t, camera frame
    double s;         //!< depth along the ray, m^T X
    double D;         //!< determinant of the tangent covariance, m^T adj(S) m
    double c;         //!< squared Mahalanobis residual, 2 degrees of freedom
    double w;         //!< weight by its tails; 1 for Gaussian noise
    Vector3d z;       //!< Q X
    Vector3d zTilde;  //!< gradient of c/2 with respect to X, the dependence of S on s included
    Vector3d Xhat;    //!< X - R Sigma R^T z: the point without its estimated object noise
    Matrix3d Q;       //!< information of the ray about X, rank 2, Q m = 0
};

/** The point at which a rotation acts in J = [ -[lever]_x , I ]. A rotation turns R Sigma R^T, too, so that the
gradient of c/2 is Xhat x z and not X x z. The difference has a mean that does not shrink with n where Sigma is
anisotropic. A lever arm that carries noise also makes H too large. Algorithm 1 as published takes the points as they
are. */
enum class LeverArm
{
    AS_GIVEN,
    CORRECTED
};

/** What a pass adds up beside the sums of a plain round. */
struct PassOptions
{
    LeverArm lever = LeverArm::CORRECTED;
    Products products = NO_PRODUCTS;  //!< RaySums::QQ
    double* c = nullptr;              //!< receives each point's squared Mahalanobis residual
    bool sampled = false;             //!< RaySums::QQ from a quarter of the points
};

/** Sums over the points that a round needs. */
struct RaySums
{
    Matrix6d H;       //!< sum w J^T Q J, Gauss-Newton matrix for xi = (phi, delta)
    Vector6d g;       //!< sum w J^T zTilde, gradient of the residual part of L with respect to xi, through S(R, s)
    Matrix3d Zo, Go;  //!< sum w z z^T, sum Q: for Sigma, camera frame
    Matrix3d Zb, Gb;  //!< sum w s^2 z z^T, sum s^2 Q: for Gamma
    Matrix6d QQ;      //!< sum q q^T (or by s^4), q = Q_xx Q_xy Q_xz Q_yy Q_yz Q_zz; if asked for
    double L;         //!< negative log-likelihood, nat: 1/2 sum log D + misfit
    double misfit;    //!< 1/2 sum c, or -sum log g(c)
    double c, c2;     //!< sum c, sum c^2
    int inFront;      //!< points with s >= 0
};

/** Sums of q q^T, s^4 q q^T and s^2 q q^T, as RaySums::QQ. */
struct RayProducts
{
    Matrix6d object, bearing, both;
};

/** Of one point with the squared residual c. */
struct TailTerms
{
    double g;  //!< density times 2 pi
    double w;  //!< -2 d log g / dc, the weight of the point; 1 for Gaussian noise
};
CV_EXPORTS TailTerms tailTerms(const Tails& tails, double c);

/** The terms of one point. This is the readable twin of the pass, and a test holds the two together.
@param S_o R Sigma R^T; it and Gamma include the known covariances of the point. */
CV_EXPORTS PointTerms pointTerms(const Vector3d& p, const Vector3d& m, const Pose& pose, const Matrix3d& S_o,
                                 const Matrix3d& Gamma, const Tails& tails = {});
CV_EXPORTS PointTerms pointTerms(const Correspondences& data, int i, const Pose& pose, const Noise& noise);

/** A pose as the kernels take it: R by rows, then t. */
std::array<double, 12> entriesOf(const Pose& pose);

/** A symmetric matrix from its upper triangle by rows, as the kernels return it. */
Matrix6d symmetric6(const double (&entries)[21]);

/** One pass over the points. It reads and adds, and takes nothing from the heap. */
CV_EXPORTS RaySums rayPass(const Correspondences& data, const Pose& pose, const Noise& noise,
                           const PassOptions& options, const RayKernels& kernels);
inline RaySums rayPass(const Correspondences& data, const Pose& pose, const Noise& noise,
                       const PassOptions& options = {})
{
    return rayPass(data, pose, noise, options, rayKernels(data.size()));
}

/** The products for both noises at once, of all points. */
CV_EXPORTS RayProducts rayProducts(const Correspondences& data, const Pose& pose, const Noise& noise,
                                   const RayKernels& kernels);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_RAYS_RAY_PASS_HPP
