// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "../arrays/eigen.hpp"
#include "../arrays/inputs.hpp"
#include "../math/limits.hpp"
#include "../math/spd3.hpp"
#include "options.hpp"

namespace cv {
namespace gmlpnp {

Params::Params()
    : method(SOLVEPNP_GMLPNP_MARGINAL),
      maxRounds(0),
      tolerance(detail::DEFAULT_TOLERANCE),
      robust(true),
      useExtrinsicGuess(false)
{}

namespace detail {

bool isCovariance(const Matrix3d& given)
{
    constexpr double ROUNDING = 1e-6;  // relative; covariances often come in single precision
    const double largest = given.cwiseAbs().maxCoeff();
    if (!given.allFinite() || largest > LARGEST_COVARIANCE)
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

bool finiteGuess(const Params& params)
{
    const auto fine = [](const Vec3d& v) { return toEigen(v).allFinite() && norm(v, NORM_INF) <= LARGEST_LENGTH; };
    return !params.useExtrinsicGuess || (fine(params.rvec) && fine(params.tvec));
}

namespace {

KnownNoise knownNoise(const Mat& given, const char* name)
{
    if (given.empty())
        return std::nullopt;
    const Mat_<double> matrix = matrixFrom(given, 3, 3, name);
    const Matrix3d M = matrix3(matrix[0]);
    if (!isCovariance(M))
        CV_Error(Error::StsBadArg, format("%s must be symmetric positive semidefinite and at most 1e60", name));
    return symmetrised(M);
}

void checkNumbers(const Params& params)
{
    if (params.method != SOLVEPNP_GMLPNP && params.method != SOLVEPNP_GMLPNP_MARGINAL)
        CV_Error(Error::StsBadArg, format("method: %d is not one of cv::gmlpnp::Method", params.method));
    if (params.maxRounds < 0)
        CV_Error(Error::StsBadArg, format("maxRounds: %d is negative", params.maxRounds));
    if (!(params.tolerance >= 0))
        CV_Error(Error::StsBadArg, format("tolerance: %g is negative or not a number", params.tolerance));
}

// Something must weigh the residuals.
void checkNotAllZero(const Options& options, const Params& params)
{
    const bool gammaIsZero = options.Gamma ? options.Gamma->isZero(0) : !options.marginal();
    if (options.Sigma && options.Sigma->isZero(0) && gammaIsZero && isZero(params.objectCovariances) &&
        isZero(params.pixelCovariances))
        CV_Error(Error::StsBadArg, "objectNoise and bearingNoise are both zero: there is nothing to weigh by");
}

// The published method has a criterion of its own: only a tolerance of zero, all rounds, means the same to it.
Limits limitsFrom(const Params& params, bool published)
{
    Limits limits = defaultLimits(published);
    if (params.maxRounds > 0)
        limits.rounds = params.maxRounds;
    if (!published || params.tolerance == 0)
        limits.tolerance = params.tolerance;
    return limits;
}

// 3 floating-point numbers of any shape.
Vec3d guessFrom(InputArray vec, const char* name)
{
    const Mat m = vec.getMat();
    if (m.total() * m.channels() != 3 || (m.depth() != CV_32F && m.depth() != CV_64F))
        CV_Error(Error::StsAssert, format("%s must hold 3 floating-point numbers to be a guess", name));
    Mat_<double> flat;
    m.reshape(1, 3).convertTo(flat, CV_64F);
    return {flat(0), flat(1), flat(2)};
}

}  // namespace

Options optionsFrom(const Params& params)
{
    checkNumbers(params);
    Options options;
    options.method = static_cast<Method>(params.method);
    if (params.useExtrinsicGuess)
        options.guess = Pose{expSO3(toEigen(params.rvec)), toEigen(params.tvec)};
    options.Sigma = knownNoise(params.objectNoise, "objectNoise");
    options.Gamma = knownNoise(params.bearingNoise, "bearingNoise");
    options.limits = limitsFrom(params, !options.marginal() && !options.Sigma);
    options.tails = params.robust && options.marginal();
    // With fewer rounds than the default a subset could not hand on a pose that is near its end.
    options.bySubsets =
        params.maxRounds == 0 || (options.marginal() && params.maxRounds >= defaultLimits(false).rounds);
    checkNotAllZero(options, params);
    return options;
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

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
