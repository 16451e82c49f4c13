// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../../src/ransac/p3p.hpp"
#include "../scenes.hpp"
#include "../statistics.hpp"

namespace opencv_test {
namespace {

using cv::gmlpnp::detail::p3p;
using cv::gmlpnp::detail::Triple;

// Three points seen from a known pose.
struct Problem
{
    Triple points, rays;
    Pose truth;
};

Problem problemOf(cv::RNG& rng, const Triple& cameraPoints)
{
    Problem problem;
    problem.truth = {randomRotation(rng), gaussian3(rng)};
    for (int i = 0; i < 3; ++i) {
        problem.points[i] = problem.truth.R.transpose() * (cameraPoints[i] - problem.truth.t);
        problem.rays[i] = cameraPoints[i].normalized();
    }
    return problem;
}

std::vector<Pose> solutions(const Problem& problem)
{
    std::array<Pose, 4> poses;
    return {poses.begin(), poses.begin() + p3p(problem.points, problem.rays, poses)};
}

// Sine of the largest angle between a ray and its point; 2 where a point lies behind.
double misalignment(const Problem& problem, const Pose& pose)
{
    double worst = 0;
    for (int i = 0; i < 3; ++i) {
        const Vector3d X = (pose * problem.points[i]).normalized();
        worst = std::max(worst, X.dot(problem.rays[i]) > 0 ? X.cross(problem.rays[i]).norm() : 2);
    }
    return worst;
}

double distance(const Pose& a, const Pose& b)
{
    return rotationAngle(a.R, b.R) + (a.t - b.t).norm();
}

double nearest(const std::vector<Pose>& poses, const Pose& truth)
{
    double least = std::numeric_limits<double>::infinity();
    for (const Pose& pose : poses)
        least = std::min(least, distance(pose, truth));
    return least;
}

// How well three points hold the pose, against one on the danger cylinder or on a line: rounding divided by this.
double conditioning(const Problem& problem)
{
    Matrix3d J = Matrix3d::Zero();  // of half the squared distances, by the depths
    double s[3];
    for (int i = 0; i < 3; ++i)
        s[i] = (problem.truth * problem.points[i]).norm();
    const int pairs[3][2] = {{0, 1}, {0, 2}, {1, 2}};
    for (int k = 0; k < 3; ++k) {
        const int i = pairs[k][0], j = pairs[k][1];
        const Vector3d d = (s[i] * problem.rays[i] - s[j] * problem.rays[j]).normalized();
        J(k, i) = d.dot(problem.rays[i]);
        J(k, j) = -d.dot(problem.rays[j]);
    }
    return std::sqrt(std::max(0., Eigen::SelfAdjointEigenSolver<Matrix3d>(J.transpose() * J).eigenvalues()(0)));
}

constexpr double ILL = 1e-3;  // conditioning below which digits are lost

TEST(Gmlpnp_P3p, findsTheTruthInEveryDirection)
{
    cv::RNG rng = testRng();
    int judged = 0;
    for (int trial = 0; trial < 20000; ++trial) {
        const std::vector<Vector3d> points = surroundingPoints(rng, 3);
        const Problem problem = problemOf(rng, {points[0], points[1], points[2]});
        const std::vector<Pose> poses = solutions(problem);
        for (const Pose& pose : poses)
            ASSERT_LT(misalignment(problem, pose), 1e-7) << "trial " << trial;
        if (conditioning(problem) < ILL)
            continue;
        ++judged;
        ASSERT_LT(nearest(poses, problem.truth), 1e-8) << "trial " << trial << " of " << poses.size() << " poses";
    }
    EXPECT_GT(judged, 19000);
}

TEST(Gmlpnp_P3pStatistics, findsTheTruthInNarrowViews)
{
    cv::RNG rng = testRng();
    int lost = 0;
    constexpr int TRIALS = 5000;
    for (int trial = 0; trial < TRIALS; ++trial) {
        const Vector3d centre = 1000 * gaussian3(rng).normalized();  // a milliradian of field
        const Problem problem =
            problemOf(rng, {centre + gaussian3(rng), centre + gaussian3(rng), centre + gaussian3(rng)});
        const std::vector<Pose> poses = solutions(problem);
        for (const Pose& pose : poses)
            ASSERT_LT(misalignment(problem, pose), 1e-7) << "trial " << trial;
        lost += !(nearest(poses, problem.truth) < 1e-3);
    }
    // The camera is on the danger cylinder of one in so many thousand of such triangles.
    EXPECT_TRUE(shareAtMost(lost, TRIALS, 0.0004));
}

TEST(Gmlpnp_P3p, agreesWithOpenCV)
{
    cv::RNG rng = testRng();
    int compared = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        const std::vector<Vector3d> points = boxPoints(rng, 3);
        const Problem problem = problemOf(rng, {points[0], points[1], points[2]});
        cv::Mat_<double> objectPoints(3, 3), pixels(3, 2);
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 3; ++k) {
                objectPoints(i, k) = problem.points[i](k);
                if (k < 2)
                    pixels(i, k) = problem.rays[i](k) / problem.rays[i].z();
            }
        std::vector<cv::Vec3d> rvecs, tvecs;
        cv::solveP3P(objectPoints, pixels, cv::Matx33d::eye(), cv::noArray(), rvecs, tvecs, cv::SOLVEPNP_AP3P);
        const std::vector<Pose> ours = solutions(problem);
        for (size_t k = 0; k < rvecs.size(); ++k) {
            const Pose theirs = poseOf(rvecs[k], tvecs[k]);
            if (misalignment(problem, theirs) > 1e-9)  // not each of theirs is a solution
                continue;
            ++compared;
            EXPECT_LT(nearest(ours, theirs), 1e-4) << "trial " << trial;
        }
    }
    EXPECT_GT(compared, 2000);
}

