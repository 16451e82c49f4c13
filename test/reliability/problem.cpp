// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "problem.hpp"

#include "src/math/spd3.hpp"
#include "trials.hpp"

namespace reliability {

namespace {

using cv::gmlpnp::detail::expSO3;
using cv::gmlpnp::detail::hat;
using cv::gmlpnp::detail::logSO3;
using cv::gmlpnp::detail::Matrix6d;
using cv::gmlpnp::detail::UnitDiagonal;
using cv::gmlpnp::detail::Vector6d;

constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();
constexpr double INFINITE = std::numeric_limits<double>::infinity();

double logUniform(cv::RNG& rng, double low, double high)
{
    return std::exp(rng.uniform(std::log(low), std::log(high)));
}

bool happens(cv::RNG& rng, double probability)
{
    return rng.uniform(0., 1.) < probability;
}

// Zero in a quarter of the problems.
double level(cv::RNG& rng, double low, double high)
{
    return happens(rng, 0.25) ? 0 : logUniform(rng, low, high);
}

Vector3d cubePoint(cv::RNG& rng)
{
    const double x = rng.uniform(-1., 1.), y = rng.uniform(-1., 1.), z = rng.uniform(-1., 1.);
    return {x, y, z};
}

Vector3d direction(cv::RNG& rng)
{
    return synthetic::gaussian3(rng).normalized();
}

// How thick the shape is along its three axes; a few of them matter most.
Vector3d axesOf(const Problem& problem)
{
    switch (problem.shape) {
        case Shape::FLAT:
            return {1, 1, 0};
        case Shape::NEARLY_FLAT:
            return {1, 1, problem.thickness};
        case Shape::LINE:
            return {1, 0, 0};
        case Shape::NEARLY_LINE:
            return {1, problem.thickness, problem.thickness};
        default:
            return {1, 1, 1};
    }
}

void drawConditions(cv::RNG& rng, Problem& problem)
{
    constexpr int FEW = 20;
    problem.n = happens(rng, 0.5) ? rng.uniform(0, FEW) : rng.uniform(0, 201);
    problem.shape = static_cast<Shape>(rng.uniform(0, SHAPES));
    problem.scale = logUniform(rng, 1e-6, 1e9);
    problem.offset = happens(rng, 0.5) ? 0 : logUniform(rng, 1, 1e8);
    problem.thickness = logUniform(rng, 1e-9, 0.1);
    problem.objectNoise = level(rng, 1e-12, 3);
    problem.rayNoise = level(rng, 1e-12, 1);
    problem.outliers = happens(rng, 0.7) ? 0 : rng.uniform(0., 1.);
    problem.corrupt = happens(rng, 0.02);
    problem.guess = happens(rng, 0.6) ? Guess::NONE : static_cast<Guess>(rng.uniform(1, 4));
    if (problem.guess == Guess::NOT_FINITE && happens(rng, 0.9))
        problem.guess = Guess::WRONG;
}

// The object as the camera sees it, in sizes of the object.
struct View
{
    Matrix3d R;
    Vector3d centre;          // of the object
    std::vector<Vector3d> X;  // camera frame
};

View drawView(cv::RNG& rng, Problem& problem)
{
    View view{synthetic::randomRotation(rng), {}, std::vector<Vector3d>(problem.n)};
    problem.distance = logUniform(rng, 2.5, 1e3);
    const double y = rng.uniform(-0.5, 0.5), x = rng.uniform(-0.5, 0.5);
    view.centre = Vector3d(x, y, 1).normalized() * problem.distance;
    const Matrix3d shape = view.R * axesOf(problem).asDiagonal();
    const bool repeated = problem.shape == Shape::REPEATED && problem.n > 0;
    problem.places = repeated ? rng.uniform(1, problem.n + 1) : problem.n;
    for (int i = 0; i < problem.n; ++i)
        view.X[i] = i < problem.places ? Vector3d(view.centre + shape * cubePoint(rng))
                                       : view.X[rng.uniform(0, problem.places)];
    if (problem.shape == Shape::AROUND) {
        problem.distance = 1;
        const double away = rng.uniform(0., 1.);
        view.centre = away * direction(rng);
        for (Vector3d& X : view.X) {
            X = direction(rng);
            X *= logUniform(rng, 0.3, 3);
        }
    }
    return view;
}

double largestDeviation(const Matrix3d& covariance)
{
    return std::sqrt(Eigen::SelfAdjointEigenSolver<Matrix3d>(covariance).eigenvalues()(2));
}

// From isotropic noise of both kinds and the rounding of coordinates far from the origin.
void assess(const View& view, Problem& problem)
{
    constexpr double EPSILON = std::numeric_limits<double>::epsilon(), SINGULAR = 1e-18;
    const double object = problem.objectNoise + EPSILON * (1 + problem.offset);
    Matrix6d H = Matrix6d::Zero();
    for (const Vector3d& X : view.X) {
        Eigen::Matrix<double, 3, 6> J;
        J << -hat(X - view.centre), problem.distance * Matrix3d::Identity();
        const Vector3d m = X.normalized();
        const double ray = (problem.rayNoise + EPSILON) * X.norm();
        H += J.transpose() * (Matrix3d::Identity() - m * m.transpose()) * J / (object * object + ray * ray);
    }
    const UnitDiagonal unit(H);
    const Eigen::SelfAdjointEigenSolver<Matrix6d> eigen(unit.matrix);
    const Vector6d lambda = eigen.eigenvalues().cwiseMax(SINGULAR);
    problem.condition = lambda(5) / lambda(0);
    const Matrix6d scaled = unit.scale.asDiagonal() * eigen.eigenvectors();
    const Matrix6d covariance = scaled * lambda.cwiseInverse().asDiagonal() * scaled.transpose();
    problem.rotationDeviation = largestDeviation(covariance.topLeftCorner<3, 3>());
    problem.centreDeviation = largestDeviation(covariance.bottomRightCorner<3, 3>());
}

// A pinhole sees what is behind it mirrored, on the ray of the opposite direction.
Vector3d asSeen(const Problem& problem, const Vector3d& m)
{
    return problem.shape != Shape::AROUND && m.z() < 0 ? Vector3d(-m) : m;
}

Vector3d drawRay(cv::RNG& rng, const Problem& problem, const Vector3d& X)
{
    const bool wrong = happens(rng, problem.outliers) || problem.shape == Shape::UNRELATED;
    const Vector3d noisy = X.normalized() + problem.rayNoise * synthetic::gaussian3(rng);
    return asSeen(problem, wrong ? direction(rng) : Vector3d(noisy.normalized()));
}

void setRow(cv::Mat_<double>& m, int row, const Vector3d& v)
{
    for (int k = 0; k < m.cols; ++k)
        m(row, k) = v(k);
}

void observe(cv::RNG& rng, const View& view, Problem& problem)
{
    const int n = problem.n;
    problem.centre = problem.scale * problem.offset * direction(rng);
    problem.truth = {view.R, problem.scale * view.centre - view.R * problem.centre};
    problem.points.create(n, 3);
    problem.rays.create(n, 3);
    if (problem.shape != Shape::AROUND)
        problem.pixels.create(n, 2);
    const double behind = problem.shape == Shape::BEHIND ? rng.uniform(0., 1.) : 0;
    const Matrix3d L = Matrix3d(synthetic::randomNoise(rng, 1).llt().matrixL()) * problem.objectNoise;
    const cv::Matx33d K = synthetic::paperCamera();
    for (int i = 0; i < n; ++i) {
        const Vector3d X = happens(rng, behind) ? Vector3d(-view.X[i]) : view.X[i];
        const Vector3d m = drawRay(rng, problem, X);
        setRow(problem.rays, i, m);
        if (!problem.pixels.empty())
            setRow(problem.pixels, i, {K(0, 0) * m.x() / m.z() + K(0, 2), K(1, 1) * m.y() / m.z() + K(1, 2), 0});
        const Vector3d p = view.R.transpose() * (X - view.centre) + L * synthetic::gaussian3(rng);
        setRow(problem.points, i, problem.scale * p + problem.centre);
    }
}

void corruptOne(cv::RNG& rng, Problem& problem)
{
    const double values[] = {NOT_A_NUMBER, INFINITE, -INFINITE, 1e155, -1e200, 1e308, 5e-324, 0};
    const double value = values[rng.uniform(0, static_cast<int>(std::size(values)))];
    const int row = rng.uniform(0, problem.n);
    if (happens(rng, 0.5)) {
        problem.points(row, rng.uniform(0, 3)) = value;
        return;
    }
    problem.rays(row, rng.uniform(0, 3)) = value;
    if (!problem.pixels.empty())
        problem.pixels(row, rng.uniform(0, 2)) = value;
}

void drawGuess(cv::RNG& rng, Problem& problem)
{
    Pose pose = problem.truth;
    const double size = problem.scale * problem.distance;
    if (problem.guess == Guess::NEAR) {
        const Vector3d phi = 0.1 * direction(rng);
        pose.R = expSO3(phi) * pose.R;
        pose.t = problem.truth * problem.centre + 0.1 * size * direction(rng) - pose.R * problem.centre;
    } else {
        pose.R = synthetic::randomRotation(rng);
        pose.t = direction(rng);
        pose.t *= size * logUniform(rng, 1e-6, 1e9);
    }
    const Vector3d r = logSO3(pose.R);
    problem.rvec = {r.x(), r.y(), r.z()};
    problem.tvec = {pose.t.x(), pose.t.y(), pose.t.z()};
    if (problem.guess == Guess::WRONG && happens(rng, 0.1))
        problem.rvec *= 1000;  // many turns
    if (problem.guess == Guess::NOT_FINITE)
        (happens(rng, 0.5) ? problem.rvec : problem.tvec)[rng.uniform(0, 3)] =
            happens(rng, 0.5) ? NOT_A_NUMBER : INFINITE;
}

}  // namespace

bool Problem::solvable() const
{
    constexpr int FEWEST = 6, FEWEST_PLACES = 4;
    constexpr double CONDITION = 1e6, DEVIATION = 0.05;
    return n >= FEWEST && places >= FEWEST_PLACES && condition <= CONDITION && rotationDeviation <= DEVIATION &&
           centreDeviation <= DEVIATION && outliers == 0 && !corrupt && shape != Shape::BEHIND &&
           shape != Shape::UNRELATED && (guess == Guess::NONE || guess == Guess::NEAR);
}

Problem randomProblem(int seed, int index)
{
    cv::RNG rng = experiments::trialRng("reliability", seed, index);
    Problem problem;
    drawConditions(rng, problem);
    const View view = drawView(rng, problem);
    if (problem.n > 0)
        assess(view, problem);
    observe(rng, view, problem);
    if (problem.hasGuess())
        drawGuess(rng, problem);
    if (problem.corrupt && problem.n > 0)
        corruptOne(rng, problem);
    return problem;
}

std::string nameOf(Shape shape)
{
    constexpr const char* NAMES[SHAPES] = {"solid",    "flat",   "nearly flat", "line",     "nearly line",
                                           "repeated", "behind", "around",      "unrelated"};
    return NAMES[static_cast<int>(shape)];
}

std::string nameOf(Guess guess)
{
    constexpr const char* NAMES[] = {"none", "near", "wrong", "not finite"};
    return NAMES[static_cast<int>(guess)];
}

}  // namespace reliability
