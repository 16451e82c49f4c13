// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "experiments.hpp"

// What becomes of the estimated covariance: over the rounds, with the number of points, and in one case drawn.

namespace experiments {

namespace {

using cv::gmlpnp::Params;
using cv::gmlpnp::Result;

// The two estimators, and the marginal one told that there is no bearing noise, as the published one assumes.
struct Estimator
{
    std::string name;
    int method;
    bool objectOnly;
};
const Estimator ESTIMATORS[] = {{"GMLPnP", cv::gmlpnp::SOLVEPNP_GMLPNP, false},
                                {"GMLPnP marginal", cv::gmlpnp::SOLVEPNP_GMLPNP_MARGINAL, false},
                                {"GMLPnP marginal, object noise only", cv::gmlpnp::SOLVEPNP_GMLPNP_MARGINAL, true}};
constexpr size_t COUNT = std::size(ESTIMATORS);

Params paramsOf(const Estimator& estimator)
{
    Params params;
    params.method = estimator.method;
    params.robust = false;
    if (estimator.objectOnly)
        params.bearingNoise = cv::Mat::zeros(3, 3, CV_64F);
    return params;
}

// What is recorded of one estimate; not a number: no pose.
struct Estimate
{
    double determinant, frobenius, smallestDeviation, rotation, translation;
};

using Field = double Estimate::*;

Estimate estimate(const Problem& problem, const Params& params)
{
    constexpr double NONE = std::numeric_limits<double>::quiet_NaN();
    const std::optional<Result> result = solved(problem, params);
    if (!result)
        return {NONE, NONE, NONE, NONE, NONE};
    const Matrix3d Sigma = matrixOf(result->objectNoise);
    const PoseErrors errors = errorsOf(poseOf(*result), problem.scene.truth);
    const double smallest = cv::gmlpnp::detail::Eigen3d(Sigma, Eigen::EigenvaluesOnly).eigenvalues()(0);
    return {Sigma.determinant(), (Sigma - problem.scene.Sigma).norm(), std::sqrt(std::max(0., smallest)),
            errors.rotation, errors.translation};
}

std::vector<double> valuesOf(const std::vector<Estimate>& estimates, Field field)
{
    std::vector<double> values;
    for (const Estimate& e : estimates)
        values.push_back(e.*field);
    return values;
}

std::vector<std::string> roundColumns()
{
    return std::vector<std::string>{"round", "estimator", "trials"} + intervalColumns("determinant") +
           std::vector<std::string>{"determinant_median"} + intervalColumns("frobenius") +
           std::vector<std::string>{"smallest_deviation_median"} + intervalColumns("rotation_deg") +
           intervalColumns("translation_percent") + std::vector<std::string>{"true_determinant"};
}

std::string quoted(const std::string& name)
{
    return "\"" + name + "\"";
}

}  // namespace

void runRounds(const Settings& settings)
{
    constexpr int ROUNDS = 12, POINTS = 200;
    constexpr double SIGMA = 0.5, PIXELS = 5;
    const int trials = settings.trials;
    Progress progress("rounds", static_cast<long>(ROUNDS) * trials);
    Csv csv(settings.folder, "rounds", roundColumns());
    for (int round = 1; round <= ROUNDS; ++round) {
        std::vector<std::vector<Estimate>> estimates(COUNT, std::vector<Estimate>(trials));
        std::vector<double> truth(trials);
        forTrials(trials, settings.threads, progress, [&](int k) {
            cv::RNG rng = trialRng("rounds", 0, k);  // the same problems in every round
            const Problem problem = paperProblem(POINTS, SIGMA, PIXELS)(rng);
            truth[k] = problem.scene.Sigma.determinant();
            for (size_t e = 0; e < COUNT; ++e) {
                Params params = paramsOf(ESTIMATORS[e]);
                params.maxRounds = round;
                params.tolerance = 0;
                estimates[e][k] = estimate(problem, params);
            }
        });
        const Bootstrap bootstrap(trials);
        for (size_t e = 0; e < COUNT; ++e) {
            const auto values = [&](Field field) { return valuesOf(estimates[e], field); };
            csv << round << quoted(ESTIMATORS[e].name) << trials << bootstrap.mean(values(&Estimate::determinant))
                << median(values(&Estimate::determinant)) << bootstrap.mean(values(&Estimate::frobenius))
                << median(values(&Estimate::smallestDeviation)) << bootstrap.mean(values(&Estimate::rotation))
                << bootstrap.mean(values(&Estimate::translation)) << bootstrap.mean(truth).value;
            csv.endRow();
        }
    }
    csv.save();
}

void runCovariance(const Settings& settings)
{
    const int sizes[] = {20, 50, 100, 200, 500, 1000, 2000};
    const double sigmas[] = {0.1, 0.5};
    const int trials = settings.trials;
    Progress progress("covariance", static_cast<long>(std::size(sizes) * std::size(sigmas)) * trials);
    Csv csv(settings.folder, "covariance",
            std::vector<std::string>{"sigma_m", "x", "estimator", "trials"} + intervalColumns("relative_frobenius"));
    for (const double sigma : sigmas)
        for (const int n : sizes) {
            std::vector<std::vector<double>> error(COUNT, std::vector<double>(trials));
            forTrials(trials, settings.threads, progress, [&](int k) {
                cv::RNG rng = trialRng("covariance", cvRound(1e5 * sigma) + n, k);
                const Problem problem = paperProblem(n, sigma, 10 * sigma)(rng);
                for (size_t e = 0; e < COUNT; ++e)
                    error[e][k] = estimate(problem, paramsOf(ESTIMATORS[e])).frobenius / problem.scene.Sigma.norm();
            });
            const Bootstrap bootstrap(trials);
            for (size_t e = 0; e < COUNT; ++e) {
                csv << sigma << n << quoted(ESTIMATORS[e].name) << trials << bootstrap.mean(error[e]);
                csv.endRow();
            }
        }
    csv.save();
}

namespace {

// The residual of a point in the object frame, S-orthogonal to its ray: the share of its object noise in what a free
// depth leaves,  e = Sigma R^T z,  z = (S v) x m / D  (doc/theory.md).
Vector3d residual(const Problem& problem, int i, const Result& result)
{
    const Pose pose = poseOf(result);
    const Matrix3d Sigma = matrixOf(result.objectNoise);
    const Vector3d X = pose * problem.data.points.col(i), m = problem.data.rays.col(i), v = m.cross(X);
    const double s = m.dot(X);
    const Matrix3d S = pose.R * Sigma * pose.R.transpose() + s * s * matrixOf(result.bearingNoise);
    const double D = m.dot(cv::gmlpnp::detail::adjugate(S) * m);
    return Sigma * pose.R.transpose() * (S * v).cross(m) / D;
}

void writeVector(Csv& csv, const std::string& kind, const Vector3d& e)
{
    csv << kind << e.x() << e.y() << e.z();
    csv.endRow();
}

void writeCovariance(Csv& csv, const std::string& kind, const Matrix3d& C)
{
    csv << kind;
    for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b)
            csv << C(a, b);
    csv.endRow();
}

}  // namespace

