// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_HPP
#define OPENCV_GMLPNP_HPP

#include "opencv2/gmlpnp/camera.hpp"
#include "opencv2/gmlpnp/compat.hpp"

/**
@defgroup gmlpnp Generalized Maximum Likelihood Perspective-n-Point

The camera pose *and* the noise of the data from n object points and their pixels, for any lens, without a prior
@cite zhan2024gmlpnp. The model, in the camera frame:

    X_i = R p_i + t,   X_i = s_i m_i + noise of covariance  S_i = R Sigma R^T + s_i^2 Gamma

with object points p_i, unit rays m_i, depths s_i > 0, object noise Sigma (3x3, object frame, length^2) and bearing
noise Gamma (3x3, camera frame, rad^2). With a lens Gamma is that of its optical axis and differs from ray to ray by
the squares of CameraModel::angularScales(): by cos^2 of the angle off the axis for a pinhole. R, t turn object
coordinates into camera coordinates, as everywhere in OpenCV.

Conventions: lengths are the caller's; angles are radians; pixels are OpenCV's. Where the data do not give a pose
(too few points, collinear points, NaN) the functions return false and Result::status says why; nothing else is
written. Misuse (shapes, types, sizes, unknown flags) throws cv::Exception with OpenCV's codes and names the argument.
Equal input gives equal output, bit for bit, from any thread.

Qualify each call: an unqualified `solvePnP(...)` under using-directives is ambiguous with cv::solvePnP.
*/

namespace cv {
namespace gmlpnp {

//! @addtogroup gmlpnp
//! @{

/** @brief The estimators of this module; also flags of cv::gmlpnp::solvePnP. */
enum Method
{
    SOLVEPNP_GMLPNP = 100,          //!< Algorithm 1 of the paper: object noise only, depths profiled out
    SOLVEPNP_GMLPNP_MARGINAL = 101  //!< depths integrated out, object and bearing noise (default)
};

/** @brief What became of a call. Converged and max rounds are successes: the functions return true. */
enum Status
{
    STATUS_CONVERGED = 0,   //!< the last round changed the cost by less than the tolerance
    STATUS_MAX_ROUNDS,      //!< all rounds used; the pose is good, the noise may still move
    STATUS_TOO_FEW_POINTS,  //!< fewer than 4 points with a ray, or 4 places (3 with a guess)
    STATUS_DEGENERATE,      //!< collinear or coinciding (to 1e-100) points or rays, or no pose with points in front
    STATUS_NOT_FINITE,      //!< NaN, infinity or sizes beyond 1e100 in points, pixels, rays or guess
    STATUS_NO_CONSENSUS     //!< RANSAC: no pose that more points agree with than by chance
};

/** @brief The kinds of noise a result may carry. */
enum NoiseModel
{
    NOISE_GIVEN = 0,  //!< nothing was estimated: the noise was known
    NOISE_ISOTROPIC,  //!< one variance, no shape: fewer than six points, or noise as large as the object
    NOISE_OBJECT,     //!< of the object points only
    NOISE_BEARING,    //!< of the bearings only
    NOISE_BOTH        //!< of both
};

/** @brief Options of a solve. Every field has a sensible default. */
struct CV_EXPORTS_W_SIMPLE Params
{
    CV_WRAP Params();

    CV_PROP_RW int method;     //!< one of #Method (default #SOLVEPNP_GMLPNP_MARGINAL)
    CV_PROP_RW int maxRounds;  //!< noise/pose rounds at most; 0: the method's own default (5 published, 20 marginal)
    //! Marginal: change of the cost L [nat] below which a round is the last (default 0.1). 0: run all rounds.
    //! The published method has its own criterion, the relative change of its covariance.
    CV_PROP_RW double tolerance;
    //! Heavy tails where the residuals ask for them, the share of the points in them estimated (default true): points
    //! that are far noisier than most, and wrong matches that look right, then weigh little. Marginal method only.
    CV_PROP_RW bool robust;
    CV_PROP_RW bool useExtrinsicGuess;  //!< start at (rvec, tvec) instead of the global solver (default false)
    CV_PROP_RW Vec3d rvec;              //!< guess: rotation vector, rad, object to camera
    CV_PROP_RW Vec3d tvec;              //!< guess: translation, the caller's length
    //! Known object noise Sigma, 3x3 positive semidefinite (entries up to 1e60, as in all of these), object frame,
    //! length^2 (GMLPnP* of Proposition 1). Empty: estimated.
    CV_PROP_RW Mat objectNoise;
    //! Known bearing noise Gamma, 3x3 positive semidefinite, camera frame, rad^2, with a lens that at its optical axis:
    //! diag(1, 1, 0) (px / f)^2 are pixels of a pinhole. Empty: estimated by the marginal method, zero in the published
    //! one.
    CV_PROP_RW Mat bearingNoise;
    //! Known covariance of each object point, added to Sigma: N rows of 9 (row-major 3x3), object frame, length^2.
    //! Empty: none.
    CV_PROP_RW Mat objectCovariances;
    //! Known covariance of each pixel, mapped to its ray by the camera and added to Gamma: N rows of 1 (variance) or 4
    //! (row-major 2x2), px^2. Empty: none. Needs a camera, so not for solveRays().
    CV_PROP_RW Mat pixelCovariances;
};

/** @brief A pose with its noise and its uncertainty. */
struct CV_EXPORTS_W_SIMPLE Result
{
    CV_WRAP Result();

