// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

// Compilers and instruction sets agree: every build finds the poses that poses.csv holds. `test_agreement --write`
// writes it anew, which is due where the solver's figures were meant to change.

#include <gtest/gtest.h>

#include <iostream>

#include "common/output_file.hpp"
#include "same_pose.hpp"

namespace {

using namespace reliability;
using cv::gmlpnp::CameraModel;
using cv::gmlpnp::Params;
using cv::gmlpnp::Result;
using synthetic::poseOf;

struct Case
{
    std::string name;
    Pose pose;
    Vector3d centre = Vector3d::Zero();  // of the object
    double bound = 1e-9;
};

// Hostile problems of up to 200 points, by rays and by pixels, both methods.
void addSweep(std::vector<Case>& cases)
{
    constexpr int SEED = 1, PROBLEMS = 1000;
    for (int index = 0; index < PROBLEMS; ++index) {
        const Problem problem = randomProblem(SEED, index);
        for (const Solver& solver : allSolvers()) {
            if (!solver.ours || !roundingIsSmall(solver, problem))
                continue;
            const Verdict verdict = judge(solver, problem);
            if (verdict.solved)
                cases.push_back({solver.name + ", problem " + std::to_string(index), verdict.pose, problem.centre,
                                 roundingBound(problem)});
        }
    }
}

// Many points, where parts of them do most of the work; RANSAC; lenses beyond a pinhole.
void addScenes(std::vector<Case>& cases)
{
    cv::RNG rng(5);
    const cv::Matx33d K = synthetic::paperCamera();
    for (const int n : {250, 1000, 6000})
        for (const int method : {cv::gmlpnp::SOLVEPNP_GMLPNP, cv::gmlpnp::SOLVEPNP_GMLPNP_MARGINAL}) {
            const synthetic::Scene scene = synthetic::paperScene(rng, n, 0.05, 1);
            cv::Vec3d rvec, tvec;
            EXPECT_TRUE(cv::gmlpnp::solvePnP(scene.objectPoints, scene.imagePoints, K, cv::noArray(), rvec, tvec, false,
                                             method));
            cases.push_back({std::to_string(n) + " points, method " + std::to_string(method), poseOf(rvec, tvec)});
        }
    for (int k = 0; k < 10; ++k) {
        synthetic::Scene scene = synthetic::paperScene(rng, 100, 0.01, 1);
        for (int i = 0; i < 30; ++i)
            scene.imagePoints(i, 0) = rng.uniform(0., 640.);
        Result result;
        EXPECT_TRUE(
            cv::gmlpnp::solveRansac(scene.objectPoints, scene.imagePoints, K, cv::noArray(), result, cv::noArray()));
        cases.push_back({"RANSAC " + std::to_string(k), poseOf(result.rvec, result.tvec)});
    }
    const cv::Ptr<CameraModel> lenses[] = {CameraModel::fisheye(K, cv::Vec4d(0.05, -0.01, 0.002, -0.001)),
                                           CameraModel::omnidir(K, cv::Vec4d(-0.1, 0.01, 0.001, 0.002), 1.1),
                                           CameraModel::doubleSphere(K, -0.2, 0.55)};
    for (size_t k = 0; k < std::size(lenses); ++k) {
        synthetic::Scene scene = synthetic::exactScene(rng, synthetic::boxPoints(rng, 40));
        synthetic::disturb(rng, scene, 0.02, 1, *lenses[k]);
        Result result;
        EXPECT_TRUE(cv::gmlpnp::solve(scene.objectPoints, scene.imagePoints, lenses[k], result));
        cases.push_back({"lens " + std::to_string(k), poseOf(result.rvec, result.tvec)});
    }
}

std::vector<Case> solvedHere()
{
    std::vector<Case> cases;
    addSweep(cases);
    addScenes(cases);
    return cases;
}

const std::string& fileName()
{
    static const std::string name = std::string(GMLPNP_SOURCE_DIR) + "/test/reliability/poses.csv";
    return name;
}

void write()
{
    files::writeFile(fileName(), [](std::ostream& out) {
        out << std::setprecision(17);
        for (const Case& solved : solvedHere()) {
            const Vector3d r = cv::gmlpnp::detail::logSO3(solved.pose.R), t = solved.pose.t;
            out << solved.name;
            for (const Vector3d& v : {r, t})
                for (int k = 0; k < 3; ++k)
                    out << "; " << v(k);
            out << "\n";
        }
    });
}

Case read(std::istream& in)
{
    Case expected;
    std::getline(in, expected.name, ';');
    cv::Vec3d v[2];
    char separator = ';';
    for (int k = 0; k < 6; ++k) {
        in >> v[k / 3][k % 3];
        if (k < 5)
            in >> separator;
    }
    std::string end;
    std::getline(in, end);
    expected.pose = poseOf(v[0], v[1]);
    return expected;
}

TEST(Agreement, withThePosesOfOtherBuilds)
{
    std::ifstream file(fileName());
    double worst = 0;
    const std::vector<Case> cases = solvedHere();
    EXPECT_GT(cases.size(), 100u);
    for (const Case& here : cases) {
        const Case there = read(file);
        ASSERT_TRUE(file) << "poses.csv ends before " << here.name;
        ASSERT_EQ(there.name, here.name);
        const double deviation = apart(here.centre, there.pose, here.pose);
        EXPECT_LE(deviation, here.bound) << here.name;
        worst = std::max(worst, deviation / here.bound);
    }
    std::cout << cases.size() << " poses, at most " << worst << " of the bound\n";
}

}  // namespace

int main(int argc, char** argv)
{
    testing::InitGoogleTest(&argc, argv);
    if (argc == 2 && std::string(argv[1]) == "--write") {
        write();
        return 0;
    }
    return RUN_ALL_TESTS();
}
