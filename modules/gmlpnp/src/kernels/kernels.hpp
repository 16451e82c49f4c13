// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_KERNELS_KERNELS_HPP
#define OPENCV_GMLPNP_KERNELS_KERNELS_HPP

// The loops over the points, compiled once for each instruction set. This header and what includes it for an
// instruction set of its own stay free of other headers: an inline function of theirs, compiled for AVX2, could be the
// copy that the linker keeps for all.

namespace cv {
namespace gmlpnp {
namespace detail {

/** Columns of the correspondences: object points, unit rays and, or null, the twelve entries of what is known of each
point (xx xy xz yy yz zz
of the object covariance and of the ray covariance). */
struct PointArrays
{
    const double* point[3];
    const double* ray[3];
    const double* known[12];
    int size;
};

/** Sums of products of Q: the curvature of L by an object noise or by a bearing noise. */
enum Products
{
    NO_PRODUCTS,
    OF_OBJECT,
    OF_BEARING
};

/** How the squared residuals c are distributed: density g(c) / (2 pi) over the two coordinates of a residual,

    g(c) = (1 - share) e^(-c/2) + share / spread2 (1 + c / (dof spread2))^-(dof/2 + 1),

a Gaussian for most points and a Student-t for a share of them. Share 0: Gaussian; share 1 and spread2 1: Student-t. */
struct Tails
{
    double share = 0;
    double spread2 = 6.25;  //!< the scale matrix of the Student-t over the covariance of the Gaussian
    int dof = 2;            //!< of the Student-t
};

/** Added to g(c), which otherwise underflows to nothing for a c of 1e150. */
constexpr double LEAST_DENSITY = 1e-290;

/** A pose and a noise; symmetric matrices as xx xy xz yy yz zz. */
struct PassInput
{
    double pose[12];  //!< R by rows, t
    double S_o[6];    //!< R Sigma R^T
    double Gamma[6];  //!< all zero: a shorter loop
    Tails tails;      //!< of share 0: a shorter loop
    double lever;     //!< share of R Sigma R^T z that is taken off the lever arm, 0 or 1
    Products products;
    bool sampled;  //!< products of the first four of every sixteen points only
    double* c;     //!< receives each point's squared Mahalanobis residual; null: not wanted
};

/** mantissa * 2^exponent: a product whose logarithm is wanted, without one logarithm a factor. */
struct ScaledProduct
{
    double mantissa = 1;
    long long exponent = 0;
};

/** What RaySums is assembled from. H in blocks, phi-delta by rows. */
struct PassSums
{
    double Hpp[6]{}, Hpd[9]{}, Hdd[6]{}, Zo[6]{}, Go[6]{}, Zb[6]{}, Gb[6]{}, gp[3]{}, gd[3]{}, c{}, c2{};
    //! Of `inProducts` points: sum of Q_a Q_b or of s^4 Q_a Q_b, a <= b of xx xy xz yy yz zz.
    double QQ[21]{};
    int inProducts{};
    ScaledProduct D, tailed;      //!< product of D, of g(c)
    unsigned long long behind{};  //!< points with s < 0
};

/** Sums of Q_a Q_b, s^4 Q_a Q_b and s^2 Q_a Q_b: the curvature of L by both noises at once. */
struct InformationSums
{
    double object[21]{}, bearing[21]{}, both[21]{};
};

/** What is seen of the points once centred, and of the rays. */
struct ColumnSums
{
    double scatter[6]{};        //!< sum p p^T
    double ray2{}, inverse2{};  //!< sum |m|^2 and 1 / |m|^2 before they are made unit
    double apart2{};            //!< sum |m_i - m_0|^2 of the unit rays
};

/** Moments of Q = I - m m^T: sum Q, sum p_a Q, and sum p_a p_b Q for ab = xx xy xz yy yz zz. */
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

/** Tails that are tried at once. */
constexpr int TRIED_TAILS = 4;

/** Sum of w c over squared residuals c, and the product of g(c). */
struct TailSums
{
    double wc{};
    ScaledProduct g;
};

/** What RANSAC scores, in its own order: points, unit rays, and the two rows of each point's Metric. */
struct ScoredArrays
{
    const double* point[3];
    const double* ray[3];
    const double* metric[6];
    int size;
};

/** sum min(|e|^2, 1) and the number of points where it is less than 1. */
struct TruncatedSums
{
    double cost{}, inliers{};
};

/** H = sum w J^T J and g = sum w J^T e of a robust step; of H the upper triangle by rows. */
struct StepSums
{
    double H[21]{}, g[6]{};
};

/** One instruction set; its loops take `lanes` points or more. */
struct RayKernels
{
    const char* name;
    int lanes;
    /** Takes `centre` off the points and makes the rays unit, in place. */
    void (*prepare)(double* const* point, double* const* ray, int size, const double* centre, ColumnSums& sums);
    void (*pass)(const PointArrays& data, const PassInput& input, PassSums& sums);
    /** Of the input, the pose and the noise. */
    void (*information)(const PointArrays& data, const PassInput& input, InformationSums& sums);
    void (*moments)(const PointArrays& data, MomentSums& sums);
    /** Points with s < 0 at a pose, R by rows and then t. */
    int (*behind)(const PointArrays& data, const double* pose);
    /** For each of TRIED_TAILS tails over the squared residuals c of a noise that is `factors` times as large. */
    void (*tails)(const double* c, int size, const Tails* tails, const double* factors, TailSums* sums);
    /** s^2 and 1/2 |m x X|^2 of each point at a pose. */
    void (*residuals)(const PointArrays& data, const double* pose, double* depth2, double* residual2);
    void (*line)(const double* x, const double* y, int size, double a, double b, LineSums& sums);
    /** Over the points from `first` to `last`. */
    void (*truncated)(const ScoredArrays& data, const double* pose, int first, int last, TruncatedSums& sums);
    /** Whether each point is an inlier. */
    void (*inliers)(const ScoredArrays& data, const double* pose, double* isInlier);
    /** Over the first `count` points, with the weights of Tukey: zero from |e| = `width` on. */
    void (*robustStep)(const ScoredArrays& data, const double* pose, double width, int count, StepSums& sums);
};

extern const RayKernels RAY_KERNELS_SCALAR, RAY_KERNELS_VECTOR, RAY_KERNELS_AVX2, RAY_KERNELS_AVX512;

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_KERNELS_KERNELS_HPP
