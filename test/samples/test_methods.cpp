// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <sstream>

#include <opencv2/gmlpnp.hpp>

#include "common/comparison.hpp"
#include "common/outliers.hpp"
#include "common/study.hpp"

namespace {

using namespace samples;
using cv::gmlpnp::CameraModel;

//! Points up to `angle` [rad] off the axis of a lens, their pixels with normal noise.
CorrespondenceSet sceneThrough(const cv::Ptr<CameraModel>& lens, double angle, double noisePixels)
{
    cv::RNG random(99);
    CorrespondenceSet set;
    set.lens = lens;
    set.hasTruth = true;
    set.truth = poseFromRotationVector({0.1, 0.2, -0.3}, {0.2, -0.1, 0.3});
    set.unit = "m";
    while (set.objectPoints.size() < 60) {
        const double theta = angle * std::sqrt(random.uniform(0.0, 1.0)), around = random.uniform(0.0, 2.0 * CV_PI);
        const cv::Vec3d direction(std::sin(theta) * std::cos(around), std::sin(theta) * std::sin(around),
                                  std::cos(theta));
        const cv::Vec3d X = random.uniform(2.0, 8.0) * direction;
        cv::Point2d pixel;
        if (!lens->projectPoint(X, pixel))
            continue;
        set.objectPoints.emplace_back(set.truth.R.t() * (X - set.truth.t));
        set.imagePoints.emplace_back(pixel.x + random.gaussian(noisePixels), pixel.y + random.gaussian(noisePixels));
    }
    return set;
}

cv::Ptr<CameraModel> fisheye()
{
    return CameraModel::fisheye(cv::Matx33d(300, 0, 500, 0, 300, 500, 0, 0, 1), cv::Vec4d(0.01, 0.001, 0, 0));
}

Estimate estimateBy(const char* name, const CorrespondenceSet& set)
{
    for (const Method& method : comparedMethods())
        if (method.name == name)
            return estimatePose(set, method, 1);
    ADD_FAILURE() << name;
    return {};
}

TEST(Methods, allSolveThroughALensWithinItsFrontHalf)
{
    const CorrespondenceSet set = sceneThrough(fisheye(), 1.2, 0.3);
    for (const Method& method : comparedMethods()) {
        const Estimate estimate = estimatePose(set, method, 1);
        ASSERT_TRUE(estimate.solved) << method.name;
        EXPECT_LT(rotationErrorDegrees(estimate.pose(), set.truth), 0.3) << method.name;
        EXPECT_LT(positionError(estimate.pose(), set.truth), 0.02) << method.name;
    }
}

TEST(Methods, beyondARightAngleOnlyThoseThatCan)
{
    const CorrespondenceSet set = sceneThrough(fisheye(), 1.75, 0.3);
    for (const Method& method : comparedMethods())
        EXPECT_EQ(estimatePose(set, method, 1).solved, method.flag >= cv::gmlpnp::SOLVEPNP_GMLPNP) << method.name;
}

TEST(Methods, aPinholeGivenAsALensIsAPinhole)
{
    CorrespondenceSet set =
        sceneThrough(CameraModel::pinhole(cv::Matx33d(500, 0, 320, 0, 500, 240, 0, 0, 1)), 0.5, 0.5);
    for (const char* name : {"EPNP", "SQPNP", "GMLPNP", "GMLPNP_MARGINAL"}) {
        const Estimate asLens = estimateBy(name, set);
        CorrespondenceSet pinhole = set;
        pinhole.lens.reset();
        pinhole.cameraMatrix = cv::Matx33d(500, 0, 320, 0, 500, 240, 0, 0, 1);
        const Estimate asMatrix = estimateBy(name, pinhole);
        ASSERT_TRUE(asLens.solved && asMatrix.solved) << name;
        EXPECT_LT(cv::norm(asLens.rvec - asMatrix.rvec) + cv::norm(asLens.tvec - asMatrix.tvec), 1e-7) << name;
    }
}

//! Sum over the points of the squared distance, or sine of the angle, between point and ray.
double costOf(const CorrespondenceSet& set, const Pose& pose, bool angles)
{
    double sum = 0.0;
    for (size_t i = 0; i < set.objectPoints.size(); ++i) {
        cv::Vec3d ray;
        EXPECT_TRUE(set.lens->unprojectPoint(set.imagePoints[i], ray));
        const cv::Vec3d X = pose * cv::Vec3d(set.objectPoints[i]), v = ray.cross(X);
        sum += v.dot(v) / (angles ? std::pow(ray.dot(X), 2) : 1.0);
    }
    return sum;
}

//! The two references without estimated noise must be where their own costs are least.
TEST(Methods, referencesMinimiseTheirOwnCosts)
{
    const CorrespondenceSet set = sceneThrough(fisheye(), 1.2, 2.0);
    for (const bool angles : {false, true}) {
        const Estimate best = estimateBy(angles ? "BEARING" : "ISOTROPIC", set);
        ASSERT_TRUE(best.solved);
        const double least = costOf(set, best.pose(), angles);
        for (int i = 0; i < 12; ++i) {
            cv::Vec6d step;
            step[i / 2] = i % 2 ? 3e-3 : -3e-3;
            const Pose turn = poseFromRotationVector({step[0], step[1], step[2]}, {step[3], step[4], step[5]});
            const Pose near{turn.R * best.pose().R, turn.R * best.pose().t + turn.t};
            EXPECT_GT(costOf(set, near, angles), least) << angles << " " << i;
        }
    }
}

TEST(Outliers, areRejectedThroughPinholeAndLens)
{
    CorrespondenceSet lens = sceneThrough(fisheye(), 1.2, 0.3);
    CorrespondenceSet pinhole =
        sceneThrough(CameraModel::pinhole(cv::Matx33d(500, 0, 320, 0, 500, 240, 0, 0, 1)), 0.5, 0.3);
    pinhole.lens.reset();
    pinhole.cameraMatrix = cv::Matx33d(500, 0, 320, 0, 500, 240, 0, 0, 1);
    for (CorrespondenceSet* set : {&lens, &pinhole}) {
        for (size_t i = 0; i < 6; ++i)
            set->imagePoints[10 * i] += cv::Point2d(25.0, -18.0);
        CorrespondenceSet all = *set;
        rejectOutliers(all, 0.0, 1);
        EXPECT_EQ(all.objectPoints.size(), 60u);
        rejectOutliers(*set, 3.0, 1);
        EXPECT_EQ(set->objectPoints.size(), 54u);
        EXPECT_EQ(set->imagePoints.size(), 54u);
    }
}

TEST(Outliers, aFewThatAgreeAreNoConsensus)
{
    CorrespondenceSet set;
    set.cameraMatrix = cv::Matx33d(500, 0, 320, 0, 500, 240, 0, 0, 1);
    cv::RNG random(3);
    for (int i = 0; i < 40; ++i) {
        set.objectPoints.emplace_back(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), random.uniform(2.0, 5.0));
        set.imagePoints.emplace_back(random.uniform(0.0, 640.0), random.uniform(0.0, 480.0));
    }
    rejectOutliers(set, 8.0, 1);
    EXPECT_TRUE(set.objectPoints.empty());
}

