// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../camera/camera_util.hpp"

// Arrays that a call writes: all or none of them, into the memory that is there.

namespace opencv_test {
namespace {

using namespace camera;

// Every public function writes its outputs in one way; here by those of a lens, of which there are three, and by lists.
class Gmlpnp_Outputs : public testing::Test
{
protected:
    const Ptr<CameraModel> camera = CameraModel::pinhole(matrixK(500, 500, 320, 240));
    const std::vector<Point2d> pixels = {{0, 0}, {320, 240}, {639, 479}};
};

TEST_F(Gmlpnp_Outputs, comeAllOrNotAtAll)
{
    const Mat before = Mat::ones(2, 5, CV_64F);
    Mat rays = before.clone();
    std::vector<uchar> valid(1, 7);
    std::vector<Vec4d> jacobian(1, Vec4d(1, 2, 3, 4));  // six numbers do not fit
    expectError(Error::StsAssert, "jacobian", [&] { camera->unproject(pixels, rays, valid, jacobian); });
    EXPECT_EQ(0, cv::norm(before, rays, NORM_INF));
    EXPECT_EQ(std::vector<uchar>(1, 7), valid);
    EXPECT_EQ(std::vector<Vec4d>(1, Vec4d(1, 2, 3, 4)), jacobian);
}

TEST_F(Gmlpnp_Outputs, memoryThatFitsIsKept)
{
    Mat rays(3, 3, CV_64F), valid(3, 1, CV_8U), sharing = rays;
    const uchar* const memory[] = {rays.data, valid.data};
    camera->unproject(pixels, rays, valid);
    EXPECT_EQ(memory[0], rays.data);
    EXPECT_EQ(memory[1], valid.data);
    EXPECT_EQ(0, cv::norm(sharing, rays, NORM_INF));
}

// What shares the memory of an array that does not fit is not written to.
TEST_F(Gmlpnp_Outputs, memoryThatDoesNotFitIsLeftToOthers)
{
    Mat rays = Mat::ones(2, 3, CV_64F), sharing = rays;
    camera->unproject(pixels, rays);
    EXPECT_EQ(Size(3, 3), rays.size());
    EXPECT_EQ(0, cv::norm(sharing, Mat::ones(2, 3, CV_64F), NORM_INF));
}

TEST_F(Gmlpnp_Outputs, vectorsBecomeLongerAndShorter)
{
    Mat expected;
    camera->unproject(pixels, expected);
    for (const size_t before : {0, 2, 3, 20}) {
        std::vector<Vec3d> rays(before);
        std::vector<uchar> valid(20 - before);
        camera->unproject(pixels, rays, valid);
        ASSERT_EQ(3u, rays.size());
        EXPECT_EQ(std::vector<uchar>(3, 255), valid);
        for (int i = 0; i < 3; ++i)
            EXPECT_EQ(Vec3d(expected.ptr<double>(i)), rays[i]);
    }
}

// An array of fixed size and type that fits is filled, another is refused.
TEST_F(Gmlpnp_Outputs, fixedSizesAreKept)
{
    Matx33d rays = Matx33d::all(7);
    camera->unproject(pixels, rays);
    EXPECT_NEAR(1, cv::norm(rays.row(1)), 1e-15);
    Matx<double, 2, 3> few = Matx<double, 2, 3>::all(7);
    EXPECT_THROW(camera->unproject(pixels, few), cv::Exception);
    EXPECT_EQ((Matx<double, 2, 3>::all(7)), few);
}

TEST_F(Gmlpnp_Outputs, listsOfMatricesKeepTheMatricesThatFit)
{
    const std::vector<Point3d> square = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    std::vector<Point2d> seen;
    cv::projectPoints(square, Vec3d(0.5, 0.1, 0), Vec3d(0.3, -0.2, 40), matrixK(500, 500, 320, 240), noArray(), seen);
    std::vector<Mat> rvecs = {Mat::zeros(3, 1, CV_64F), Mat::zeros(1, 3, CV_32F), Mat(), Mat()}, tvecs;
    const Mat first = rvecs[0];
    const int count = gmlpnp::solvePnPGeneric(square, seen, matrixK(500, 500, 320, 240), noArray(), rvecs, tvecs);
    ASSERT_EQ(2, count);
    ASSERT_EQ(2u, rvecs.size());
    ASSERT_EQ(2u, tvecs.size());
    EXPECT_EQ(first.data, rvecs[0].data);
    EXPECT_LT(cv::norm(Vec3d(first) - Vec3d(0.5, 0.1, 0)), 1e-6);
    for (const Mat& rvec : rvecs)
        EXPECT_EQ(Size(1, 3), rvec.size());
}

}  // namespace
}  // namespace opencv_test
