// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "camera_util.hpp"

// The array layer of CameraModel and the checks of its factories.

namespace opencv_test {
namespace {

using namespace camera;

using Coefficients = std::vector<double>;

const Matx33d kTum = matrixK(517.3, 516.5, 318.6, 255.3);

class Gmlpnp_CameraModel : public testing::Test
{
protected:
    Ptr<CameraModel> camera = CameraModel::pinhole(kTum);
    std::vector<Point2d> pixels = {{0, 0}, {318.6, 255.3}, {639, 479}};
};

TEST_F(Gmlpnp_CameraModel, outputsOfFixedType)
{
    Mat expected;
    camera->unproject(pixels, expected);
    std::vector<Vec3d> doubles;
    std::vector<Point3f> floats;
    std::vector<uchar> valid;
    camera->unproject(pixels, doubles, valid);
    camera->unproject(pixels, floats);
    ASSERT_EQ(doubles.size(), 3u);
    ASSERT_EQ(floats.size(), 3u);
    EXPECT_EQ(valid, std::vector<uchar>(3, 255));
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(doubles[i], Vec3d(expected.ptr<double>(i)));
        EXPECT_LT(cv::norm(Vec3f(floats[i]) - Vec3f(doubles[i])), 1e-7);
    }
    std::vector<Point2f> back;
    camera->project(doubles, back);
    ASSERT_EQ(back.size(), 3u);
    EXPECT_LT(cv::norm(Point2d(back[2]) - pixels[2]), 1e-4);
    Mat_<float> narrow;
    camera->unproject(pixels, narrow);
    EXPECT_EQ(narrow.size(), Size(3, 3));
    UMat device;
    camera->unproject(pixels, device);
    EXPECT_EQ(cv::norm(device.getMat(ACCESS_READ), expected, NORM_INF), 0);
}

TEST_F(Gmlpnp_CameraModel, outputIntoASlice)
{
    Mat expected, wide = Mat::ones(3, 8, CV_64F);
    camera->unproject(pixels, expected);
    Mat slice = wide.colRange(2, 5);
    camera->unproject(pixels, slice);
    EXPECT_EQ(cv::norm(wide.colRange(2, 5), expected, NORM_INF), 0);
    EXPECT_EQ(cv::norm(wide.colRange(0, 2), Mat::ones(3, 2, CV_64F), NORM_INF), 0);
    EXPECT_EQ(cv::norm(wide.colRange(5, 8), Mat::ones(3, 3, CV_64F), NORM_INF), 0);
}

TEST_F(Gmlpnp_CameraModel, misuseNamesTheArgument)
{
    Mat out;
    expectError(Error::StsAssert, "imagePoints", [&] { camera->unproject(std::vector<Point2i>(4), out); });
    expectError(Error::StsAssert, "imagePoints", [&] { camera->unproject(std::vector<Point3d>(4), out); });
    expectError(Error::StsAssert, "points", [&] { camera->project(Mat(), out); });
    std::vector<Vec4d> wrong;
    expectError(Error::StsAssert, "rays", [&] { camera->unproject(pixels, wrong); });
}

TEST_F(Gmlpnp_CameraModel, aLensOfYourOwn)
{
    class Orthographic : public CameraModel
    {
    public:
        bool unprojectPoint(const Point2d& pixel, Vec3d& ray, Matx32d*) const override
        {
            const double square = 1 - pixel.dot(pixel);
            if (!(square >= 0))
                return false;
            ray = Vec3d(pixel.x, pixel.y, std::sqrt(square));
            return true;
        }
        bool projectPoint(const Vec3d& point, Point2d& pixel) const override
        {
            pixel = {point[0], point[1]};
            return point[2] > 0;
        }
    };
    const Orthographic own;
    Mat rays, valid;
    own.unproject(std::vector<Point2d>{{0, 0.6}, {2, 2}}, rays, valid);
    EXPECT_NEAR(rays.at<double>(0, 2), 0.8, 1e-15);
    EXPECT_EQ(valid.at<uchar>(1), 0);
    FileStorage fs(".yml", FileStorage::WRITE | FileStorage::MEMORY);
    EXPECT_EQ(Error::StsNotImplemented, errorCode([&] { own.write(fs); }));
}

// The same checks of K stand before every lens that has one.
TEST(Gmlpnp_CameraFactories, cameraMatrix)
{
    using Factory = std::function<void(InputArray)>;
    const std::vector<Factory> factories = {
        [](InputArray K) { CameraModel::pinhole(K); }, [](InputArray K) { CameraModel::fisheye(K); },
        [](InputArray K) { CameraModel::omnidir(K, noArray(), 1); }, [](InputArray K) { CameraModel::eucm(K, 0.6, 1); },
        [](InputArray K) { CameraModel::doubleSphere(K, 0.1, 0.6); }};
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const Factory& make : factories) {
        for (const int depth : {CV_8U, CV_16S, CV_32S, CV_32F, CV_64F}) {
            Mat K;
            Mat(matrixK(99, 98, 50, 40)).convertTo(K, depth);
            EXPECT_EQ(0, errorCode([&] { make(K); })) << depth;
        }
        EXPECT_EQ(0, errorCode([&] { make(Mat(3, 4, CV_64F, Scalar(1)).colRange(0, 3)); }));
        expectError(Error::StsAssert, "K", [&] { make(Mat::eye(3, 4, CV_64F)); });
        expectError(Error::StsAssert, "K", [&] { make(std::vector<double>(9, 1.0)); });
        expectError(Error::StsAssert, "K", [&] { make(noArray()); });
        expectError(Error::StsAssert, "K", [&] { make(Mat(3, 3, CV_64FC2)); });
        expectError(Error::StsBadArg, "K", [&] { make(matrixK(0, 500, 1, 1)); });
        expectError(Error::StsBadArg, "K", [&] { make(matrixK(500, 0, 1, 1)); });
        expectError(Error::StsBadArg, "K", [&] { make(matrixK(nan, 500, 1, 1)); });
        expectError(Error::StsBadArg, "K", [&] { make(matrixK(500, 500, 1, HUGE_VAL)); });
    }
}