    CV_PROP_RW int status;  //!< one of #Status
    CV_PROP_RW int rounds;  //!< passes over the points that moved pose and noise
    //! Negative log-likelihood at the returned values, L = 1/2 sum_i (log D_i + c_i), D_i the determinant of the
    //! 2x2 tangent covariance of point i, c_i its squared Mahalanobis residual; nat.
    CV_PROP_RW double cost;
    CV_PROP_RW Vec3d rvec;  //!< rotation vector, rad: X = R p + t
    CV_PROP_RW Vec3d tvec;  //!< translation, the caller's length
    //! 6x6 covariance of the left perturbation (phi, delta): R_true = Exp(phi) R, t_true = Exp(phi) t + delta;
    //! rad and length. Empty where the data leave no residual to judge it by (three points). This one and that of the
    //! camera's centre are of first order about the camera: where the deviation of the rotation [rad] squared, times
    //! |t|, is not far below the deviation of t (small objects at 20 of their sizes and more), ask poseCovarianceRt.
    CV_PROP_RW Mat poseCovariance;
    CV_PROP_RW Mat poseCovarianceRt;        //!< 6x6 covariance of (rvec, tvec); empty as above
    CV_PROP_RW Vec3d cameraCenter;          //!< -R^T t, object frame, length
    CV_PROP_RW Mat cameraCenterCovariance;  //!< 3x3, object frame, length^2; empty as above
    CV_PROP_RW Mat objectNoise;             //!< Sigma, 3x3, object frame, length^2: estimated, or as given
    CV_PROP_RW Mat bearingNoise;            //!< Gamma, 3x3, camera frame, rad^2 (on the axis): estimated, or as given
    //! Standard errors of the entries of objectNoise, 3x3, length^2, where it was estimated; empty where it was given,
    //! and for the published method, whose covariance is none of the noise. They take both noises for unknown (unless
    //! one was given), whatever noiseModel says. An error far above the trace of the noise says that the data do not
    //! tell: along the rays in a narrow view, and object noise from bearing noise where all depths are alike. The entry
    //! itself is then drawn towards isotropy and means nothing.
    CV_PROP_RW Mat objectNoiseStdErr;
    CV_PROP_RW Mat bearingNoiseStdErr;  //!< standard errors of the entries of bearingNoise, 3x3, rad^2; likewise
    //! Numerical rank of objectNoise. The published covariance collapses (a direction a round, Neyman-Scott): less
    //! than 3 means that objectNoise is no estimate of the noise along its null space.
    CV_PROP_RW int objectNoiseRank;
    //! One of #NoiseModel: the likeliest explanation of the residuals, by which the pose was weighed. Where the depths
    //! tell the two noises apart, objectNoise and bearingNoise are both estimated whatever it says, #NOISE_ISOTROPIC
    //! apart.
    CV_PROP_RW int noiseModel;
    //! By how much the likelihood prefers it to the next best [nat]; infinity where there was no choice. Below about 3
    //! the data cannot tell; the pose is then the mean over the explanations, weighed by their likelihoods (and for an
    //! object of little depth by a prior for bearing noise), and poseCovariance holds their spread.
    CV_PROP_RW double noiseEvidence;
    //! By how much this pose is likelier than the best other minimum [nat]; infinity where there is none, none up to 3
    //! nat behind, or none was looked for (a guess, RANSAC). Below about 3 the data cannot tell, as with a small flat
    //! object far away: see solveAll(). Negative: another, of solveAll(), is likelier. The covariances know of this
    //! minimum only.
    CV_PROP_RW double poseEvidence;
    //! Share of the points whose noise is wider: objectNoise and bearingNoise are the covariances of the others, and
    //! 6.25 times these the scale matrices of a Student-t of 2 degrees of freedom for that share. 0: Gaussian noise.
    CV_PROP_RW double tailShare;
    //! Degrees of freedom of the one Student-t that is nearest to this mixture; infinity: Gaussian.
    CV_PROP_RW double tailDof;
    CV_PROP_RW Mat weights;     //!< Nx1, weight of each point, at most 1; 0 for pixels without a ray
    CV_PROP_RW int usedPoints;  //!< points that had a ray
};

/** @brief Pose and noise from object points and pixels of any camera.

The pose needs no guess: a global solver on the rays starts it. Then Gauss-Newton on se(3) and the noise update
alternate, one pass over the points per round (Algorithm 1 of @cite zhan2024gmlpnp, or its marginal form).

@param objectPoints N points, object frame: Nx3, Nx1 or 1xN with 3 channels, vector of points; float or double.
@param imagePoints N pixels: Nx2, Nx1 or 1xN with 2 channels, vector of points; float or double. Pixels that have no
ray are left out; Result::usedPoints counts the rest.
@param camera the lens.
@param result pose, noise, uncertainty; on failure only Result::status is written.
@param params options.
@return true with a finite pose, or false and the reason in Result::status.
@throws cv::Exception StsAssert or StsBadArg for misuse, naming the argument. */
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

/** @brief Pose and noise from object points and rays: any camera, any direction, also behind the image plane.
@param objectPoints N points, object frame.
@param rays N rays in the camera frame, Nx3, Nx1 or 1xN with 3 channels or vector; normalised inside.
@param result pose, noise, uncertainty; on failure only Result::status is written.
@param params options.
@return true with a finite pose, or false and the reason in Result::status. A ray of length zero is not finite.
@throws cv::Exception StsAssert or StsBadArg for misuse, naming the argument. */
CV_EXPORTS_W bool solveRays(InputArray objectPoints, InputArray rays, CV_OUT Result& result,
                            const Params& params = Params());

/** @brief Many independent problems at once, one after the other on each core (cv::parallel_for_). The results are
those of solveRays(), bit for bit, whatever the number of threads.
@param objectPoints the points of each problem, object frame: a list of arrays as solveRays() takes them. An empty array
with empty rays, a picture in which nothing was seen, is a problem of too few points.
@param rays the rays of each problem, camera frame: as many arrays.
@param results one for each problem, in their order; where there is no pose, its Result::status says why and nothing
else in it is set.
@param params options of all of them; without objectCovariances, which belong to one problem.
@return how many problems have a pose.
@throws cv::Exception StsAssert or StsBadArg for misuse, naming the problem and the argument. */
CV_EXPORTS_W int solveBatch(InputArrayOfArrays objectPoints, InputArrayOfArrays rays,
                            CV_OUT std::vector<Result>& results, const Params& params = Params());

/** @brief Every distinct pose that fits, best first: both poses of a small flat object, for instance. Where costs
differ by a few nats solve() may return another than the first: it chooses before the poses are refined, by the noise
that explains the residuals at each.
@param objectPoints N points, object frame.
@param imagePoints N pixels.
@param camera the lens.
@param results one result per local minimum of the cost with most points in front of the camera, ascending cost.
@param params options; a guess leaves only the minimum it leads to.
@return the number of results; 0, and `results` untouched, where the data give no pose.
@throws cv::Exception StsAssert or StsBadArg for misuse, naming the argument. */
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

