// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "precomp.hpp"

#include "arrays.hpp"
#include "solve.hpp"
#include "solvepnp.hpp"

// The OpenCV boundary: arrays in and out, checks, cv-compatible names. No mathematics.

namespace cv {
namespace gmlpnp {

Params::Params()
    : method(SOLVEPNP_GMLPNP_MARGINAL), maxRounds(0), tolerance(detail::DEFAULT_TOLERANCE), useExtrinsicGuess(false)
{}

Result::Result() : status(STATUS_TOO_FEW_POINTS), rounds(0), cost(0), objectNoiseRank(0), usedPoints(0) {}

namespace {

using namespace detail;

Matrix3d toEigen(const Matx33d& M)
{
    return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(M.val);
}

Vector3d toEigen(const Vec3d& v)
{
    return {v[0], v[1], v[2]};
}

Vec3d toVec(const Vector3d& v)
{
    return {v.x(), v.y(), v.z()};
}

template <class Derived>
Mat toMat(const Eigen::MatrixBase<Derived>& M)
{
    Mat_<double> out(static_cast<int>(M.rows()), static_cast<int>(M.cols()));
    for (int i = 0; i < out.rows; ++i)
        for (int j = 0; j < out.cols; ++j)
            out(i, j) = M(i, j);
    return std::move(out);
}

std::optional<Matrix3d> knownNoise(const Mat& given, const char* name)
{
    if (given.empty())
        return std::nullopt;
    const Matrix3d M = toEigen(Matx33d(matrixFrom(given, 3, 3, name)));
    constexpr double ROUNDING = 1e-9;  // relative
    const bool usable = M.allFinite() && (M - M.transpose()).norm() <= ROUNDING * M.norm() &&
                        Eigen3d(symmetrised(M)).eigenvalues()(0) >= -ROUNDING * M.norm();
    if (!usable)
        CV_Error(Error::StsBadArg, format("%s must be symmetric positive semidefinite", name));
    return symmetrised(M);
}

Options checked(const Params& params)
{
    if (params.method != SOLVEPNP_GMLPNP && params.method != SOLVEPNP_GMLPNP_MARGINAL)
        CV_Error(Error::StsBadArg, format("method: %d is not one of cv::gmlpnp::Method", params.method));
    if (params.maxRounds < 0)
        CV_Error(Error::StsBadArg, format("maxRounds: %d is negative", params.maxRounds));
    if (!(params.tolerance >= 0))
        CV_Error(Error::StsBadArg, format("tolerance: %g is negative or not a number", params.tolerance));
    Options options;
    options.method = static_cast<Method>(params.method);
    if (params.useExtrinsicGuess)
        options.guess = Pose{expSO3(toEigen(params.rvec)), toEigen(params.tvec)};
    options.Sigma = knownNoise(params.objectNoise, "objectNoise");
    options.Gamma = knownNoise(params.bearingNoise, "bearingNoise");
    const bool published = options.method == SOLVEPNP_GMLPNP && !options.Sigma;
    options.stopping = defaultStopping(published);
    if (params.maxRounds > 0)
        options.stopping.maxRounds = params.maxRounds;
    if (!published || params.tolerance == 0)
        options.stopping.tolerance = params.tolerance;
    if (options.Sigma && options.Gamma && options.Sigma->isZero(0) && options.Gamma->isZero(0))
        CV_Error(Error::StsBadArg, "objectNoise and bearingNoise are both zero: there is nothing to weigh by");
    return options;
}

void write(const Solution& solution, Status status, int usedPoints, Result& result)
{
    const Pose& pose = solution.pose;
    Result out;
    out.status = status;
    out.rounds = solution.rounds;
    out.cost = solution.cost;
    out.rvec = toVec(logSO3(pose.R));
    out.tvec = toVec(pose.t);
    out.cameraCenter = toVec(-pose.R.transpose() * pose.t);
    if (solution.covariance) {
        out.poseCovariance = toMat(*solution.covariance);
        out.poseCovarianceRt = toMat(toRvecTvec(*solution.covariance, pose));
        out.cameraCenterCovariance = toMat(toCameraCenter(*solution.covariance, pose));
    }
    out.objectNoise = toMat(solution.noise.Sigma);
    out.bearingNoise = toMat(solution.noise.Gamma);
    constexpr double NUMERICAL_RANK = 1e-6;  // of the largest variance
    out.objectNoiseRank = rank(solution.noise.Sigma, NUMERICAL_RANK);
    out.usedPoints = usedPoints;
    result = out;
}

bool solveChecked(const Mat_<double>& points, const Mat_<double>& rays, const Options& options, Result& result)
{
    const bool guessFinite = !options.guess || (options.guess->R.allFinite() && options.guess->t.allFinite());
    Solution solution;
    const Status status = guessFinite ? detail::solveRays(points, rays, options, solution) : STATUS_NOT_FINITE;
    if (status == STATUS_CONVERGED || status == STATUS_MAX_ROUNDS) {
        write(solution, status, points.rows, result);
        return true;
    }
    result.status = status;
    return false;
}

void checkSameCount(const Mat& points, const Mat& images, const char* name)
{
    if (points.rows != images.rows)
        CV_Error(Error::StsAssert,
                 format("objectPoints and %s differ in number: %d and %d", name, points.rows, images.rows));
}

// Rays of the pixels that have one, and the points that go with them.
void keepValid(const Mat& valid, Mat_<double>& points, Mat_<double>& rays)
{
    const int used = countNonZero(valid);
    if (used == points.rows)
        return;
    Mat_<double> keptPoints(used, 3), keptRays(used, 3);
    for (int i = 0, k = 0; i < points.rows; ++i)
        if (valid.at<uchar>(i)) {
            points.row(i).copyTo(keptPoints.row(k));
            rays.row(i).copyTo(keptRays.row(k++));
        }
    points = keptPoints;
    rays = keptRays;
}

}  // namespace

bool solveRays(InputArray objectPoints, InputArray rays, Result& result, const Params& params)
{
    const Options options = checked(params);
    const Mat_<double> points = pointsFrom(objectPoints, 3, "objectPoints"), directions = pointsFrom(rays, 3, "rays");
    checkSameCount(points, directions, "rays");
    return solveChecked(points, directions, options, result);
}

bool solve(InputArray objectPoints, InputArray imagePoints, const Ptr<CameraModel>& camera, Result& result,
           const Params& params)
{
    const Options options = checked(params);
    if (!camera)
        CV_Error(Error::StsBadArg, "camera is null");
    Mat_<double> points = pointsFrom(objectPoints, 3, "objectPoints");
    const Mat_<double> pixels = pointsFrom(imagePoints, 2, "imagePoints");
    checkSameCount(points, pixels, "imagePoints");
    // A pixel that is not a number is bad data, not a pixel without a ray.
    if (!checkRange(pixels, true, nullptr, -DBL_MAX, DBL_MAX)) {
        result.status = STATUS_NOT_FINITE;
        return false;
    }
    Mat rays, valid;
    camera->unproject(pixels, rays, valid);
    Mat_<double> directions = rays;
    keepValid(valid, points, directions);
    return solveChecked(points, directions, options, result);
}

bool solve(InputArray objectPoints, InputArray imagePoints, InputArray cameraMatrix, InputArray distCoeffs,
           Result& result, const Params& params)
{
    return solve(objectPoints, imagePoints, CameraModel::pinhole(cameraMatrix, distCoeffs), result, params);
}

namespace {

Vec3d guessFrom(InputArray vec, const char* name)
{
    const Mat m = vec.getMat();
    if (m.total() * m.channels() != 3 || (m.depth() != CV_32F && m.depth() != CV_64F))
        CV_Error(Error::StsAssert, format("%s must hold 3 floating-point numbers to be a guess", name));
    Mat_<double> flat;
    m.reshape(1, 3).convertTo(flat, CV_64F);
    return {flat(0), flat(1), flat(2)};
}

// 3x1, in the depth of the array that was passed, as cv::solvePnP does it.
void writeVector(const Vec3d& v, OutputArray out)
{
    const int depth = out.empty() && !out.fixedType() ? CV_64F : out.depth();
    Mat(v).convertTo(out, depth == CV_32F ? CV_32F : CV_64F);
}

}  // namespace

bool detail::solvePnPWith(const Ptr<CameraModel>& camera, InputArray objectPoints, InputArray imagePoints,
                          OutputArray rvec, OutputArray tvec, bool useExtrinsicGuess, int flags)
{
    if (flags != SOLVEPNP_GMLPNP && flags != SOLVEPNP_GMLPNP_MARGINAL)
        CV_Error(Error::StsBadArg,
                 format("flags: %d is neither of cv::SolvePnPMethod nor of cv::gmlpnp::Method", flags));
    const size_t fewest = useExtrinsicGuess ? 3 : 4;
    if (pointsFrom(objectPoints, 3, "objectPoints").rows < static_cast<int>(fewest))
        CV_Error(Error::StsAssert, format("objectPoints: fewer than %d points", static_cast<int>(fewest)));
    Params params;
    params.method = flags;
    params.useExtrinsicGuess = useExtrinsicGuess;
    if (useExtrinsicGuess) {
        params.rvec = guessFrom(rvec, "rvec");
        params.tvec = guessFrom(tvec, "tvec");
    }
    Result result;
    if (!solve(objectPoints, imagePoints, camera, result, params))
        return false;
    writeVector(result.rvec, rvec);
    writeVector(result.tvec, tvec);
    return true;
}

bool solvePnP(InputArray objectPoints, InputArray imagePoints, InputArray cameraMatrix, InputArray distCoeffs,
              OutputArray rvec, OutputArray tvec, bool useExtrinsicGuess, int flags)
{
    if (detail::isOpenCVFlag(flags))
        return cv::solvePnP(objectPoints, imagePoints, cameraMatrix, distCoeffs, rvec, tvec, useExtrinsicGuess, flags);
    return detail::solvePnPWith(CameraModel::pinhole(cameraMatrix, distCoeffs), objectPoints, imagePoints, rvec, tvec,
                                useExtrinsicGuess, flags);
}

}  // namespace gmlpnp
}  // namespace cv
