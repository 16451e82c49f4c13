// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_HPP
#define OPENCV_GMLPNP_HPP

#include "opencv2/gmlpnp/camera.hpp"
#include "opencv2/gmlpnp/compat.hpp"

/**
@defgroup gmlpnp Generalized Maximum Likelihood Perspective-n-Point

This module estimates the camera pose *and* the noise of the data from n object points and their pixels, for any lens
and without a prior @cite zhan2024gmlpnp. The model, in the camera frame, is

    X_i = R p_i + t,   X_i = s_i m_i + noise of covariance  S_i = R Sigma R^T + s_i^2 Gamma

with object points p_i, unit rays m_i, depths s_i > 0, object noise Sigma (3x3, object frame, length^2) and bearing
noise Gamma (3x3, camera frame, rad^2). With a lens Gamma is the noise on its optical axis; on another ray it is Gamma
times the square of CameraModel::angularScales(), which is cos^2 of the angle off the axis for a pinhole. R and t turn
object coordinates into camera coordinates, as everywhere in OpenCV.

Conventions: lengths are the caller's; angles are radians; pixels are OpenCV's. The functions return false where the
data give no pose (too few points, collinear points, NaN). Result::status then says why, and nothing else is written.
Misuse (shapes, types, sizes, unknown flags) throws cv::Exception with OpenCV's codes, and the message names the
argument. Equal input gives equal output, bit for bit, from any thread.

Qualify each call: an unqualified `solvePnP(...)` under using-directives is ambiguous with cv::solvePnP.
*/

namespace cv {
namespace gmlpnp {

//! @addtogroup gmlpnp
//! @{

/** @brief The estimators of this module; also flags of cv::gmlpnp::solvePnP. */
enum Method
{
    //! Algorithm 1 of the paper: it estimates the object noise only and profiles the depths out, Eq. (6).
    SOLVEPNP_GMLPNP = 100,
    //! The default: it integrates the depths out and estimates object and bearing noise.
    SOLVEPNP_GMLPNP_MARGINAL = 101
};

/** @brief The outcome of a call. Converged and max rounds are successes: the functions return true. */
enum Status
{
    STATUS_CONVERGED = 0,   //!< the last round changed the cost by less than the tolerance
    STATUS_MAX_ROUNDS,      //!< all rounds were used; the pose is good, the noise may still move
    STATUS_TOO_FEW_POINTS,  //!< there are fewer than 4 points with a ray, or 4 places (3 with a guess)
    STATUS_DEGENERATE,      //!< points or rays are collinear or coincide (to 1e-100), or no pose has points in front
    STATUS_NOT_FINITE,      //!< points, pixels, rays or the guess hold NaN, infinity or sizes beyond 1e100
    STATUS_NO_CONSENSUS     //!< RANSAC: no pose has more inliers than chance would give
};

/** @brief The kinds of noise a result may carry. */
enum NoiseModel
{
    NOISE_GIVEN = 0,  //!< the noise was known, and nothing was estimated
    NOISE_ISOTROPIC,  //!< one variance: there are fewer than six points, or the noise is as large as the object
    NOISE_OBJECT,     //!< the object points alone are noisy
    NOISE_BEARING,    //!< the bearings alone are noisy
    NOISE_BOTH        //!< object points and bearings are noisy
};

/** @brief Options of a solve. Every field has a sensible default. */
struct CV_EXPORTS_W_SIMPLE Params
{
    CV_WRAP Params();

