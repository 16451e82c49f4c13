// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "perf_precomp.hpp"

namespace opencv_test {
namespace {

using cv::gmlpnp::SOLVEPNP_GMLPNP;
using cv::gmlpnp::SOLVEPNP_GMLPNP_MARGINAL;

CV_ENUM(Flag, SOLVEPNP_ITERATIVE, SOLVEPNP_EPNP, SOLVEPNP_SQPNP, SOLVEPNP_GMLPNP, SOLVEPNP_GMLPNP_MARGINAL)

typedef TestBaseWithParam<tuple<int, Flag>> Count_Flag;

const Matx33d CAMERA(800, 0, 320, 0, 800, 240, 0, 0, 1);

// n points in a cube of edge 4, 6 before the camera; Gaussian noise of 0.02 on the points and 1 px on the pixels.
void makeScene(int n, std::vector<Point3d>& objectPoints, std::vector<Point2d>& imagePoints)
{
    RNG rng(static_cast<uint64>(n));
    for (int i = 0; i < n; ++i)
        objectPoints.emplace_back(rng.uniform(-2., 2.), rng.uniform(-2., 2.), rng.uniform(-2., 2.));
    cv::projectPoints(objectPoints, Vec3d(0.3, -0.4, 0.5), Vec3d(0.1, -0.2, 6), CAMERA, noArray(), imagePoints);
    for (int i = 0; i < n; ++i) {
        objectPoints[i] += Point3d(rng.gaussian(0.02), rng.gaussian(0.02), rng.gaussian(0.02));
        imagePoints[i] += Point2d(rng.gaussian(1), rng.gaussian(1));
    }
}

PERF_TEST_P(Count_Flag, solvePnP, testing::Combine(testing::Values(10, 50, 200, 1000), Flag::all()))
{
    const int n = get<0>(GetParam()), flag = get<1>(GetParam());
    std::vector<Point3d> objectPoints;
    std::vector<Point2d> imagePoints;
    makeScene(n, objectPoints, imagePoints);
    Vec3d rvec, tvec;
    bool solved = true;

    declare.in(objectPoints, imagePoints).out(rvec, tvec);
    TEST_CYCLE()
    {
        solved = gmlpnp::solvePnP(objectPoints, imagePoints, CAMERA, noArray(), rvec, tvec, false, flag) && solved;
    }

    EXPECT_TRUE(solved);
    SANITY_CHECK_NOTHING();
}

}  // namespace
}  // namespace opencv_test
