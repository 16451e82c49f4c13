// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "test_precomp.hpp"

#include <cstdlib>

#include "scenes.hpp"

namespace opencv_test {

using namespace cv::gmlpnp::detail;

uint64_t testSeed()
{
    const testing::TestInfo* info = testing::UnitTest::GetInstance()->current_test_info();
    uint64_t hash = 1469598103934665603ull;                     // FNV-1a
    const char* const other = std::getenv("GMLPNP_TEST_SEED");  // draws other problems: tells chance from a fault
    for (const char* text : {info->name(), other ? other : ""})
        for (; *text; ++text)
            hash = (hash ^ static_cast<unsigned char>(*text)) * 1099511628211ull;
    return hash;
}

cv::RNG testRng()
{
    return cv::RNG(testSeed());
}

Pose poseOf(const cv::gmlpnp::Result& result)
{
    return poseOf(result.rvec, result.tvec);
}

testing::AssertionResult poseNear(const Pose& pose, const Pose& truth, double angle, double distance)
{
    const double angleOff = rotationAngle(pose.R, truth.R), distanceOff = (pose.t - truth.t).norm();
    if (angleOff <= angle && distanceOff <= distance)  // false for NaN
        return testing::AssertionSuccess();
    return testing::AssertionFailure() << "rotation off by " << angleOff << " rad (bound " << angle
                                       << "), translation off by " << distanceOff << " (bound " << distance << ")";
}

testing::AssertionResult poseNear(const cv::gmlpnp::Result& result, const Pose& truth, double angle, double distance)
{
    return poseNear(poseOf(result), truth, angle, distance);
}

cv::gmlpnp::Result solved(const cv::Mat_<double>& points, const cv::Mat_<double>& rays,
                          const cv::gmlpnp::Params& params)
{
    cv::gmlpnp::Result result;
    EXPECT_TRUE(cv::gmlpnp::solveRays(points, rays, result, params));
    return result;
}

cv::gmlpnp::Result solved(const Scene& scene, const cv::gmlpnp::Params& params)
{
    return solved(scene.objectPoints, scene.rays, params);
}

cv::gmlpnp::Result solvedPixels(const Scene& scene, const cv::gmlpnp::Params& params)
{
    cv::gmlpnp::Result result;
    EXPECT_TRUE(cv::gmlpnp::solve(scene.objectPoints, scene.imagePoints, paperCamera(), cv::noArray(), result, params));
    return result;
}

double distance(const cv::gmlpnp::Result& result, const Scene& scene)
{
    return (poseOf(result).t - scene.truth.t).norm();
}

Matrix3d matrix3(const cv::Mat& m)
{
    Matrix3d M;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            M(i, j) = m.at<double>(i, j);
    return M;
}

Matrix6d matrix6(const cv::Mat& m)
{
    Matrix6d M;
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j)
            M(i, j) = m.at<double>(i, j);
    return M;
}

double mahalanobis2(const Pose& a, const Pose& b, const cv::Mat& poseCovariance)
{
    const Vector6d xi = cv::gmlpnp::detail::difference(a, b);
    return xi.dot(matrix6(poseCovariance).ldlt().solve(xi));
}

}  // namespace opencv_test