//! Errors of two methods in four pairs: in one there are no correspondences, in one the first method fails.
Comparison smallComparison()
{
    Comparison comparison{{{"rotation", "deg", 2}}, {comparedMethods()[0], comparedMethods()[7]}, {}};
    const double errors[3][2] = {{-3.0, 1.0}, {5.0, 2.0}, {0.0, 9.0}};
    for (int i = 0; i < 3; ++i) {
        Trial trial;
        trial.name = cv::format("pair_%d", i);
        trial.points = 50;
        for (int m = 0; m < 2; ++m) {
            Outcome outcome;
            outcome.estimate.solved = !(i == 2 && m == 0);
            outcome.errors = {errors[i][m]};
            trial.outcomes.push_back(outcome);
        }
        comparison.trials.push_back(trial);
    }
    Trial failed;
    failed.name = "pair_3";
    failed.failure = "only 2 matches";
    comparison.trials.push_back(failed);
    return comparison;
}

TEST(Comparison, countsFailuresAndDropsNone)
{
    const Comparison comparison = smallComparison();
    EXPECT_EQ(absoluteErrors(comparison, 0, 0), (std::vector<double>{3.0, 5.0}));
    EXPECT_EQ(absoluteErrors(comparison, 1, 0), (std::vector<double>{1.0, 2.0, 9.0}));
    std::ostringstream errors, differences;
    printErrors(errors, comparison, 1);
    EXPECT_NE(errors.str().find("| EPNP            |      2 |      2 | "), std::string::npos) << errors.str();
    EXPECT_NE(errors.str().find("| GMLPNP_MARGINAL |      3 |      1 | "), std::string::npos) << errors.str();
    EXPECT_NE(errors.str().find("4.00 ["), std::string::npos) << errors.str();
    // Over the two pairs that both solved: (1 - 3 + 2 - 5) / 2, in percent of (3 + 5) / 2.
    printDifferences(differences, comparison, 1);
    EXPECT_NE(differences.str().find("| EPNP                  |     2 |"), std::string::npos) << differences.str();
    EXPECT_NE(differences.str().find("-2.500 | -62.5 |"), std::string::npos) << differences.str();
}

