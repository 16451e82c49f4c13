// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#ifdef GMLPNP_HAVE_DRAW

#include "opencv2/gmlpnp/draw.hpp"

#include "../../src/draw/draw.hpp"
#include "../camera/camera_util.hpp"
#include "../scenes.hpp"

namespace opencv_test {
namespace {

using namespace camera;
using gmlpnp::Result;

const Matx33d kK = matrixK(300, 302, 320, 240);

std::vector<Ptr<CameraModel>> lenses()
{
    return {CameraModel::pinhole(kK, Vec4d(-0.1, 0.01, 0, 0)), CameraModel::fisheye(kK, Vec4d(0.02, -0.003, 0, 0)),
            CameraModel::equirectangular(Size(640, 320))};
}

// A pose with a covariance of which rotation and translation depend on each other.
Result uncertainPose(cv::RNG& rng)
{
    Result result;
    result.rvec = Vec3d(0.4, -0.3, 0.2);
    result.tvec = Vec3d(0.3, -0.2, 4);
    Matrix6d A;
    for (int i = 0; i < 36; ++i)
        A(i / 6, i % 6) = rng.gaussian(2e-3);
    const Matrix6d C = A * A.transpose();
    result.poseCovariance = Mat(6, 6, CV_64F);
    for (int i = 0; i < 36; ++i)
        result.poseCovariance.at<double>(i / 6, i % 6) = C(i / 6, i % 6);
    return result;
}

TEST(Gmlpnp_Draw, ellipseHoldsThePointsOfTheCovariance)
{
    cv::RNG rng = testRng();
    const Result result = uncertainPose(rng);
    const Matrix6d L = matrix6(result.poseCovariance).llt().matrixL();
    const Pose pose = poseOf(result);
    for (const Ptr<CameraModel>& lens : lenses())
        for (const Vec3d& p : {Vec3d(), Vec3d(0.5, -0.4, 0.6)}) {
            Point2d centre;
            Matx22d covariance;
            ASSERT_TRUE(gmlpnp::detail::pixelUncertainty(*lens, result, p, centre, covariance));
            const Matx22d information = covariance.inv();
            constexpr int TRIALS = 4000;
            int inside = 0;
            for (int trial = 0; trial < TRIALS; ++trial) {
                Vector6d xi;
                xi << gaussian3(rng), gaussian3(rng);
                const Vector3d X = gmlpnp::detail::perturbed(pose, L * xi) * Vector3d(p[0], p[1], p[2]);
                Point2d pixel;
                ASSERT_TRUE(lens->projectPoint(Vec3d(X.x(), X.y(), X.z()), pixel));
                const Vec2d d(pixel.x - centre.x, pixel.y - centre.y);
                inside += d.dot(information * d) < 5.9915;
            }
            EXPECT_NEAR(0.95, double(inside) / TRIALS, 0.015);  // four standard deviations
        }
}

TEST(Gmlpnp_Draw, drawsWhereTheOriginIs)
{
    cv::RNG rng = testRng();
    Result result = uncertainPose(rng);
    for (const Ptr<CameraModel>& lens : lenses())
        for (const int type : {CV_8UC1, CV_8UC3, CV_8UC4}) {
            Mat image = Mat::zeros(480, 640, type);
            drawPoseUncertainty(image, lens, result, 0.5, std::vector<Point3d>{{0.2, 0.2, 0}});
            Point2d pixel;
            ASSERT_TRUE(lens->projectPoint(result.tvec, pixel));
            const Mat gray = image.reshape(1) > 0;
            const Rect around(int(pixel.x) - 2, int(pixel.y) - 2, 5, 5);
            EXPECT_GT(cv::norm(image(around), NORM_L1), 0);
            EXPECT_LT(cv::countNonZero(gray), 0.1 * double(gray.total()));
        }
}

TEST(Gmlpnp_Draw, ellipsesNeedACovarianceAndAPointInView)
{
    cv::RNG rng = testRng();
    Result result = uncertainPose(rng);
    const Ptr<CameraModel> lens = lenses()[0];
    Mat plain = Mat::zeros(480, 640, CV_8UC3), full = plain.clone(), behind = plain.clone();
    drawPoseUncertainty(full, lens, result, 0.5);
    result.poseCovariance.release();
    drawPoseUncertainty(plain, lens, result, 0.5);
    EXPECT_GT(cv::norm(plain), 0);
    EXPECT_GT(cv::norm(full, plain), 0);
    result.tvec = Vec3d(0, 0, -4);
    drawPoseUncertainty(behind, lens, result, 0.5);
    EXPECT_EQ(0, cv::norm(behind));
}

TEST(Gmlpnp_Draw, misuse)
{
    cv::RNG rng = testRng();
    const Result result = uncertainPose(rng);
    Mat image = Mat::zeros(480, 640, CV_8UC3), deep = Mat::zeros(48, 64, CV_32F), none;
    EXPECT_THROW(drawPoseUncertainty(none, lenses()[0], result, 1), cv::Exception);
    EXPECT_THROW(drawPoseUncertainty(deep, lenses()[0], result, 1), cv::Exception);
    EXPECT_THROW(drawPoseUncertainty(image, Ptr<CameraModel>(), result, 1), cv::Exception);
    EXPECT_THROW(drawPoseUncertainty(image, lenses()[0], result, 0), cv::Exception);
    EXPECT_THROW(drawPoseUncertainty(image, lenses()[0], result, 1, noArray(), 0), cv::Exception);
    EXPECT_THROW(drawPoseUncertainty(image, lenses()[0], result, 1, Mat(3, 2, CV_64F)), cv::Exception);
    EXPECT_EQ(0, cv::norm(image)) << "drawn on";
}

}  // namespace
}  // namespace opencv_test

#endif  // GMLPNP_HAVE_DRAW
