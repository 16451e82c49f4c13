// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "../arrays/inputs.hpp"
#include "../noise/tails.hpp"
#include "boundary.hpp"

namespace cv {
namespace gmlpnp {

Params::Params()
    : method(SOLVEPNP_GMLPNP_MARGINAL),
      maxRounds(0),
      tolerance(detail::DEFAULT_TOLERANCE),
      robust(true),
      useExtrinsicGuess(false)
{}

Result::Result()
    : status(STATUS_TOO_FEW_POINTS),
      rounds(0),
      cost(0),
      objectNoiseRank(0),
      noiseModel(NOISE_GIVEN),
      noiseEvidence(0),
      poseEvidence(0),
      tailShare(0),
      tailDof(std::numeric_limits<double>::infinity()),
      usedPoints(0)
{}

namespace detail {

namespace {

Matrix3d toEigen(const double* rowMajor)
{
    return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(rowMajor);
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

// Symmetric positive semidefinite, and of a size that leaves the pose's covariance in the range of doubles.
bool isCovariance(const Matrix3d& given)
{
    constexpr double ROUNDING = 1e-6;  // relative; covariances often come in single precision
    constexpr double LARGEST = 1e60;
    const double largest = given.cwiseAbs().maxCoeff();
    if (!given.allFinite() || largest > LARGEST)
        return false;
    if (largest == 0)
        return true;
    const Matrix3d M = given / largest;  // norms of very large or small entries would leave the range of doubles
    return (M - M.transpose()).norm() <= ROUNDING &&
           Eigen3d(symmetrised(M), Eigen::EigenvaluesOnly).eigenvalues()(0) >= -ROUNDING;
}

bool isZero(const Mat& m)
{
    return m.empty() || countNonZero(m.reshape(1) != 0) == 0;  // NaN is not zero
}

KnownNoise knownNoise(const Mat& given, const char* name)
{
    if (given.empty())
        return std::nullopt;
    const Mat_<double> matrix = matrixFrom(given, 3, 3, name);
    const Matrix3d M = toEigen(matrix[0]);
    if (!isCovariance(M))
        CV_Error(Error::StsBadArg, format("%s must be symmetric positive semidefinite and at most 1e60", name));
    return symmetrised(M);
}

// N rows of `columns` numbers; the shape is checked here, the matrices by their users.
Mat_<double> covarianceRows(const Mat& given, int rows, std::initializer_list<int> columns, const char* name)
{
    // One row per point, or a vector with one element per point: 1xN or Nx1 with channels.
    const bool vector = given.dims == 2 && given.rows == 1 && given.cols == rows;
    const Mat dense = given.isContinuous() ? given : given.clone();
    const Mat flat = dense.dims == 2 ? dense.reshape(1, vector ? rows : given.rows) : dense;
    const bool fits = std::find(columns.begin(), columns.end(), flat.cols) != columns.end();
    if (flat.rows != rows || !fits)
        CV_Error(Error::StsAssert, format("%s must have one row per point, with %s numbers; there are %d points", name,
                                          columns.size() > 1 ? "1 or 4" : "9", rows));
    return matrixFrom(flat, rows, flat.cols, name);
}

void checkCovariance(const Matrix3d& C, const char* name, int point)
{
    if (!isCovariance(C))
        CV_Error(Error::StsBadArg,
                 format("%s: point %d is not symmetric positive semidefinite and at most 1e60", name, point));
}

Mat_<double> knownObject(const Params& params, int rows)
{
    if (params.objectCovariances.empty())
        return {};
    Mat_<double> given = covarianceRows(params.objectCovariances, rows, {9}, "objectCovariances");
    for (int i = 0; i < rows; ++i)
        checkCovariance(toEigen(given[i]), "objectCovariances", i);
    return given;
}

// J C J^T with the derivative J of the ray with respect to the pixel: the pixel's covariance as that of its ray.
Mat_<double> knownRays(const Params& params, const Mat_<double>& jacobian, const Mat_<uchar>& valid)
{
    if (params.pixelCovariances.empty())
        return {};
    const int rows = jacobian.rows;
    const Mat_<double> given = covarianceRows(params.pixelCovariances, rows, {1, 4}, "pixelCovariances");
    Mat_<double> out(rows, 9, 0.0);
    for (int i = 0; i < rows; ++i) {
        Matrix3d padded = Matrix3d::Zero();
        padded(0, 0) = given(i, 0);
        padded(1, 1) = given(i, given.cols - 1);
        if (given.cols == 4)
            padded(0, 1) = given(i, 1), padded(1, 0) = given(i, 2);
        checkCovariance(padded, "pixelCovariances", i);
        if (!valid(i))
            continue;
        const Eigen::Map<const Eigen::Matrix<double, 3, 2, Eigen::RowMajor>> J(jacobian[i]);
        Eigen::Map<Matrix3d> covariance(out[i]);  // symmetric: row-major and column-major are one
        covariance = symmetrised(J * padded.topLeftCorner<2, 2>() * J.transpose());
    }
    return out;
}

void scaleRays(const CameraModel& camera, Mat_<double>& rays)
{
    constexpr double SMALLEST = 0.01, LARGEST = 100;  // nobody calibrates a lens to the very edge of its field
    std::vector<double> scales(rays.rows);
    Vec3d* const ray = rays.ptr<Vec3d>();
    camera.angularScales(ray, rays.rows, scales.data());
    for (int i = 0; i < rays.rows; ++i) {
        const double length = std::sqrt(ray[i].dot(ray[i]));  // of a caller's own lens it may be any
        ray[i] *= std::min(std::max(SMALLEST, scales[i]), LARGEST) / length;
    }
}

void checkSameCount(const Mat& points, const Mat& images, const char* name)
{
    if (points.rows != images.rows)
        CV_Error(Error::StsAssert,
                 format("objectPoints and %s differ in number: %d and %d", name, points.rows, images.rows));
}

bool finiteGuess(const Params& params)
{
    constexpr double LARGEST = 1e100;
    const auto fine = [](const Vec3d& v) { return toEigen(v).allFinite() && norm(v, NORM_INF) <= LARGEST; };
    return !params.useExtrinsicGuess || (fine(params.rvec) && fine(params.tvec));
}

}  // namespace

Mat_<double> chosenRows(const Mat_<double>& all, const std::vector<int>& rows)
{
    if (all.empty() || static_cast<int>(rows.size()) == all.rows)
        return all;
    Mat_<double> chosen(static_cast<int>(rows.size()), all.cols);
    for (int k = 0; k < chosen.rows; ++k)
        std::copy(all[rows[k]], all[rows[k]] + all.cols, chosen[k]);
    return chosen;
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
    options.stopping.robust = params.robust && options.method == SOLVEPNP_GMLPNP_MARGINAL;
    if (params.maxRounds > 0)
        options.stopping.maxRounds = params.maxRounds;
    if (!published || params.tolerance == 0)
        options.stopping.tolerance = params.tolerance;
    const bool gammaIsZero = options.Gamma ? options.Gamma->isZero(0) : options.method == SOLVEPNP_GMLPNP;
    if (options.Sigma && options.Sigma->isZero(0) && gammaIsZero && isZero(params.objectCovariances) &&
        isZero(params.pixelCovariances))
        CV_Error(Error::StsBadArg, "objectNoise and bearingNoise are both zero: there is nothing to weigh by");
    return options;
}

Input inputRays(InputArray objectPoints, InputArray rays, const Params& params)
{
    if (!params.pixelCovariances.empty())
        CV_Error(Error::StsBadArg, "pixelCovariances need a camera: solve() takes one, solveRays() does not");
    Input input;
    input.observations.points = pointsFrom(objectPoints, 3, "objectPoints");
    input.observations.rays = pointsFrom(rays, 3, "rays");
    checkSameCount(input.observations.points, input.observations.rays, "rays");
    input.total = input.observations.points.rows;
    input.observations.objectCovariances = knownObject(params, input.total);
    input.used.resize(input.total);
    for (int i = 0; i < input.total; ++i)
        input.used[i] = i;
    input.finite = finiteGuess(params);
    return input;
}

Input inputPixels(InputArray objectPoints, InputArray imagePoints, const Ptr<CameraModel>& camera, const Params& params,
                  bool wantRayByPixel)
{
    if (!camera)
        CV_Error(Error::StsBadArg, "camera is null");
    const Mat_<double> points = pointsFrom(objectPoints, 3, "objectPoints");
    const Mat_<double> pixels = pointsFrom(imagePoints, 2, "imagePoints");
    checkSameCount(points, pixels, "imagePoints");
    const bool weighed = !params.pixelCovariances.empty();
    Mat rays, jacobian;
    Mat_<uchar> valid;
    camera->unproject(pixels, rays, valid, weighed || wantRayByPixel ? OutputArray(jacobian) : OutputArray(noArray()));

    Input input;
    input.total = points.rows;
    input.used.reserve(input.total);
    for (int i = 0; i < input.total; ++i)
        if (valid(i))
            input.used.push_back(i);
    const bool allUsed = static_cast<int>(input.used.size()) == input.total;
    input.observations = {chosenRows(points, input.used), chosenRows(rays, input.used),
                          chosenRows(knownObject(params, input.total), input.used),
                          chosenRows(weighed ? knownRays(params, jacobian, valid) : Mat_<double>(), input.used), true};
    scaleRays(*camera, input.observations.rays);
    if (wantRayByPixel)
        input.rayByPixel = chosenRows(jacobian, input.used);
    // A pixel that is not a number is bad data, not a pixel without a ray; so is a point, also without a ray. Where all
    // pixels have a ray they are finite, and the solver looks at the points.
    const auto allFinite = [](const Mat& m) { return checkRange(m, true, nullptr, -DBL_MAX, DBL_MAX); };
    input.finite = finiteGuess(params) && (allUsed || (allFinite(pixels) && allFinite(points)));
    return input;
}

bool run(const Input& input, const Options& options, Status& status, std::vector<Solution>& solutions)
{
    status = input.finite ? solveAll(input.observations, options, solutions) : STATUS_NOT_FINITE;
    return isSuccess(status);
}

namespace {

NoiseModel noiseModelOf(NoiseKind kind)
{
    switch (kind) {
        case NoiseKind::BEARING:
            return NOISE_BEARING;
        case NoiseKind::BOTH:
            return NOISE_BOTH;
        case NoiseKind::FIXED:
            return NOISE_GIVEN;
        case NoiseKind::ISOTROPIC:
            return NOISE_ISOTROPIC;
        default:
            return NOISE_OBJECT;
    }
}

}  // namespace

Result toResult(const Solution& solution, Status status, const Input& input)
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
    if (solution.objectError)
        out.objectNoiseStdErr = toMat(*solution.objectError);
    if (solution.bearingError)
        out.bearingNoiseStdErr = toMat(*solution.bearingError);
    constexpr double NUMERICAL_RANK = 1e-6;  // of the largest variance
    out.objectNoiseRank = rank(solution.noise.Sigma, NUMERICAL_RANK);
    out.noiseModel = noiseModelOf(solution.kind);
    out.noiseEvidence = solution.evidence;
    out.poseEvidence = solution.poseEvidence;
    out.tailShare = solution.noise.tails.share;
    out.tailDof = nearestStudentT(solution.noise.tails);
    out.usedPoints = static_cast<int>(input.used.size());
    Mat_<double> weights(input.total, 1, 0.0);
    for (size_t k = 0; k < solution.weights.size(); ++k)
        weights(input.used[k]) = solution.weights[k];
    out.weights = weights;
    return out;
}

bool solveOne(const Input& input, const Options& options, Result& result)
{
    Status status;
    std::vector<Solution> solutions;
    if (!run(input, options, status, solutions)) {
        result.status = status;
        return false;
    }
    result = toResult(solutions.front(), status, input);
    return true;
}

Params paramsOf(int flags, bool useExtrinsicGuess, InputArray rvec, InputArray tvec)
{
    if (flags != SOLVEPNP_GMLPNP && flags != SOLVEPNP_GMLPNP_MARGINAL)
        CV_Error(Error::StsBadArg,
                 format("flags: %d is neither of cv::SolvePnPMethod nor of cv::gmlpnp::Method", flags));
    Params params;
    params.method = flags;
    params.useExtrinsicGuess = useExtrinsicGuess;
    if (useExtrinsicGuess) {
        params.rvec = guessFrom(rvec, "rvec");
        params.tvec = guessFrom(tvec, "tvec");
    }
    return params;
}

void requireEnough(const Input& input, int fewest)
{
    if (input.total < fewest)
        CV_Error(Error::StsAssert, format("objectPoints: fewer than %d points", fewest));
}

Vec3d guessFrom(InputArray vec, const char* name)
{
    const Mat m = vec.getMat();
    if (m.total() * m.channels() != 3 || (m.depth() != CV_32F && m.depth() != CV_64F))
        CV_Error(Error::StsAssert, format("%s must hold 3 floating-point numbers to be a guess", name));
    Mat_<double> flat;
    m.reshape(1, 3).convertTo(flat, CV_64F);
    return {flat(0), flat(1), flat(2)};
}

void addPose(const Pose& pose, OutputArray rvec, OutputArray tvec, Outputs& outputs)
{
    outputs.add(toVec(logSO3(pose.R)), rvec, "rvec");
    outputs.add(toVec(pose.t), tvec, "tvec");
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