TEST(Comparison, writesARowForEveryPairAndMethod)
{
    const std::string path = ::testing::TempDir() + "gmlpnp_comparison.csv";
    writeComparison(path, smallComparison(), "small");
    std::ifstream stream(path);
    std::string kind, title;
    std::getline(std::getline(stream, kind), title);
    EXPECT_EQ(kind + "\n" + title, "# kind errors\n# title small");
    int rows = 0, commas = -1;
    for (std::string line; std::getline(stream, line); ++rows) {
        const int here = static_cast<int>(std::count(line.begin(), line.end(), ','));
        EXPECT_TRUE(commas < 0 || here == commas) << line;
        commas = here;
    }
    EXPECT_EQ(rows, 9);
    Comparison unknown = smallComparison();
    unknown.quantities.clear();
    for (Trial& trial : unknown.trials)
        for (Outcome& outcome : trial.outcomes)
            outcome.errors.clear();
    writeComparison(path, unknown, "small");
    std::ifstream again(path);
    std::getline(again, kind);
    EXPECT_EQ(kind.find("pair,method"), 0u) << "without errors there is nothing to draw";
    EXPECT_THROW(writeComparison(::testing::TempDir() + "missing_folder/x.csv", smallComparison(), ""),
                 std::runtime_error);
}

TEST(Study, aPairWithoutMatchesFailsAndTheStudyGoesOn)
{
    Study study;
    study.title = "test";
    study.pairs = {"good", "empty", "good_too"};
    study.correspondences = [](size_t i) {
        CorrespondenceSet set = sceneThrough(fisheye(), 1.2, 0.3);
        if (i == 1)
            set.objectPoints.resize(2);
        requireMatches(set, "a.png", "b.png");
        return set;
    };
    measureMotion(study);
    int visited = 0;
    study.visit = [&](size_t, const CorrespondenceSet&, const std::vector<Outcome>& outcomes) {
        ++visited;
        EXPECT_EQ(outcomes.size(), 2u);
    };
    const StudyOptions options{"", 1, 1, true, {comparedMethods()[2], comparedMethods()[7]}};
    ::testing::internal::CaptureStdout();
    ::testing::internal::CaptureStderr();
    EXPECT_EQ(runStudy(study, options), 0);
    const std::string out = ::testing::internal::GetCapturedStdout(), err = ::testing::internal::GetCapturedStderr();
    EXPECT_EQ(visited, 2);
    EXPECT_NE(out.find("test: 3 pairs, 1 without correspondences; 60 points"), std::string::npos) << out;
    EXPECT_NE(out.find("| GMLPNP_MARGINAL |      2 |      1 | "), std::string::npos) << out;
    EXPECT_NE(out.find("Test of isotropy"), std::string::npos) << out;
    EXPECT_NE(err.find("Failed: empty: only 2 matches between a.png and b.png"), std::string::npos) << err;
}

}  // namespace