TEST(Gmlpnp_P3p, symmetricTriangles)
{
    // Both conics of the pencil are pairs of lines here, and two of the poses may be one.
    cv::RNG rng = testRng();
    for (const double height : {0.5, 1., 2., 10.}) {
        const double s = std::sqrt(0.75);
        const Problem problem =
            problemOf(rng, {Vector3d(1, 0, height), Vector3d(-0.5, s, height), Vector3d(-0.5, -s, height)});
        EXPECT_LT(nearest(solutions(problem), problem.truth), 1e-6) << "height " << height;
    }
    for (int trial = 0; trial < 100; ++trial) {
        const double a = rng.uniform(0.2, 2.), b = rng.uniform(0.2, 2.), z = rng.uniform(1., 5.);
        const Problem problem = problemOf(rng, {Vector3d(a, -b, z), Vector3d(-a, -b, z), Vector3d(0, b, z)});
        if (conditioning(problem) > ILL) {
            EXPECT_LT(nearest(solutions(problem), problem.truth), 1e-7) << "trial " << trial;
        }
    }
}

class Gmlpnp_ThinTriangleStatistics : public testing::TestWithParam<double>
{};

TEST_P(Gmlpnp_ThinTriangleStatistics, findsTheTruth)
{
    constexpr int TRIALS = 1000;
    const double thinness = GetParam();
    cv::RNG rng = testRng();
    int lost = 0;
    for (int trial = 0; trial < TRIALS; ++trial) {
        const std::vector<Vector3d> points = surroundingPoints(rng, 3);
        const Vector3d third = 0.5 * (points[0] + points[1]) + thinness * points[2];
        const Problem problem = problemOf(rng, {points[0], points[1], third});
        const std::vector<Pose> poses = solutions(problem);
        for (const Pose& pose : poses)
            ASSERT_TRUE(pose.R.allFinite() && pose.t.allFinite());
        lost += !(nearest(poses, problem.truth) < 1e-8 / (thinness * thinness));
    }
    EXPECT_TRUE(shareAtMost(lost, TRIALS, 0.002));
}

INSTANTIATE_TEST_SUITE_P(/**/, Gmlpnp_ThinTriangleStatistics, testing::Values(1e-2, 1e-4, 1e-6), nameOfNumber);

TEST(Gmlpnp_P3p, cameraOnTheDangerCylinder)
{
    // Right above a corner of the triangle's circumcircle two poses are one: half of the digits remain.
    cv::RNG rng = testRng();
    for (int trial = 0; trial < 200; ++trial) {
        Triple points;
        for (Vector3d& p : points) {
            const double angle = rng.uniform(0., 2 * CV_PI);
            p = Vector3d(std::cos(angle) - 1, std::sin(angle), 3);  // the camera stands above (-1, 0) of the circle
        }
        const Problem problem = problemOf(rng, points);
        const double thickness = (points[1] - points[0]).cross(points[2] - points[0]).norm();
        if (thickness > 0.1) {
            EXPECT_LT(nearest(solutions(problem), problem.truth), 1e-3) << "trial " << trial;
        }
    }
}

TEST(Gmlpnp_P3p, impossibleTriplesGiveNothingOrSomethingExact)
{
    cv::RNG rng = testRng();
    const Vector3d p = gaussian3(rng), q = gaussian3(rng), m = gaussian3(rng).normalized();
    std::array<Pose, 4> poses;
    EXPECT_EQ(0, p3p({p, p, p}, {m, m, m}, poses));
    for (int trial = 0; trial < 2000; ++trial) {
        Problem problem;
        for (int i = 0; i < 3; ++i) {
            problem.points[i] = trial % 2 ? gaussian3(rng) : Vector3d(p + rng.uniform(-1., 1.) * q);
            problem.rays[i] = gaussian3(rng).normalized();
        }
        for (const Pose& pose : solutions(problem)) {
            const bool exact = trial % 2 == 0 || misalignment(problem, pose) < 1e-6;
            EXPECT_TRUE(exact) << "trial " << trial;  // points on a line leave the turn around it open
        }
    }
}

}  // namespace
}  // namespace opencv_test