    CV_PROP_RW int method;     //!< one of #Method (default #SOLVEPNP_GMLPNP_MARGINAL)
    CV_PROP_RW int maxRounds;  //!< most rounds of noise and pose; 0: the method's default (5 published, 20 marginal)
    //! A round of the marginal method is the last if it changes the cost L by less than this [nat] (default 0.1). 0
    //! runs all rounds. The published method has its own criterion, the relative change of its covariance.
    CV_PROP_RW double tolerance;
    //! Allows heavy tails where the residuals show them, and estimates the share of the points in them (default true).
    //! Points that are far noisier than most, and wrong matches that look right, then weigh little. Only the marginal
    //! method has tails.
    CV_PROP_RW bool robust;
    CV_PROP_RW bool useExtrinsicGuess;  //!< start at (rvec, tvec) instead of the global solver (default false)
    CV_PROP_RW Vec3d rvec;              //!< guess: rotation vector, rad, object to camera
    CV_PROP_RW Vec3d tvec;              //!< guess: translation, the caller's length
    //! Known object noise Sigma, 3x3 positive semidefinite, object frame, length^2 (GMLPnP* of the paper's Proposition
    //! 1). Its entries reach 1e60 at most, as those of all covariances here. If empty, it is estimated.
    CV_PROP_RW Mat objectNoise;
    //! Known bearing noise Gamma, 3x3 positive semidefinite, camera frame, rad^2; with a lens, the noise on its optical
    //! axis. For a pinhole diag(1, 1, 0) (p / f)^2 is a noise of p pixels. If empty, the marginal method estimates it
    //! and the published method takes it for zero.
    CV_PROP_RW Mat bearingNoise;
    //! Known covariance of each object point, which is added to Sigma: N rows of 9 (row-major 3x3), object frame,
    //! length^2. If empty, none is added.
    CV_PROP_RW Mat objectCovariances;
    //! Known covariance of each pixel, which the camera maps to the ray and which is added to Gamma: N rows of 1
    //! (variance) or 4 (row-major 2x2), px^2. If empty, none is added. It needs a camera, so solveRays() refuses it.
    CV_PROP_RW Mat pixelCovariances;
};

/** @brief A pose with its noise and its uncertainty. */
struct CV_EXPORTS_W_SIMPLE Result
{
    CV_WRAP Result();

