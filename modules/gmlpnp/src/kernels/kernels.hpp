// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_KERNELS_KERNELS_HPP
#define OPENCV_GMLPNP_KERNELS_KERNELS_HPP

// The loops over the points, compiled once for each instruction set. This header includes no other, and neither do the
// files that include it for an instruction set of their own, but for <cmath> and <cstring>. The reason is the linker:
// of an inline function it keeps one copy for all callers, and that copy could be the one compiled for AVX2.

namespace cv {
namespace gmlpnp {
namespace detail {

/** The columns of the correspondences. The formulas hold for rays of any length; a ray is as long as its angular scale
(doc/theory.md, section 3). */
struct PointArrays
{
    const double* point[3];
    const double* ray[3];
    //! Entries xx xy xz yy yz zz of the known covariance of each object point and then of each ray; null: none.
    const double* known[12];
    int size;
};

/** Says which products of Q a pass sums: the curvature of L by the object noise or by the bearing noise. */
enum Products
{
    NO_PRODUCTS,
    OF_OBJECT,
    OF_BEARING
};

/** The distribution of the squared residuals c. The two coordinates of a residual have the density g(c) / (2 pi) with

    g(c) = (1 - share) e^(-c/2) + share / spread2 (1 + c / (dof spread2))^-(dof/2 + 1),

a Gaussian for most points and a Student-t for a share of them (doc/theory.md, section 1). A share of 0 makes it
Gaussian; a share of 1 with spread2 = 1 makes it a Student-t. */
struct Tails
{
    double share = 0;
    //! Scale matrix of the Student-t over the covariance of the Gaussian. fitted: scripts/figures.sh tails
    //! (doc/lab/noise.md); held by Gmlpnp_RobustStatistics.tailsCostNothingOnGaussianDataAndSaveTheRest
    double spread2 = 6.25;
    //! Degrees of freedom of the Student-t: the fewer they are, the less a wrong match can weigh.
    int dof = 2;
};

/** Range of doubles: this is added to g(c), which otherwise underflows to zero for a c of 1e150. */
constexpr double LEAST_DENSITY = 1e-290;

/** A pose and a noise. Symmetric matrices stand as xx xy xz yy yz zz. */
struct PassInput
{
    double pose[12];  //!< R by rows, t
    double S_o[6];    //!< R Sigma R^T
    double Gamma[6];  //!< if all are zero a shorter loop runs
    Tails tails;      //!< if their share is zero a shorter loop runs
    double lever;     //!< 1 takes R Sigma R^T z off the lever arm, 0 leaves it (published method)
    Products products;
    bool sampled;  //!< sums products over the first four of every sixteen points only
    double* c;     //!< receives each point's squared Mahalanobis residual; null: nobody needs them
};

/** A product mantissa * 2^exponent. It takes one logarithm for all factors instead of one each. */
struct ScaledProduct
{
    double mantissa = 1;
    long long exponent = 0;
};

/** The sums that RaySums is assembled from (doc/theory.md, section 2). H stands in blocks, phi-delta by rows. */
struct PassSums
{
    double Hpp[6]{}, Hpd[9]{}, Hdd[6]{}, Zo[6]{}, Go[6]{}, Zb[6]{}, Gb[6]{}, gp[3]{}, gd[3]{}, c{}, c2{};
    //! Sum of Q_a Q_b or of s^4 Q_a Q_b over `inProducts` points, with a <= b of xx xy xz yy yz zz.
    double QQ[21]{};
    int inProducts{};
    ScaledProduct D, tailed;      //!< products of D and of g(c)
    unsigned long long behind{};  //!< points with s < 0
};

/** Sums of Q_a Q_b, s^4 Q_a Q_b and s^2 Q_a Q_b: the curvature F of L by both noises at once (doc/theory.md,
section 6). */
struct InformationSums
{
    double object[21]{}, bearing[21]{}, both[21]{};
};

/** Sums over the points after they were centred, and over the rays. */
struct ColumnSums
{
    double scatter[6]{};        //!< sum p p^T
    double ray2{}, inverse2{};  //!< sums of |m|^2 and of 1 / |m|^2 before the rays are made unit
    double apart2{};            //!< sum |m_i - m_0|^2 over the unit rays
};

/** Moments of Q = I - m m^T: sum Q, sum p_a Q, and sum p_a p_b Q for ab = xx xy xz yy yz zz. The start builds its
quadratic form from them (doc/theory.md, section 4). */
struct MomentSums
{
    double Q[6]{}, pQ[3][6]{}, ppQ[6][6]{};
};

/** Sums for the line variance = a + b x through y, weighted by w = 1 / variance^2, and for its likelihood. */
struct LineSums
{
    double w{}, wx{}, wxx{}, wy{}, wxy{};
    double misfit{};         //!< sum y / variance
    ScaledProduct variance;  //!< product of the variances
};

/** How many tails one pass tries at once. */
constexpr int TRIED_TAILS = 4;

/** The sum of w c over the squared residuals c, and the product of g(c). */
struct TailSums
{
    double wc{};
    ScaledProduct g;
};

/** The points that RANSAC scores, in its own order: points, unit rays, and the two rows of each point's Metric. */
struct ScoredArrays
{
    const double* point[3];
    const double* ray[3];
    const double* metric[6];
    int size;
};

/** The cost sum min(|e|^2, 1) and the number of points with |e| < 1. */
struct TruncatedSums
{
    double cost{}, inliers{};
};

/** H = sum w J^T J and g = sum w J^T e of a robust step. H is its upper triangle by rows. */
struct StepSums
{
    double H[21]{}, g[6]{};
};

/** The loops of one instruction set. They take `lanes` points or more. */
struct RayKernels
{
    const char* name;
    int lanes;
    /** Subtracts `centre` from the points and makes the rays unit, in place. */
    void (*prepare)(double* const* point, double* const* ray, int size, const double* centre, ColumnSums& sums);
    void (*pass)(const PointArrays& data, const PassInput& input, PassSums& sums);
    /** Reads only the pose and the noise of the input. */
    void (*information)(const PointArrays& data, const PassInput& input, InformationSums& sums);
    void (*moments)(const PointArrays& data, MomentSums& sums);
    /** Returns the number of points with s < 0 at a pose, given as R by rows and then t. */
    int (*behind)(const PointArrays& data, const double* pose);
    /** Sums for each of TRIED_TAILS tails, over the squared residuals c of a noise `factors` times as large. */
    void (*tails)(const double* c, int size, const Tails* tails, const double* factors, TailSums* sums);
    /** Writes s^2 and 1/2 |m x X|^2 of each point at a pose. */
    void (*residuals)(const PointArrays& data, const double* pose, double* depth2, double* residual2);
    void (*line)(const double* x, const double* y, int size, double a, double b, LineSums& sums);
    /** Sums over the points from `first` to `last`, without the latter. */
    void (*truncated)(const ScoredArrays& data, const double* pose, int first, int last, TruncatedSums& sums);
    /** Writes 1 for each point that is an inlier, else 0. */
    void (*inliers)(const ScoredArrays& data, const double* pose, double* isInlier);
    /** Sums over the first `count` points with the weights of Tukey, which are zero from |e| = `width` on. */
    void (*robustStep)(const ScoredArrays& data, const double* pose, double width, int count, StepSums& sums);
};

extern const RayKernels RAY_KERNELS_SCALAR, RAY_KERNELS_VECTOR, RAY_KERNELS_AVX2, RAY_KERNELS_AVX512;

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_KERNELS_KERNELS_HPP
