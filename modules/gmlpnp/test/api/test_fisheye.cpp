// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../camera/camera_util.hpp"
#include "../scenes.hpp"

// The contract of a drop-in for cv::fisheye::solvePnP and cv::fisheye::solvePnPRansac.

namespace opencv_test {
namespace {

using namespace camera;

const Matx33d kK = matrixK(300, 302, 640, 480);
const Vec4d kD(-0.02, 0.004, -0.001, 0.0001);
constexpr int FLAGS[] = {gmlpnp::SOLVEPNP_GMLPNP, gmlpnp::SOLVEPNP_GMLPNP_MARGINAL};

// Exact pixels of the points of a scene in the lens K, D.
Mat_<double> pixelsOf(const Scene& scene, const Matx33d& K = kK)
{
    Mat_<double> pixels(scene.rays.rows, 2);
    for (int i = 0; i < pixels.rows; ++i) {
        Point2d pixel;
        EXPECT_TRUE(CameraModel::fisheye(K, kD)->projectPoint(Vec3d(scene.rays.ptr<double>(i)), pixel));
        pixels(i, 0) = pixel.x;
        pixels(i, 1) = pixel.y;
    }
    return pixels;
}

// Up to 110 degrees off the axis, also behind the camera.
Scene wideScene(cv::RNG& rng)
{
    std::vector<Vector3d> points;
    while (points.size() < 40)
        for (const Vector3d& X : surroundingPoints(rng, 20))
            if (X.z() > std::cos(110 * kDegree) * X.norm())
                points.push_back(X);
    return exactScene(rng, points);
}

TEST(Gmlpnp_SolvePnPFisheye, exactUpTo110Degrees)
{
    cv::RNG rng = testRng();
    for (int flag : FLAGS) {
        const Scene scene = wideScene(rng);
        Vec3d rvec, tvec;
        ASSERT_TRUE(gmlpnp::fisheye::solvePnP(scene.objectPoints, pixelsOf(scene), kK, kD, rvec, tvec, false, flag));
        EXPECT_TRUE(poseNear(poseOf(rvec, tvec), scene.truth, 1e-9, 1e-8));
    }
}

TEST(Gmlpnp_SolvePnPFisheye, defaultFlagDepthAndGuessAreThoseOfSolvePnP)
{
    cv::RNG rng = testRng();
    const Scene scene = wideScene(rng);
    Mat rvec, tvec;
    ASSERT_TRUE(gmlpnp::fisheye::solvePnP(scene.objectPoints, pixelsOf(scene), kK, kD, rvec, tvec));
    EXPECT_EQ(CV_64F, rvec.type());
    EXPECT_EQ(Size(1, 3), tvec.size());
    Vec3f guess, start;
    Mat(rvec + 0.02).convertTo(guess, CV_32F);
    Mat(tvec + 0.1).convertTo(start, CV_32F);
    ASSERT_TRUE(gmlpnp::fisheye::solvePnP(scene.objectPoints, pixelsOf(scene), kK, kD, guess, start, true));
    EXPECT_TRUE(poseNear(poseOf(Vec3d(guess), Vec3d(start)), scene.truth, 1e-6, 1e-5));
}

// With rays in front of the camera each flag of OpenCV finds the pose; its own 5 iterations would not, at 80 degrees.
TEST(Gmlpnp_SolvePnPFisheye, opencvFlagsWorkOnTheUndistortedPixels)
{
    cv::RNG rng = testRng();
    std::vector<Vector3d> points;
    for (int i = 0; i < 30; ++i) {
        const Vec3d X = rng.uniform(2., 8.) * direction(rng.uniform(0., 80.) * kDegree, rng.uniform(0., 2 * CV_PI));
        points.emplace_back(X[0], X[1], X[2]);
    }
    const Scene scene = exactScene(rng, points);
    Matx33d skewed = kK;
    skewed(0, 1) = 1.5;
    for (const Matx33d& K : {kK, skewed})
        for (int flag : {gmlpnp::SOLVEPNP_ITERATIVE, gmlpnp::SOLVEPNP_EPNP, gmlpnp::SOLVEPNP_SQPNP}) {
            SCOPED_TRACE(testing::Message() << "flag " << flag << " skew " << K(0, 1));
            Vec3d rvec, tvec;
            ASSERT_TRUE(
                gmlpnp::fisheye::solvePnP(scene.objectPoints, pixelsOf(scene, K), K, kD, rvec, tvec, false, flag));
            EXPECT_TRUE(poseNear(poseOf(rvec, tvec), scene.truth, 1e-4, 1e-3));
        }
}

TEST(Gmlpnp_SolvePnPFisheye, wrongInputIsRefusedByName)
{
    cv::RNG rng = testRng();
    const Scene scene = wideScene(rng);
    const Mat P = scene.objectPoints, U = pixelsOf(scene), none;
    Vec3d rvec(1, 2, 3), tvec(4, 5, 6);
    const auto call = [&](const Mat& p, const Mat& u, const Mat& K, const Mat& D, int flag) {
        return [=, &rvec, &tvec] { gmlpnp::fisheye::solvePnP(p, u, K, D, rvec, tvec, false, flag); };
    };
    const Mat K(kK), D(kD), D5 = Mat::zeros(5, 1, CV_64F), K34 = Mat::eye(3, 4, CV_64F);
    for (int flag : FLAGS) {
        expectError(Error::StsAssert, "objectPoints", call(P.t(), U, K, D, flag));
        expectError(Error::StsAssert, "imagePoints", call(P, U.rowRange(0, 12), K, D, flag));
        expectError(Error::StsAssert, "imagePoints", call(P, none, K, D, flag));
        expectError(Error::StsAssert, "K", call(P, U, K34, D, flag));
        expectError(Error::StsAssert, "D", call(P, U, K, D5, flag));
    }
    // Some rays are behind the camera: no image plane, and so no flag of OpenCV, can hold them.
    expectError(Error::StsBadArg, "imagePoints", call(P, U, K, D, gmlpnp::SOLVEPNP_EPNP));
    for (int flag : {-1, 99, 102})
        expectError(Error::StsBadArg, "flags", call(P, U, K, D, flag));
    Mat_<double> notFinite = U.clone();
    notFinite(3, 1) = std::nan("");
    EXPECT_FALSE(gmlpnp::fisheye::solvePnP(P, notFinite, K, D, rvec, tvec));
    EXPECT_EQ(Vec3d(1, 2, 3), rvec);
    EXPECT_EQ(Vec3d(4, 5, 6), tvec);
}

TEST(Gmlpnp_SolvePnPRansac, fisheye)
{
    cv::RNG rng = testRng();
    const Matx33d K = matrixK(300, 302, 640, 480);
    const Vec4d D(-0.02, 0.004, -0.001, 0.0001);
    const Ptr<CameraModel> lens = CameraModel::fisheye(K, D);
    for (const double widest : {110., 60.}) {
        std::vector<Vector3d> points;
        Mat_<double> pixels(0, 2);
        while (points.size() < 60) {
            const Vector3d X = surroundingPoints(rng, 1).front();
            Point2d pixel;
            if (X.z() < std::cos(widest * kDegree) * X.norm() || !lens->projectPoint(Vec3d(X.x(), X.y(), X.z()), pixel))
                continue;
            if (points.size() % 3 == 0)
                pixel += Point2d(rng.uniform(-90., 90.), rng.uniform(20., 90.));
            points.push_back(X);
            pixels.push_back(Mat(Matx12d(pixel.x, pixel.y)));
        }
        const Scene scene = exactScene(rng, points);
        Mat rvec, tvec, inliers;
        ASSERT_TRUE(gmlpnp::fisheye::solvePnPRansac(scene.objectPoints, pixels, K, D, rvec, tvec, false, 1000, 3.f,
                                                    0.99, inliers));
        EXPECT_EQ(40, inliers.rows);
        EXPECT_TRUE(poseNear(poseOf(Vec3d(rvec), Vec3d(tvec)), scene.truth, 1e-3, 5e-3));
        const auto byOpenCV = [&] {
            return gmlpnp::fisheye::solvePnPRansac(scene.objectPoints, pixels, K, D, rvec, tvec, false, 1000, 3.f, 0.99,
                                                   inliers, cv::SOLVEPNP_SQPNP);
        };
        if (widest > 90) {
            EXPECT_THROW(byOpenCV(), cv::Exception);
        } else {
            ASSERT_TRUE(byOpenCV());
            EXPECT_TRUE(poseNear(poseOf(Vec3d(rvec), Vec3d(tvec)), scene.truth, 0.01, 0.05));
        }
    }
}

}  // namespace
}  // namespace opencv_test
