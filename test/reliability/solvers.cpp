// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "solvers.hpp"

#include <cstring>

#include "src/math/spd3.hpp"

namespace reliability {

namespace {

using cv::gmlpnp::Result;
using cv::gmlpnp::detail::expSO3;

// What outputs hold before a call, where they hold no guess.
const cv::Vec3d UNTOUCHED(1.25, -2.5, 3.75);

bool same(const cv::Vec3d& a, const cv::Vec3d& b)
{
    // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): bits are meant, of NaN too
    return std::memcmp(a.val, b.val, sizeof(a.val)) == 0;
}

bool same(const cv::Mat_<double>& a, const cv::Mat_<double>& b)
{
    return a.total() == b.total() && (a.empty() || std::memcmp(a[0], b[0], a.total() * sizeof(double)) == 0);
}

Vector3d toEigen(const cv::Vec3d& v)
{
    return {v[0], v[1], v[2]};
}

// The numbers that a caller gets as the pose.
cv::Vec3d vectorOf(const cv::Mat_<double>& m)
{
    constexpr double NONE = std::numeric_limits<double>::quiet_NaN();
    return m.total() == 3 ? cv::Vec3d(m(0), m(1), m(2)) : cv::Vec3d::all(NONE);
}

struct Vectors
{
    cv::Vec3d rvec, tvec;
};

Vectors vectorsOf(const Solver& solver, const Outputs& outputs)
{
    if (solver.fullResult)
        return {outputs.result.rvec, outputs.result.tvec};
    return {vectorOf(outputs.rvec), vectorOf(outputs.tvec)};
}

Outputs outputsFor(const Problem& problem, Vectors& before)
{
    before = problem.hasGuess() ? Vectors{problem.rvec, problem.tvec} : Vectors{UNTOUCHED, UNTOUCHED};
    Outputs out{cv::Mat_<double>(3, 1), cv::Mat_<double>(3, 1), {}};
    for (int k = 0; k < 3; ++k) {
        out.rvec(k) = before.rvec[k];
        out.tvec(k) = before.tvec[k];
    }
    out.result.rvec = before.rvec;
    out.result.tvec = before.tvec;
    return out;
}

// Any finite rvec is a rotation up to the rounding of its sine; ours are the shortest of theirs, OpenCV's need not be.
bool isPose(const Vectors& vectors, bool ours)
{
    constexpr double ROUNDING = 1e-9;
    if (!toEigen(vectors.rvec).allFinite() || !toEigen(vectors.tvec).allFinite())
        return false;
    if (ours && toEigen(vectors.rvec).norm() > CV_PI + ROUNDING)
        return false;
    const Matrix3d R = expSO3(toEigen(vectors.rvec));
    return (R.transpose() * R - Matrix3d::Identity()).norm() < ROUNDING && R.determinant() > 0;
}

bool isCovariance(const cv::Mat& m, int size)
{
    constexpr double ROUNDING = 1e-6;  // relative, of the correlations
    if (m.empty())
        return true;
    if (m.rows != size || m.cols != size || m.type() != CV_64F)
        return false;
    const Eigen::Map<const Eigen::MatrixXd> C(m.ptr<double>(), size, size);
    if (!C.allFinite() || C != C.transpose() || C.diagonal().minCoeff() < 0)
        return false;
    const Eigen::VectorXd unit = C.diagonal().cwiseMax(std::numeric_limits<double>::min()).cwiseSqrt().cwiseInverse();
    const Eigen::MatrixXd correlation = unit.asDiagonal() * C * unit.asDiagonal();
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(correlation).eigenvalues()(0) > -ROUNDING;
}

bool isComplete(const Result& result, int n)
{
    return std::isfinite(result.cost) && toEigen(result.cameraCenter).allFinite() &&
           isCovariance(result.poseCovariance, 6) && isCovariance(result.poseCovarianceRt, 6) &&
           isCovariance(result.cameraCenterCovariance, 3) && isCovariance(result.objectNoise, 3) &&
           isCovariance(result.bearingNoise, 3) && result.weights.rows == n &&
           cv::checkRange(result.weights, true, nullptr, 0, DBL_MAX) && result.tailDof > 0 &&
           result.noiseEvidence >= 0 && !std::isnan(result.poseEvidence) && result.usedPoints == n &&
           (result.status == cv::gmlpnp::STATUS_CONVERGED || result.status == cv::gmlpnp::STATUS_MAX_ROUNDS);
}

Solver rays(const std::string& name, int method)
{
    return {name, method, true, false, true, [method](const Problem& problem, Outputs& outputs) {
                cv::gmlpnp::Params params;
                params.method = method;
                params.useExtrinsicGuess = problem.hasGuess();
                params.rvec = problem.rvec;
                params.tvec = problem.tvec;
                return cv::gmlpnp::solveRays(problem.points, problem.rays, outputs.result, params);
            }};
}

Solver pixels(const std::string& name, bool ours, int flag)
{
    return {name, flag, ours, true, false, [flag](const Problem& problem, Outputs& outputs) {
                return cv::gmlpnp::solvePnP(problem.points, problem.pixels, synthetic::paperCamera(), cv::noArray(),
                                            outputs.rvec, outputs.tvec, problem.hasGuess(), flag);
            }};
}

}  // namespace

const std::vector<Solver>& allSolvers()
{
    using namespace cv::gmlpnp;
    static const std::vector<Solver> solvers = {rays("solveRays, GMLPNP_MARGINAL", SOLVEPNP_GMLPNP_MARGINAL),
                                                pixels("solvePnP, GMLPNP_MARGINAL", true, SOLVEPNP_GMLPNP_MARGINAL),
                                                rays("solveRays, GMLPNP", SOLVEPNP_GMLPNP),
                                                pixels("solvePnP, GMLPNP", true, SOLVEPNP_GMLPNP),
                                                pixels("cv::solvePnP, EPNP", false, cv::SOLVEPNP_EPNP),
                                                pixels("cv::solvePnP, ITERATIVE", false, cv::SOLVEPNP_ITERATIVE),
                                                pixels("cv::solvePnP, SQPNP", false, cv::SOLVEPNP_SQPNP)};
    return solvers;
}

Verdict judge(const Solver& solver, const Problem& problem)
{
    constexpr double LOST = 0.5;  // rad
    Verdict verdict;
    if (solver.wantsPixels && problem.shape == Shape::AROUND)
        return verdict;
    verdict.called = true;
    Vectors before;
    Outputs outputs = outputsFor(problem, before);
    const cv::Mat_<double> points = problem.points.clone(),
                           images = (solver.wantsPixels ? problem.pixels : problem.rays).clone();
    try {
        verdict.solved = solver.solve(problem, outputs);
    } catch (const cv::Exception&) {
        verdict.threw = true;
    } catch (...) {
        verdict.foreignException = true;
    }
    verdict.inputChanged =
        !same(points, problem.points) || !same(images, solver.wantsPixels ? problem.pixels : problem.rays);
    const Vectors after = vectorsOf(solver, outputs);
    verdict.refused = !verdict.solved && problem.solvable();
    if (!verdict.solved) {
        verdict.outputTouched = !same(before.rvec, after.rvec) || !same(before.tvec, after.tvec);
        return verdict;
    }
    verdict.badPose = !isPose(after, solver.ours);
    verdict.badResult = solver.fullResult && !isComplete(outputs.result, problem.n);
    verdict.pose = {expSO3(toEigen(after.rvec)), toEigen(after.tvec)};
    verdict.lost = problem.solvable() && !(synthetic::rotationAngle(verdict.pose.R, problem.truth.R) < LOST);
    return verdict;
}

}  // namespace reliability