void runCase(const Settings& settings)
{
    constexpr int POINTS = 200;
    Progress progress("case", 1);
    cv::RNG rng = trialRng("case", 0, 0), exactRng = rng;
    const Problem problem = paperProblem(POINTS, 0.5, 5)(rng);
    const Scene exact = synthetic::exactScene(exactRng, synthetic::boxPoints(exactRng, POINTS));  // the same draws
    Csv points(settings.folder, "case", {"kind", "x", "y", "z"});
    Csv covariances(settings.folder, "case_covariances",
                    {"kind", "xx", "xy", "xz", "yx", "yy", "yz", "zx", "zy", "zz"});
    for (int i = 0; i < POINTS; ++i)
        writeVector(points, "noise",
                    problem.data.points.col(i) - Eigen::Map<const Vector3d>(exact.objectPoints.ptr<double>(i)));
    writeCovariance(covariances, "noise", problem.scene.Sigma);
    for (size_t e = 0; e < 2; ++e) {
        const std::optional<Result> result = solved(problem, paramsOf(ESTIMATORS[e]));
        if (!result)
            throw std::runtime_error("case: " + ESTIMATORS[e].name + " found no pose");
        for (int i = 0; i < POINTS; ++i)
            writeVector(points, ESTIMATORS[e].name, residual(problem, i, *result));
        writeCovariance(covariances, ESTIMATORS[e].name, matrixOf(result->objectNoise));
    }
    points.save();
    covariances.save();
    progress.step();
}

}  // namespace experiments