    //! Largest residual of an inlier: px, of solveRaysRansac() rad (below pi/2). 0 (default): 8 px, 0.01 rad. At least
    //! three standard deviations of the noise are best. What a tighter one cuts off is allowed for in the covariance of
    //! the pose; below one and a half it cannot be seen any more, and the covariance is too small (doc/ransac.md).
    CV_PROP_RW double threshold;
    CV_PROP_RW double confidence;  //!< at which the search ends: that a sample of inliers was drawn (default 0.99)
    //! Samples of three points at most (default 10000); few of them are needed where many points are inliers.
    CV_PROP_RW int maxIterations;
    CV_PROP_RW int seed;  //!< of the sampler (default 0): equal seeds, equal samples, on every platform
    //! Correspondences come best first: samples start with them (PROSAC; default false). Within three quarters of
    //! maxIterations they come from all, so that an order without a meaning costs time alone.
    CV_PROP_RW bool ordered;
};

/** @brief solve() where correspondences may be wrong, up to nine of ten.

Poses of three points (P3P on rays, any direction) are scored by their truncated residuals (MSAC); each new best is
refined (LO-RANSAC). The search ends at the asked confidence. The marginal or published method then finds pose and noise
from the inliers, which are counted anew for its pose. Points in the plane are no special case.

The residual of a point is its reprojection error, for any lens; in a panorama's seam and where the lens cannot project
the point, the angle to its ray times the scale of the lens at its pixel.

Correspondences may repeat. They are inliers together, right or wrong, so the search takes those of one object point
with nearly the same pixel (a quarter of the threshold) for one, and a consensus counts each object point and each pixel
once. Object points that differ at all are different ones. The solve takes the inliers as they come, repeats for
independent: leave them out where the uncertainty matters.

@param objectPoints N >= 4 points, object frame, as in solve().
@param imagePoints N pixels; those without a ray are outliers.
@param camera the lens.
@param result pose, noise, uncertainty, from the inliers; Result::usedPoints counts them, Result::weights is 0 for the
rest. On failure only Result::status is written.
@param inliers n x 1, CV_32S: rows of the points within the threshold at the pose that is returned, ascending.
Untouched on failure.
@param ransac options of the search.
@param params options of the solve. A guess is tried first and need not be good; known noise is that of the inliers.
@return true with a finite pose; false and the reason in Result::status: #STATUS_NO_CONSENSUS where no pose has four
inliers, repeats not counted, or no more than wrong correspondences have by chance.
@throws cv::Exception StsAssert or StsBadArg for misuse, naming the argument. */
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

/** @brief solveRays() where correspondences may be wrong, as solveRansac(); the residual of a point is its angle to its
ray.
@param objectPoints N >= 4 points, object frame.
@param rays N rays in the camera frame, as in solveRays().
@param result pose, noise, uncertainty; on failure only Result::status is written.
@param inliers n x 1, CV_32S: rows of the inliers; untouched on failure.
@param ransac options of the search; the threshold in rad.
@param params options of the solve.
@return true with a finite pose, or false and the reason in Result::status.
@throws cv::Exception StsAssert or StsBadArg for misuse, naming the argument. */
CV_EXPORTS_W bool solveRaysRansac(InputArray objectPoints, InputArray rays, CV_OUT Result& result, OutputArray inliers,
                                  const RansacParams& ransac = RansacParams(), const Params& params = Params());

/** @brief Drop-in for cv::solvePnP: the same parameters in the same order.

With #SOLVEPNP_GMLPNP and #SOLVEPNP_GMLPNP_MARGINAL any four or more points will do, coplanar or not (three with a
guess), in every array layout, and a guess is honoured. All flags of OpenCV are forwarded to cv::solvePnP.

@param objectPoints N points, object frame: Nx3, Nx1 or 1xN with 3 channels, vector of points; float or double.
@param imagePoints N pixels: Nx2, Nx1 or 1xN with 2 channels, vector of points; float or double.
@param cameraMatrix 3x3 camera matrix, any numeric depth.
@param distCoeffs 0, 4, 5, 8, 12 or 14 distortion coefficients; inverted to convergence.
@param rvec output rotation vector, 3x1: X = R p + t. CV_64F, or the depth of the array that was passed.
@param tvec output translation, 3x1, likewise.
@param useExtrinsicGuess start at the given rvec, tvec.
@param flags one of #Method, or any flag of cv::solvePnP.
@return true with a finite pose; false with rvec and tvec untouched where the data give none.
@throws cv::Exception StsAssert (-215) for wrong shapes, types and counts, StsBadArg (-5) for an unknown flag. */
CV_EXPORTS_W bool solvePnP(InputArray objectPoints, InputArray imagePoints, InputArray cameraMatrix,
                           InputArray distCoeffs, OutputArray rvec, OutputArray tvec, bool useExtrinsicGuess = false,
                           int flags = SOLVEPNP_GMLPNP_MARGINAL);

/** @brief Drop-in for cv::solvePnPRansac: the same parameters in the same order.

With #SOLVEPNP_GMLPNP and #SOLVEPNP_GMLPNP_MARGINAL this is solveRansac(). All flags of OpenCV, also those of USAC
(USAC_DEFAULT to USAC_MAGSAC), are forwarded to cv::solvePnPRansac.

@param objectPoints N >= 4 points, object frame, in any layout of solvePnP().
@param imagePoints N pixels.
@param cameraMatrix 3x3 camera matrix, any numeric depth.
@param distCoeffs 0, 4, 5, 8, 12 or 14 distortion coefficients; inverted to convergence.
@param rvec output rotation vector, 3x1: X = R p + t. CV_64F, or the depth of the array that was passed.
@param tvec output translation, 3x1, likewise.
@param useExtrinsicGuess try the given rvec, tvec first; they need not be good.
@param iterationsCount samples at most. They are of three points and stop at the asked confidence, so the default is
larger than OpenCV's 100.
@param reprojectionError largest reprojection error of an inlier, px.
@param confidence at which the search ends.
@param inliers n x 1, CV_32S: rows of the inliers of the pose that is returned, ascending.
@param flags one of #Method, any flag of cv::solvePnP, or one of USAC.
@return true with a finite pose; false with rvec, tvec and inliers untouched where there is no consensus.
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
@param cameraMatrix 3x3 camera matrix; it is never written. Without one cv::solvePnPRansac finds a camera too; this
function does not (StsAssert).
@param distCoeffs 0, 4, 5, 8, 12 or 14 distortion coefficients.
@param rvec output rotation vector, 3x1.
@param tvec output translation, 3x1.
@param inliers n x 1, CV_32S: rows of the inliers.
@param params threshold [px], confidence, maxIterations and randomGeneratorState (the seed) are used, sampler chooses
between uniform samples and SAMPLING_PROSAC (correspondences best first; every other sampler is uniform). The rest says
how OpenCV's search does its work (isParallel, loIterations, loMethod, loSampleSize, neighborsSearch, score) and means
nothing to this one. */
CV_EXPORTS_W bool solvePnPRansac(InputArray objectPoints, InputArray imagePoints, InputOutputArray cameraMatrix,
                                 InputArray distCoeffs, OutputArray rvec, OutputArray tvec, OutputArray inliers,
                                 const UsacParams& params = UsacParams());

/** @brief Drop-in for cv::solvePnPGeneric: every distinct pose, best first as in solveAll().
@param objectPoints N points, object frame, in any layout of solvePnP().
@param imagePoints N pixels.
@param cameraMatrix 3x3 camera matrix, any numeric depth.
@param distCoeffs 0, 4, 5, 8, 12 or 14 distortion coefficients.
@param rvecs rotation vectors: vector of Mat (3x1, CV_64F), Vec3d, Vec3f, Point3d...
@param tvecs translations, likewise.
@param useExtrinsicGuess start at rvec, tvec; one pose comes out.
@param flags one of #Method, or any flag of cv::solvePnPGeneric.
@param rvec guess, never written.
@param tvec guess, never written.
@param reprojectionError n x 1: root mean square over both coordinates of all points, px.
@return the number of poses; 0, and all outputs untouched, where the data give none.
@throws cv::Exception as solvePnP(). */
CV_EXPORTS_W int solvePnPGeneric(InputArray objectPoints, InputArray imagePoints, InputArray cameraMatrix,
                                 InputArray distCoeffs, OutputArrayOfArrays rvecs, OutputArrayOfArrays tvecs,
                                 bool useExtrinsicGuess = false, int flags = SOLVEPNP_GMLPNP_MARGINAL,
                                 InputArray rvec = noArray(), InputArray tvec = noArray(),
                                 OutputArray reprojectionError = noArray());

/** @brief The marginal method from a given pose, which it never makes worse: the cost L of the pose that comes out is
at most that of the pose that went in, both at the noise that was found.
@param objectPoints N >= 3 points, object frame.
@param imagePoints N pixels.
@param cameraMatrix 3x3 camera matrix, any numeric depth.
@param distCoeffs 0, 4, 5, 8, 12 or 14 distortion coefficients.
@param rvec rotation vector of any shape, in and out (3x1); untouched where the data give no pose.
@param tvec translation, likewise.
@param criteria the count bounds the rounds of pose and noise, which follow a Gauss-Newton descent of the isotropic cost
from the given pose; they end by the change of the cost, so epsilon is not used.
@throws cv::Exception as solvePnP(). */
CV_EXPORTS_W void solvePnPRefine(InputArray objectPoints, InputArray imagePoints, InputArray cameraMatrix,
                                 InputArray distCoeffs, InputOutputArray rvec, InputOutputArray tvec,
                                 TermCriteria criteria = TermCriteria(TermCriteria::EPS + TermCriteria::COUNT, 20,
                                                                      FLT_EPSILON));

/** @brief cv::solvePnPRefineLM, forwarded.
@param objectPoints, imagePoints, cameraMatrix, distCoeffs, rvec, tvec, criteria as in cv::solvePnPRefineLM. */
CV_EXPORTS_W void solvePnPRefineLM(InputArray objectPoints, InputArray imagePoints, InputArray cameraMatrix,
                                   InputArray distCoeffs, InputOutputArray rvec, InputOutputArray tvec,
                                   TermCriteria criteria = TermCriteria(TermCriteria::EPS + TermCriteria::COUNT, 20,
                                                                        FLT_EPSILON));

/** @brief cv::solvePnPRefineVVS, forwarded.
@param objectPoints, imagePoints, cameraMatrix, distCoeffs, rvec, tvec, criteria, VVSlambda as in
cv::solvePnPRefineVVS. */
CV_EXPORTS_W void solvePnPRefineVVS(InputArray objectPoints, InputArray imagePoints, InputArray cameraMatrix,
                                    InputArray distCoeffs, InputOutputArray rvec, InputOutputArray tvec,
                                    TermCriteria criteria = TermCriteria(TermCriteria::EPS + TermCriteria::COUNT, 20,
                                                                         FLT_EPSILON),
                                    double VVSlambda = 1);

/** @brief The lens of cv::fisheye: Kannala-Brandt, as in CameraModel::fisheye, on the whole sphere. */
namespace fisheye {

/** @brief Drop-in for cv::fisheye::solvePnP (OpenCV 4.10 and newer): the same parameters in the same order.

The flags of this module work on rays: also at 90 degrees and beyond, where the image plane has no pixel. The flags of
OpenCV get the pixels undistorted to the image plane of cameraMatrix, and so need all rays in front of the camera.

@param objectPoints N points, object frame: Nx3, Nx1 or 1xN with 3 channels, vector of points; float or double.
@param imagePoints N pixels: Nx2, Nx1 or 1xN with 2 channels, vector of points; float or double. Our flags leave out
pixels that have no ray.
@param cameraMatrix 3x3 camera matrix, any numeric depth.
@param distCoeffs k1, k2, k3, k4, or none.
@param rvec output rotation vector, 3x1: X = R p + t. CV_64F, or the depth of the array that was passed.
@param tvec output translation, 3x1, likewise.
@param useExtrinsicGuess start at the given rvec, tvec.
@param flags one of #Method, or any flag of cv::solvePnP.
@param criteria not used: the lens is inverted to convergence.
@return true with a finite pose; false with rvec and tvec untouched where the data give none.
@throws cv::Exception StsAssert (-215) for wrong shapes, types and counts, StsBadArg (-5) for an unknown flag, and for
a flag of OpenCV with a pixel that has no ray in front of the camera. */
CV_EXPORTS_W bool solvePnP(InputArray objectPoints, InputArray imagePoints, InputArray cameraMatrix,
                           InputArray distCoeffs, OutputArray rvec, OutputArray tvec, bool useExtrinsicGuess = false,
                           int flags = cv::gmlpnp::SOLVEPNP_GMLPNP_MARGINAL,
                           TermCriteria criteria = TermCriteria(TermCriteria::MAX_ITER + TermCriteria::EPS, 10, 1e-8));

/** @brief Drop-in for cv::fisheye::solvePnPRansac (OpenCV 4.12 and newer): the same parameters in the same order.

The flags of this module are solveRansac() with this lens, also at 90 degrees and beyond. The flags of OpenCV get the
pixels undistorted to the image plane of cameraMatrix, where reprojectionError is then measured.

@param objectPoints N >= 4 points, object frame.
@param imagePoints N pixels; for our flags those without a ray are outliers.
@param cameraMatrix 3x3 camera matrix, any numeric depth.
@param distCoeffs k1, k2, k3, k4, or none.
@param rvec output rotation vector, 3x1: X = R p + t. CV_64F, or the depth of the array that was passed.
@param tvec output translation, 3x1, likewise.
@param useExtrinsicGuess try the given rvec, tvec first.
@param iterationsCount samples of three points at most.
@param reprojectionError largest reprojection error of an inlier, px of the picture.
@param confidence at which the search ends.
@param inliers n x 1, CV_32S: rows of the inliers of the pose that is returned, ascending.
@param flags one of #Method, any flag of cv::solvePnP, or one of USAC.
@param criteria not used: the lens is inverted to convergence.
@return true with a finite pose; false with rvec, tvec and inliers untouched where there is no consensus.
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