    CV_PROP_RW int status;  //!< one of #Status
    CV_PROP_RW int rounds;  //!< passes over the points that moved pose and noise
    //! Negative log-likelihood at the returned values [nat]: L = 1/2 sum_i (log D_i + c_i). D_i is the determinant of
    //! the 2x2 tangent covariance of point i, c_i its squared Mahalanobis residual.
    CV_PROP_RW double cost;
    CV_PROP_RW Vec3d rvec;  //!< rotation vector, rad: X = R p + t
    CV_PROP_RW Vec3d tvec;  //!< translation, the caller's length
    //! 6x6 covariance of the left perturbation (phi, delta), rad and length: R_true = Exp(phi) R,
    //! t_true = Exp(phi) t + delta. It is empty where the data leave no residual to judge it by (three points). This
    //! covariance and cameraCenterCovariance are of first order about the camera. They do not suffice where the squared
    //! deviation of the rotation [rad^2] times |t| is not far below the deviation of t, as for small objects at 20 of
    //! their sizes and more: use poseCovarianceRt there.
    CV_PROP_RW Mat poseCovariance;
    CV_PROP_RW Mat poseCovarianceRt;        //!< 6x6 covariance of (rvec, tvec), rad and length; empty as above
    CV_PROP_RW Vec3d cameraCenter;          //!< -R^T t, object frame, length
    CV_PROP_RW Mat cameraCenterCovariance;  //!< 3x3, object frame, length^2; empty as above
    CV_PROP_RW Mat objectNoise;             //!< Sigma, 3x3, object frame, length^2: estimated, or as given
    CV_PROP_RW Mat bearingNoise;            //!< Gamma, 3x3, camera frame, rad^2 (on the axis): estimated, or as given
    //! Standard errors of the entries of objectNoise, 3x3, length^2. They are empty where it was given, and for the
    //! published method, whose covariance does not estimate the noise. They take both noises for unknown (unless one
    //! was given), whatever noiseModel says. An error far above the trace of the noise says that the data do not
    //! determine the entry: along the rays in a narrow view, and object noise against bearing noise where all depths
    //! are alike. The entry itself is then drawn towards isotropy and means nothing.
    CV_PROP_RW Mat objectNoiseStdErr;
    CV_PROP_RW Mat bearingNoiseStdErr;  //!< standard errors of the entries of bearingNoise, 3x3, rad^2; empty likewise
    //! Numerical rank of objectNoise. The published covariance collapses by one direction a round (Neyman-Scott). A
    //! rank below 3 means that objectNoise does not estimate the noise along its null space.
    CV_PROP_RW int objectNoiseRank;
    //! One of #NoiseModel: the likeliest explanation of the residuals, with which the pose was weighed. It does not say
    //! which noises were estimated: where the depths tell the two apart, objectNoise and bearingNoise both are, except
    //! for #NOISE_ISOTROPIC.
    CV_PROP_RW int noiseModel;
    //! Lead in likelihood of noiseModel over the next best explanation [nat]; infinity where there was no choice. Below
    //! about 3 the data cannot tell. The pose is then the mean over the explanations, weighted by their likelihoods,
    //! and poseCovariance holds their spread. For an object of little depth a prior for bearing noise enters the
    //! weights.
    CV_PROP_RW double noiseEvidence;
    //! Lead in likelihood of this pose over the best other minimum [nat]. It is infinity where there is no other, where
    //! none is up to 3 nat behind, and where none was looked for (a guess, RANSAC). Below about 3 the data cannot tell,
    //! as with a small flat object far away: see solveAll(). A negative value says that another pose of solveAll() is
    //! likelier. The covariances are those of this minimum alone.
    CV_PROP_RW double poseEvidence;
    //! Share of the points whose noise is wider; 0 means Gaussian noise. objectNoise and bearingNoise are the
    //! covariances of the other points. The noise of that share is a Student-t of 2 degrees of freedom whose scale
    //! matrices are 6.25 times these covariances.
    CV_PROP_RW double tailShare;
    //! Degrees of freedom of the one Student-t that is nearest to this mixture; infinity means Gaussian.
    CV_PROP_RW double tailDof;
    CV_PROP_RW Mat weights;     //!< Nx1, weight of each point, at most 1; pixels without a ray have 0
    CV_PROP_RW int usedPoints;  //!< number of points that had a ray
};

/** @brief Estimates pose and noise from object points and pixels of any camera.

The pose needs no guess, because a global solver on the rays starts it. Then Gauss-Newton on se(3) and the noise update
alternate, with one pass over the points per round (Algorithm 1 of @cite zhan2024gmlpnp, or its marginal form).

@param objectPoints N points, object frame: Nx3, Nx1 or 1xN with 3 channels, vector of points; float or double.
@param imagePoints N pixels: Nx2, Nx1 or 1xN with 2 channels, vector of points; float or double. Pixels without a ray
are left out; Result::usedPoints counts the rest.
@param camera the lens.
@param result pose, noise, uncertainty; on failure only Result::status is written.
@param params options.
@return true with a finite pose, or false and the reason in Result::status.
@throws cv::Exception StsAssert or StsBadArg for misuse; the message names the argument. */
CV_EXPORTS_W bool solve(InputArray objectPoints, InputArray imagePoints, const Ptr<CameraModel>& camera,
                        CV_OUT Result& result, const Params& params = Params());

/** @overload
@param objectPoints N points, object frame.
@param imagePoints N pixels.
@param cameraMatrix 3x3 camera matrix, any numeric depth.
@param distCoeffs 0, 4, 5, 8, 12 or 14 distortion coefficients, as in CameraModel::pinhole.
@param result pose, noise, uncertainty.
@param params options. */
CV_EXPORTS_W bool solve(InputArray objectPoints, InputArray imagePoints, InputArray cameraMatrix, InputArray distCoeffs,
                        CV_OUT Result& result, const Params& params = Params());

/** @brief Estimates pose and noise from object points and rays. The camera may be any, and rays may point in any
direction, also behind the image plane.
@param objectPoints N points, object frame.
@param rays N rays in the camera frame: Nx3, Nx1 or 1xN with 3 channels, or vector of rays; float or double. They need
not be unit.
@param result pose, noise, uncertainty; on failure only Result::status is written.
@param params options.
@return true with a finite pose, or false and the reason in Result::status. A ray of length zero is not finite.
@throws cv::Exception StsAssert or StsBadArg for misuse; the message names the argument. */
CV_EXPORTS_W bool solveRays(InputArray objectPoints, InputArray rays, CV_OUT Result& result,
                            const Params& params = Params());

/** @brief Solves many independent problems, one after the other on each core (cv::parallel_for_). The results are those
of solveRays(), bit for bit, whatever the number of threads.
@param objectPoints the points of each problem, object frame: a list of arrays as solveRays() takes them. An empty array
with empty rays, as of a picture in which nothing was seen, is a problem of too few points.
@param rays the rays of each problem, camera frame: as many arrays.
@param results one result for each problem, in their order. Where there is no pose, Result::status says why and nothing
else is set.
@param params options of all problems, without objectCovariances, which belong to one problem.
@return the number of problems that have a pose.
@throws cv::Exception StsAssert or StsBadArg for misuse; the message names the problem and the argument. */
CV_EXPORTS_W int solveBatch(InputArrayOfArrays objectPoints, InputArrayOfArrays rays,
                            CV_OUT std::vector<Result>& results, const Params& params = Params());

/** @brief Finds every distinct pose that fits, best first: both poses of a small flat object, for instance. Where costs
differ by a few nats, solve() may return another pose than the first of these. It chooses before the poses are refined,
by the noise that explains the residuals at each.
@param objectPoints N points, object frame.
@param imagePoints N pixels.
@param camera the lens.
@param results one result per local minimum of the cost with most points in front of the camera, ascending cost.
@param params options; with a guess only the minimum that it leads to is returned.
@return the number of results; 0 where the data give no pose, and `results` is then untouched.
@throws cv::Exception StsAssert or StsBadArg for misuse; the message names the argument. */
CV_EXPORTS_W int solveAll(InputArray objectPoints, InputArray imagePoints, const Ptr<CameraModel>& camera,
                          CV_OUT std::vector<Result>& results, const Params& params = Params());

/** @overload
@param objectPoints N points, object frame.
@param imagePoints N pixels.
@param cameraMatrix 3x3 camera matrix, any numeric depth.
@param distCoeffs 0, 4, 5, 8, 12 or 14 distortion coefficients, as in CameraModel::pinhole.
@param results one result per local minimum, ascending cost.
@param params options. */
CV_EXPORTS_W int solveAll(InputArray objectPoints, InputArray imagePoints, InputArray cameraMatrix,
                          InputArray distCoeffs, CV_OUT std::vector<Result>& results, const Params& params = Params());

/** @brief Options of RANSAC. Every field has a sensible default. */
struct CV_EXPORTS_W_SIMPLE RansacParams
{
    CV_WRAP RansacParams();

