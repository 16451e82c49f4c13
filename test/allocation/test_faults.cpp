// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

// Memory runs out in the solvers.

#include <cstdlib>

#include "faults.hpp"
#include "hooks.hpp"

namespace {

using namespace allocation;
using cv::gmlpnp::Params;

void* volatile taken[2];  // no compiler leaves out an allocation that goes here

TEST_F(Faults, theHookFires)
{
    failAfter(1);
    taken[0] = std::malloc(100);
    EXPECT_TRUE(failed());
    failAfter(0);
    EXPECT_EQ(nullptr, taken[0]);
    failAfter(1);
    EXPECT_THROW(cv::fastMalloc(1000), cv::Exception);
    failAfter(0);
}

TEST_F(Faults, theBlocksAreCounted)
{
    const long before = live();
    failAfter(2);
    taken[0] = std::malloc(100);
    taken[1] = std::malloc(200);
    failAfter(0);
    EXPECT_EQ(nullptr, taken[1]);
    EXPECT_EQ(before + 1, live());
    EXPECT_EQ(200u, failures().at(0).size);
    EXPECT_TRUE(failures().at(0).keptBlock);
    std::free(taken[0]);
    EXPECT_EQ(before, live());
    EXPECT_FALSE(failures().at(0).keptBlock);
}

TEST_F(Faults, solve)
{
    expectClean([](const Scene& s, Outputs& out) { cv::gmlpnp::solve(s.points, s.pixels, s.K, s.D, out.result); });
    expectClean([](const Scene& s, Outputs& out) {
        Params params;
        params.method = cv::gmlpnp::SOLVEPNP_GMLPNP;
        params.pixelCovariances = cv::Mat(static_cast<int>(s.points.size()), 1, CV_64F, cv::Scalar(1));
        cv::gmlpnp::solve(s.points, s.pixels, s.camera, out.result, params);
    });
}

TEST_F(Faults, solveRays)
{
    expectClean([](const Scene& s, Outputs& out) { cv::gmlpnp::solveRays(s.points, s.rays, out.result); });
}

void solveThree(const Scene& s, Outputs& out)
{
    cv::gmlpnp::solveBatch(std::vector<std::vector<cv::Point3d>>(3, s.points),
                           std::vector<std::vector<cv::Vec3d>>(3, s.rays), out.results);
}

TEST_F(Faults, solveBatch)
{
    expectClean(solveThree);
}

TEST_F(Faults, solveBatchOnTwoThreads)
{
    cv::setNumThreads(2);
    expectClean(solveThree);
}

TEST_F(Faults, solveAll)
{
    expectClean([](const Scene& s, Outputs& out) { cv::gmlpnp::solveAll(s.points, s.pixels, s.camera, out.results); });
    expectClean([](const Scene& s, Outputs& out) { cv::gmlpnp::solveAll(s.points, s.pixels, s.K, s.D, out.results); });
}

TEST_F(Faults, solvePnP)
{
    expectClean(
        [](const Scene& s, Outputs& out) { cv::gmlpnp::solvePnP(s.points, s.pixels, s.K, s.D, out.rvec, out.tvec); });
    expectClean([](const Scene& s, Outputs& out) {
        cv::gmlpnp::solvePnP(s.points, s.pixels, s.K, s.D, out.rvecFixed, out.tvecFixed);
    });
    expectClean([](const Scene& s, Outputs& out) {
        cv::gmlpnp::solvePnP(s.points, s.pixels, s.K, s.D, out.rvecVector, out.tvecWrong);
    });
}

TEST_F(Faults, solvePnPOfFisheye)
{
    expectClean([](const Scene& s, Outputs& out) {
        cv::gmlpnp::fisheye::solvePnP(s.points, s.pixels, s.K, cv::Vec4d(), out.rvecFixed, out.tvec);
    });
}

TEST_F(Faults, solvePnPGeneric)
{
    expectClean([](const Scene& s, Outputs& out) {
        cv::gmlpnp::solvePnPGeneric(s.points, s.pixels, s.K, s.D, out.rvecs, out.tvecs, false,
                                    cv::gmlpnp::SOLVEPNP_GMLPNP_MARGINAL, cv::noArray(), cv::noArray(), out.errors);
    });
}

TEST_F(Faults, solvePnPRefine)
{
    expectClean([](const Scene& s, Outputs& out) {
        cv::gmlpnp::solvePnPRefine(s.points, s.pixels, s.K, s.D, out.rvecNear, out.tvecNear);
    });
    expectClean([](const Scene& s, Outputs& out) {
        cv::gmlpnp::solvePnPRefine(s.points, s.pixels, s.K, s.D, out.rvecRow, out.tvecRow);
    });
}

TEST_F(Faults, solvePnPRansac)
{
    expectClean([](const Scene& s, Outputs& out) {
        cv::gmlpnp::solvePnPRansac(s.points, s.pixels, s.K, s.D, out.rvecFixed, out.tvec, false, 50, 8, 0.99,
                                   out.inliers);
    });
    expectClean([](const Scene& s, Outputs& out) {
        cv::Mat K(s.K);
        cv::gmlpnp::solvePnPRansac(s.points, s.pixels, K, s.D, out.rvecFixed, out.tvec, out.inliers,
                                   cv::gmlpnp::UsacParams());
    });
}

TEST_F(Faults, solvePnPRansacOfFisheye)
{
    expectClean([](const Scene& s, Outputs& out) {
        cv::gmlpnp::fisheye::solvePnPRansac(s.points, s.pixels, s.K, cv::Vec4d(), out.rvecFixed, out.tvec, false, 50, 8,
                                            0.99, out.inliers);
    });
}

TEST_F(Faults, solveRansac)
{
    expectClean([](const Scene& s, Outputs& out) {
        cv::gmlpnp::solveRansac(s.points, s.pixels, s.camera, out.result, out.inliers);
    });
    expectClean([](const Scene& s, Outputs& out) {
        cv::gmlpnp::solveRansac(s.points, s.pixels, s.K, s.D, out.result, out.inliers);
    });
}

TEST_F(Faults, solveRaysRansac)
{
    expectClean(
        [](const Scene& s, Outputs& out) { cv::gmlpnp::solveRaysRansac(s.points, s.rays, out.result, out.inliers); });
}

}  // namespace