TEST(Gmlpnp_CameraFactories, distortionCounts)
{
    for (int n = 0; n <= 16; ++n) {
        const std::vector<float> D(n, 0.001f);
        const bool brown = n == 0 || n == 4 || n == 5 || n == 8 || n == 12 || n == 14, four = n == 0 || n == 4;
        EXPECT_EQ(brown ? 0 : Error::StsAssert, errorCode([&] { CameraModel::pinhole(kTum, D); })) << n;
        EXPECT_EQ(brown ? 0 : Error::StsAssert,
                  errorCode([&] { CameraModel::pinhole(kTum, Mat(D).reshape(1, std::min(n, 1))); }))
            << n;
        EXPECT_EQ(four ? 0 : Error::StsAssert, errorCode([&] { CameraModel::fisheye(kTum, D); })) << n;
        EXPECT_EQ(four ? 0 : Error::StsAssert, errorCode([&] { CameraModel::omnidir(kTum, D, 1); })) << n;
    }
    expectError(Error::StsAssert, "D", [] { CameraModel::pinhole(kTum, Mat(2, 2, CV_64F, Scalar(0))); });
    expectError(Error::StsBadArg, "D", [] { CameraModel::pinhole(kTum, Coefficients{0, 0, HUGE_VAL, 0}); });
    EXPECT_EQ(0, errorCode([] { CameraModel::pinhole(kTum, Vec4d(0.1, 0, 0, 0)); }));
}

TEST(Gmlpnp_CameraFactories, parameters)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {-0.1, nan, HUGE_VAL}) {
        expectError(Error::StsBadArg, "xi", [&] { CameraModel::omnidir(kTum, noArray(), bad); });
        expectError(Error::StsBadArg, "alpha", [&] { CameraModel::eucm(kTum, bad, 1); });
        expectError(Error::StsBadArg, "beta", [&] { CameraModel::eucm(kTum, 0.5, bad); });
        expectError(Error::StsBadArg, "alpha", [&] { CameraModel::doubleSphere(kTum, 0.1, bad); });
    }
    for (const double bad : {-1.0, 1.0, nan})
        expectError(Error::StsBadArg, "xi", [&] { CameraModel::doubleSphere(kTum, bad, 0.5); });
    expectError(Error::StsBadArg, "beta", [] { CameraModel::eucm(kTum, 0.5, 0); });
    for (const Size& bad : {Size(0, 10), Size(10, 0), Size(-4, 2)})
        expectError(Error::StsBadArg, "size", [&] { CameraModel::equirectangular(bad); });
}

// A point far from the axis: its pixel is beyond the range of a double.
TEST(Gmlpnp_CameraFactories, pixelsBeyondAllNumbersAreNone)
{
    for (const auto& lens : {CameraModel::pinhole(kTum), CameraModel::omnidir(kTum, noArray(), 1e-306),
                             CameraModel::eucm(kTum, 0, 1), CameraModel::doubleSphere(kTum, 0, 0)}) {
        Point2d pixel(7, 7);
        EXPECT_FALSE(lens->projectPoint({1, 0, 1e-306}, pixel));
        EXPECT_EQ(pixel, Point2d(7, 7));
        EXPECT_TRUE(lens->projectPoint({0, 0, 1}, pixel));
    }
}

TEST(Gmlpnp_CameraFactories, raysOfPixelsBeyondAllNumbersAreUnitOrNone)
{
    constexpr double HUGE_PIXEL = std::numeric_limits<double>::max();
    const Matx33d tiny = matrixK(1e-29, 1e-29, 320, 240);
    for (const auto& lens :
         {CameraModel::pinhole(tiny), CameraModel::pinhole(tiny, Vec4d(-0.1, 0.01, 0.001, 0.001)),
          CameraModel::fisheye(tiny), CameraModel::omnidir(tiny, noArray(), 1), CameraModel::eucm(tiny, 0.5, 1),
          CameraModel::doubleSphere(tiny, -0.2, 0.5), CameraModel::equirectangular({1, 1000})})
        for (const Point2d& pixel : {Point2d(HUGE_PIXEL, 500), Point2d(-HUGE_PIXEL, 500), Point2d(500, HUGE_PIXEL)}) {
            Vec3d ray(7, 7, 7);
            const bool seen = lens->unprojectPoint(pixel, ray);
            EXPECT_TRUE(seen ? std::abs(cv::norm(ray) - 1) < 1e-9 : ray == Vec3d(7, 7, 7)) << pixel << ", " << ray;
        }
}

// Their derivatives would be beyond the range of a double.
TEST(Gmlpnp_CameraFactories, parametersBeyondReasonAreRefused)
{
    for (const double bad : {1e-31, 1e31, -1e300}) {
        expectError(Error::StsBadArg, "'K'", [&] { CameraModel::pinhole(matrixK(bad, 500, 320, 240)); });
        expectError(Error::StsBadArg, "'K'", [&] { CameraModel::fisheye(matrixK(500, bad, 320, 240)); });
    }
    expectError(Error::StsBadArg, "'K'", [] { CameraModel::pinhole(matrixK(500, 500, 1e300, 240)); });
    expectError(Error::StsBadArg, "'D'", [] { CameraModel::pinhole(kTum, Vec4d(-1.7e308, 0, 0, 0)); });
}

}  // namespace
}  // namespace opencv_test