    //! Largest residual of an inlier: px, in solveRaysRansac() rad (below pi/2). 0 (default) means 8 px or 0.01 rad. At
    //! least three standard deviations of the noise are best. A tighter threshold cuts residuals off, which the
    //! covariance of the pose allows for. Below one and a half deviations the residuals no longer show it, and the
    //! covariance is too small (doc/ransac.md).
    CV_PROP_RW double threshold;
    //! The search stops when a sample of inliers alone was drawn with this probability (default 0.99).
    CV_PROP_RW double confidence;
    //! Most samples of three points (default 10000). The search needs few of them where many points are inliers.
    CV_PROP_RW int maxIterations;
    CV_PROP_RW int seed;  //!< seed of the sampler (default 0); equal seeds give equal samples on every platform
    //! Correspondences come best first, and samples start with the best (PROSAC; default false). After three quarters
    //! of maxIterations at the latest samples come from all, so that an order without a meaning costs only time.
    CV_PROP_RW bool ordered;
};

/** @brief Estimates pose and noise as solve() does, where up to nine of ten correspondences may be wrong.

Samples of three points give poses (P3P on rays, in any direction). Their truncated residuals score them (MSAC), and
each new best is refined (LO-RANSAC). The search ends at the asked confidence. The marginal or published method then
estimates pose and noise from the inliers, and the inliers of that pose are counted anew. Points in a plane are no
special case.

The residual of a point is its reprojection error, for any lens. Across a panorama's seam, and where the lens cannot
project the point, it is the angle to the ray times the scale of the lens at the pixel.

Correspondences may repeat. Repeats are inliers together, right or wrong. So the search takes correspondences of one
object point with nearly the same pixel (a quarter of the threshold) for one, and a consensus counts each object point
and each pixel once. Object points that differ at all are different ones. The solve takes all inliers and treats repeats
as independent: leave them out where the uncertainty matters.

@param objectPoints N >= 4 points, object frame, as in solve().
@param imagePoints N pixels; pixels without a ray are outliers.
@param camera the lens.
@param result pose, noise, uncertainty, from the inliers. Result::usedPoints counts them, and Result::weights is 0 for
the rest. On failure only Result::status is written.
@param inliers n x 1, CV_32S: rows of the points within the threshold at the pose that is returned, ascending; untouched
on failure.
@param ransac options of the search.
@param params options of the solve. A guess is tried first and need not be good. Known noise is the noise of the
inliers.
@return true with a finite pose, or false and the reason in Result::status. It is #STATUS_NO_CONSENSUS where no pose has
four inliers without repeats, or none has more than wrong correspondences give by chance.
@throws cv::Exception StsAssert or StsBadArg for misuse; the message names the argument. */
CV_EXPORTS_W bool solveRansac(InputArray objectPoints, InputArray imagePoints, const Ptr<CameraModel>& camera,
                              CV_OUT Result& result, OutputArray inliers, const RansacParams& ransac = RansacParams(),
                              const Params& params = Params());

/** @overload
@param objectPoints N >= 4 points, object frame.
@param imagePoints N pixels.
@param cameraMatrix 3x3 camera matrix, any numeric depth.
@param distCoeffs 0, 4, 5, 8, 12 or 14 distortion coefficients, as in CameraModel::pinhole.
@param result pose, noise, uncertainty.
@param inliers n x 1, CV_32S: rows of the inliers.
@param ransac options of the search.
@param params options of the solve. */
CV_EXPORTS_W bool solveRansac(InputArray objectPoints, InputArray imagePoints, InputArray cameraMatrix,
                              InputArray distCoeffs, CV_OUT Result& result, OutputArray inliers,
                              const RansacParams& ransac = RansacParams(), const Params& params = Params());

/** @brief Estimates pose and noise as solveRays() does, where correspondences may be wrong as in solveRansac(). The
residual of a point is its angle to its ray.
@param objectPoints N >= 4 points, object frame.
@param rays N rays in the camera frame, as in solveRays().
@param result pose, noise, uncertainty; on failure only Result::status is written.
@param inliers n x 1, CV_32S: rows of the inliers; untouched on failure.
@param ransac options of the search, with the threshold in rad.
@param params options of the solve.
@return true with a finite pose, or false and the reason in Result::status.
@throws cv::Exception StsAssert or StsBadArg for misuse; the message names the argument. */
CV_EXPORTS_W bool solveRaysRansac(InputArray objectPoints, InputArray rays, CV_OUT Result& result, OutputArray inliers,
                                  const RansacParams& ransac = RansacParams(), const Params& params = Params());

/** @brief Drop-in for cv::solvePnP: it has the same parameters in the same order.

#SOLVEPNP_GMLPNP and #SOLVEPNP_GMLPNP_MARGINAL take any four or more points, coplanar or not (three with a guess), in
every array layout, and use the guess. All flags of OpenCV are forwarded to cv::solvePnP.

@param objectPoints N points, object frame: Nx3, Nx1 or 1xN with 3 channels, vector of points; float or double.
@param imagePoints N pixels: Nx2, Nx1 or 1xN with 2 channels, vector of points; float or double.
@param cameraMatrix 3x3 camera matrix, any numeric depth.
@param distCoeffs 0, 4, 5, 8, 12 or 14 distortion coefficients; inverted to convergence.
@param rvec output rotation vector, 3x1: X = R p + t. CV_64F, or the depth of the array that was passed.
@param tvec output translation, 3x1, likewise.
@param useExtrinsicGuess start at the given rvec, tvec.
@param flags one of #Method, or any flag of cv::solvePnP.
@return true with a finite pose; false where the data give none, and rvec and tvec are then untouched.
@throws cv::Exception StsAssert (-215) for wrong shapes, types and counts, StsBadArg (-5) for an unknown flag. */
CV_EXPORTS_W bool solvePnP(InputArray objectPoints, InputArray imagePoints, InputArray cameraMatrix,
                           InputArray distCoeffs, OutputArray rvec, OutputArray tvec, bool useExtrinsicGuess = false,
                           int flags = SOLVEPNP_GMLPNP_MARGINAL);

/** @brief Drop-in for cv::solvePnPRansac: it has the same parameters in the same order.

With #SOLVEPNP_GMLPNP and #SOLVEPNP_GMLPNP_MARGINAL it calls solveRansac(). All flags of OpenCV, also those of USAC
(USAC_DEFAULT to USAC_MAGSAC), are forwarded to cv::solvePnPRansac.

@param objectPoints N >= 4 points, object frame, in any layout of solvePnP().
@param imagePoints N pixels.
@param cameraMatrix 3x3 camera matrix, any numeric depth.
@param distCoeffs 0, 4, 5, 8, 12 or 14 distortion coefficients; inverted to convergence.
@param rvec output rotation vector, 3x1: X = R p + t. CV_64F, or the depth of the array that was passed.
@param tvec output translation, 3x1, likewise.
@param useExtrinsicGuess try the given rvec, tvec first; they need not be good.
@param iterationsCount most samples. A sample has three points, and the search stops at the asked confidence, so the
default is larger than OpenCV's 100.
@param reprojectionError largest reprojection error of an inlier, px.
@param confidence the search stops when a sample of inliers alone was drawn with this probability.
@param inliers n x 1, CV_32S: rows of the inliers of the pose that is returned, ascending.
@param flags one of #Method, any flag of cv::solvePnP, or one of USAC.
@return true with a finite pose; false where there is no consensus, and rvec, tvec and inliers are then untouched.
@throws cv::Exception StsAssert (-215) for wrong shapes, types and counts, StsBadArg (-5) for an unknown flag and for
numbers out of their range. */
CV_EXPORTS_W bool solvePnPRansac(InputArray objectPoints, InputArray imagePoints, InputArray cameraMatrix,
                                 InputArray distCoeffs, OutputArray rvec, OutputArray tvec,
                                 bool useExtrinsicGuess = false, int iterationsCount = 10000,
                                 float reprojectionError = 8.0, double confidence = 0.99,
                                 OutputArray inliers = noArray(), int flags = SOLVEPNP_GMLPNP_MARGINAL);

/** @overload
@param objectPoints N >= 4 points, object frame.
@param imagePoints N pixels.
@param cameraMatrix 3x3 camera matrix; it is never written. Without one cv::solvePnPRansac finds a camera too, but this
function throws (StsAssert).
@param distCoeffs 0, 4, 5, 8, 12 or 14 distortion coefficients.
@param rvec output rotation vector, 3x1.
@param tvec output translation, 3x1.
@param inliers n x 1, CV_32S: rows of the inliers.
@param params threshold [px], confidence, maxIterations and randomGeneratorState (the seed) are used. The sampler
SAMPLING_PROSAC takes correspondences best first; every other sampler is uniform. The remaining fields (isParallel,
loIterations, loMethod, loSampleSize, neighborsSearch, score) steer OpenCV's own search and have no effect here. */
CV_EXPORTS_W bool solvePnPRansac(InputArray objectPoints, InputArray imagePoints, InputOutputArray cameraMatrix,
                                 InputArray distCoeffs, OutputArray rvec, OutputArray tvec, OutputArray inliers,
                                 const UsacParams& params = UsacParams());

/** @brief Drop-in for cv::solvePnPGeneric: it returns every distinct pose, best first as in solveAll().
@param objectPoints N points, object frame, in any layout of solvePnP().
@param imagePoints N pixels.
@param cameraMatrix 3x3 camera matrix, any numeric depth.
@param distCoeffs 0, 4, 5, 8, 12 or 14 distortion coefficients.
@param rvecs rotation vectors: vector of Mat (3x1, CV_64F), Vec3d, Vec3f, Point3d...
@param tvecs translations, likewise.
@param useExtrinsicGuess start at rvec, tvec; the result is then one pose.
@param flags one of #Method, or any flag of cv::solvePnPGeneric.
@param rvec guess, never written.
@param tvec guess, never written.
@param reprojectionError n x 1: root mean square over both coordinates of all points, px.
@return the number of poses; 0 where the data give none, and all outputs are then untouched.
@throws cv::Exception as solvePnP(). */
CV_EXPORTS_W int solvePnPGeneric(InputArray objectPoints, InputArray imagePoints, InputArray cameraMatrix,
                                 InputArray distCoeffs, OutputArrayOfArrays rvecs, OutputArrayOfArrays tvecs,
                                 bool useExtrinsicGuess = false, int flags = SOLVEPNP_GMLPNP_MARGINAL,
                                 InputArray rvec = noArray(), InputArray tvec = noArray(),
                                 OutputArray reprojectionError = noArray());

/** @brief Refines a given pose by the marginal method and never makes it worse: at the noise that was found, the cost L
of the returned pose is at most the cost of the given pose.
@param objectPoints N >= 3 points, object frame.
@param imagePoints N pixels.
@param cameraMatrix 3x3 camera matrix, any numeric depth.
@param distCoeffs 0, 4, 5, 8, 12 or 14 distortion coefficients.
@param rvec rotation vector of any shape, in and out (3x1); untouched where the data give no pose.
@param tvec translation, likewise.
@param criteria the count bounds the rounds of pose and noise. A Gauss-Newton descent of the isotropic cost from the
given pose precedes them. The rounds end by the change of the cost, so epsilon is not used.
@throws cv::Exception as solvePnP(). */
CV_EXPORTS_W void solvePnPRefine(InputArray objectPoints, InputArray imagePoints, InputArray cameraMatrix,
                                 InputArray distCoeffs, InputOutputArray rvec, InputOutputArray tvec,
                                 TermCriteria criteria = TermCriteria(TermCriteria::EPS + TermCriteria::COUNT, 20,
                                                                      FLT_EPSILON));

/** @brief Forwards to cv::solvePnPRefineLM.
@param objectPoints, imagePoints, cameraMatrix, distCoeffs, rvec, tvec, criteria as in cv::solvePnPRefineLM. */
CV_EXPORTS_W void solvePnPRefineLM(InputArray objectPoints, InputArray imagePoints, InputArray cameraMatrix,
                                   InputArray distCoeffs, InputOutputArray rvec, InputOutputArray tvec,
                                   TermCriteria criteria = TermCriteria(TermCriteria::EPS + TermCriteria::COUNT, 20,
                                                                        FLT_EPSILON));

/** @brief Forwards to cv::solvePnPRefineVVS.
@param objectPoints, imagePoints, cameraMatrix, distCoeffs, rvec, tvec, criteria, VVSlambda as in
cv::solvePnPRefineVVS. */
CV_EXPORTS_W void solvePnPRefineVVS(InputArray objectPoints, InputArray imagePoints, InputArray cameraMatrix,
                                    InputArray distCoeffs, InputOutputArray rvec, InputOutputArray tvec,
                                    TermCriteria criteria = TermCriteria(TermCriteria::EPS + TermCriteria::COUNT, 20,
                                                                         FLT_EPSILON),
                                    double VVSlambda = 1);

/** @brief Functions for the lens of cv::fisheye: Kannala-Brandt, as in CameraModel::fisheye, on the whole sphere. */
namespace fisheye {

/** @brief Drop-in for cv::fisheye::solvePnP (OpenCV 4.10 and newer): it has the same parameters in the same order.

The flags of this module work on rays, also at 90 degrees and beyond, where the image plane has no pixel. The flags of
OpenCV get the pixels undistorted to the image plane of cameraMatrix, and so need all rays in front of the camera.

@param objectPoints N points, object frame: Nx3, Nx1 or 1xN with 3 channels, vector of points; float or double.
@param imagePoints N pixels: Nx2, Nx1 or 1xN with 2 channels, vector of points; float or double. The flags of this
module leave out pixels that have no ray.
@param cameraMatrix 3x3 camera matrix, any numeric depth.
@param distCoeffs k1, k2, k3, k4, or none.
@param rvec output rotation vector, 3x1: X = R p + t. CV_64F, or the depth of the array that was passed.
@param tvec output translation, 3x1, likewise.
@param useExtrinsicGuess start at the given rvec, tvec.
@param flags one of #Method, or any flag of cv::solvePnP.
@param criteria not used: the lens is inverted to convergence.
@return true with a finite pose; false where the data give none, and rvec and tvec are then untouched.
@throws cv::Exception StsAssert (-215) for wrong shapes, types and counts, StsBadArg (-5) for an unknown flag, and for
a flag of OpenCV with a pixel that has no ray in front of the camera. */
CV_EXPORTS_W bool solvePnP(InputArray objectPoints, InputArray imagePoints, InputArray cameraMatrix,
                           InputArray distCoeffs, OutputArray rvec, OutputArray tvec, bool useExtrinsicGuess = false,
                           int flags = cv::gmlpnp::SOLVEPNP_GMLPNP_MARGINAL,
                           TermCriteria criteria = TermCriteria(TermCriteria::MAX_ITER + TermCriteria::EPS, 10, 1e-8));

/** @brief Drop-in for cv::fisheye::solvePnPRansac (OpenCV 4.12 and newer): it has the same parameters in the same
order.

The flags of this module call solveRansac() with this lens, also at 90 degrees and beyond. The flags of OpenCV get the
pixels undistorted to the image plane of cameraMatrix, where they then measure reprojectionError.

@param objectPoints N >= 4 points, object frame.
@param imagePoints N pixels; for the flags of this module pixels without a ray are outliers.
@param cameraMatrix 3x3 camera matrix, any numeric depth.
@param distCoeffs k1, k2, k3, k4, or none.
@param rvec output rotation vector, 3x1: X = R p + t. CV_64F, or the depth of the array that was passed.
@param tvec output translation, 3x1, likewise.
@param useExtrinsicGuess try the given rvec, tvec first.
@param iterationsCount most samples of three points.
@param reprojectionError largest reprojection error of an inlier, px of the picture.
@param confidence the search stops when a sample of inliers alone was drawn with this probability.
@param inliers n x 1, CV_32S: rows of the inliers of the pose that is returned, ascending.
@param flags one of #Method, any flag of cv::solvePnP, or one of USAC.
@param criteria not used: the lens is inverted to convergence.
@return true with a finite pose; false where there is no consensus, and rvec, tvec and inliers are then untouched.
@throws cv::Exception as cv::gmlpnp::solvePnPRansac() and fisheye::solvePnP(). */
CV_EXPORTS_W bool solvePnPRansac(
    InputArray objectPoints, InputArray imagePoints, InputArray cameraMatrix, InputArray distCoeffs, OutputArray rvec,
    OutputArray tvec, bool useExtrinsicGuess = false, int iterationsCount = 10000, float reprojectionError = 8.0,
    double confidence = 0.99, OutputArray inliers = noArray(), int flags = cv::gmlpnp::SOLVEPNP_GMLPNP_MARGINAL,
    TermCriteria criteria = TermCriteria(TermCriteria::MAX_ITER + TermCriteria::EPS, 10, 1e-8));

}  // namespace fisheye

//! @}

}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_HPP
