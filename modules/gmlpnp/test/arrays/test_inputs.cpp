// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../../src/arrays/inputs.hpp"
#include "../camera/camera_util.hpp"

namespace opencv_test {
namespace {

using gmlpnp::detail::matrixFrom;
using gmlpnp::detail::pointsFrom;

const double kPoints[5][3] = {{1, 2, 3}, {4, 5, 6.5}, {-7, 8, 9}, {0.25, 0, -1}, {11, 12, 13}};

Mat reference()
{
    return Mat(5, 3, CV_64F, const_cast<double*>(&kPoints[0][0])).clone();
}

void expectPoints(InputArray given, const char* layout)
{
    const Mat_<double> points = pointsFrom(given, 3, "objectPoints");
    ASSERT_EQ(points.size(), Size(3, 5)) << layout;
    EXPECT_TRUE(points.isContinuous()) << layout;
    EXPECT_EQ(cv::norm(points, reference(), NORM_INF), 0) << layout;
}

void expectRefused(InputArray given)
{
    expectError(Error::StsAssert, "objectPoints", [&] { pointsFrom(given, 3, "objectPoints"); });
}

template <class Point>
std::vector<Point> vectorOf()
{
    std::vector<Point> points;
    for (const auto& p : kPoints)
        points.emplace_back(static_cast<typename Point::value_type>(p[0]),
                            static_cast<typename Point::value_type>(p[1]),
                            static_cast<typename Point::value_type>(p[2]));
    return points;
}

TEST(Gmlpnp_Arrays, matrices)
{
    for (const int depth : {CV_32F, CV_64F}) {
        Mat rows;
        reference().convertTo(rows, depth);
        expectPoints(rows, "Nx3");
        expectPoints(rows.reshape(3), "Nx1, 3 channels");
        expectPoints(rows.reshape(3, 1), "1xN, 3 channels");
        const int column[] = {5, 1, 3}, row[] = {1, 5, 3};
        expectPoints(rows.reshape(1, 3, column), "Nx1x3");
        expectPoints(rows.reshape(1, 3, row), "1xNx3");
        expectPoints(rows.getUMat(ACCESS_READ), "UMat");
        expectPoints(rows.reshape(3).getUMat(ACCESS_READ), "UMat of points");
    }
}

TEST(Gmlpnp_Arrays, vectorsAndFixedSizes)
{
    expectPoints(vectorOf<Point3f>(), "vector<Point3f>");
    expectPoints(vectorOf<Point3d>(), "vector<Point3d>");
    expectPoints(vectorOf<Vec3f>(), "vector<Vec3f>");
    expectPoints(vectorOf<Vec3d>(), "vector<Vec3d>");
    expectPoints(Matx<double, 5, 3>(&kPoints[0][0]), "Matx");
    expectPoints(Mat_<double>(reference()), "Mat_");
    expectPoints(reference() * 1.0, "matrix expression");
}

TEST(Gmlpnp_Arrays, slices)
{
    for (const int depth : {CV_32F, CV_64F}) {
        Mat wide(9, 7, depth, Scalar(99)), rows;
        reference().convertTo(rows, depth);
        Mat slice = wide(Rect(2, 3, 3, 5));
        rows.copyTo(slice);
        ASSERT_FALSE(slice.isContinuous());
        expectPoints(slice, "block");

        Mat points(5, 4, CV_MAKETYPE(depth, 3), Scalar::all(99));
        Mat column = points.col(2);
        rows.reshape(3).copyTo(column);
        ASSERT_FALSE(column.isContinuous());
        expectPoints(column, "column of points");
        expectPoints(Mat(points.t()).row(2), "row of points");
    }
}

TEST(Gmlpnp_Arrays, onePointAndASquare)
{
    EXPECT_EQ(pointsFrom(Mat(1, 3, CV_64F, Scalar(2)), 3, "p").size(), Size(3, 1));
    EXPECT_EQ(pointsFrom(Mat(1, 1, CV_32FC3, Scalar::all(2)), 3, "p").size(), Size(3, 1));
    Mat square = (Mat_<double>(3, 3) << 1, 2, 3, 4, 5, 6, 7, 8, 9);
    EXPECT_EQ(pointsFrom(square, 3, "p")(0, 1), 2);  // rows are points
    EXPECT_EQ(pointsFrom(std::vector<Point2f>(4), 2, "p").size(), Size(2, 4));
}

TEST(Gmlpnp_Arrays, theInputIsNotWrittenNorCopiedWithoutNeed)
{
    const Mat rows = reference();
    const Mat_<double> points = pointsFrom(rows, 3, "objectPoints");
    EXPECT_EQ(points.ptr(), rows.ptr());
}

TEST(Gmlpnp_Arrays, refusedPoints)
{
    expectRefused(Mat(5, 3, CV_32S, Scalar(1)));
    expectRefused(Mat(5, 3, CV_8U, Scalar(1)));
    expectRefused(std::vector<Point3i>(5));
    expectRefused(Mat(3, 5, CV_64F, Scalar(1)));
    expectRefused(Mat(5, 2, CV_64F, Scalar(1)));
    expectRefused(Mat(5, 4, CV_64F, Scalar(1)));
    expectRefused(Mat(5, 3, CV_64FC3, Scalar::all(1)));
    expectRefused(Mat(5, 2, CV_64FC3, Scalar::all(1)));
    expectRefused(Mat());
    expectRefused(noArray());
    expectRefused(Mat(0, 3, CV_64F));
    expectRefused(std::vector<Point3d>());
    expectRefused(std::vector<Point2d>(5));
    expectRefused(std::vector<double>(15));
    expectRefused(std::vector<Mat>(5, Mat(3, 1, CV_64F, Scalar(1))));
    expectRefused(std::vector<std::vector<Point3d>>(2, std::vector<Point3d>(5)));
    const int cube[] = {5, 2, 3}, deep[] = {1, 1, 5, 3};
    expectRefused(Mat(3, cube, CV_64F, Scalar(1)));
    expectRefused(Mat(4, deep, CV_64F, Scalar(1)));
}

TEST(Gmlpnp_Arrays, refusalSaysWhatItGot)
{
    expectError(Error::StsAssert, "3x5 of CV_32S", [] { pointsFrom(Mat(3, 5, CV_32S, Scalar(1)), 3, "p"); });
    expectError(Error::StsAssert, "3x4 of CV_64F", [] { matrixFrom(Mat::eye(3, 4, CV_64F), 3, 3, "K"); });
}

TEST(Gmlpnp_Arrays, matricesOfAnyDepth)
{
    const Mat K = (Mat_<double>(3, 3) << 50, 0, 32, 0, 51, 24, 0, 0, 1);
    for (const int depth : {CV_8U, CV_8S, CV_16U, CV_16S, CV_32S, CV_32F, CV_64F}) {
        Mat given;
        K.convertTo(given, depth);
        EXPECT_EQ(cv::norm(matrixFrom(given, 3, 3, "K"), K, NORM_INF), 0) << depth;
    }
    Mat wide(3, 5, CV_64F, Scalar(7));
    Mat slice = wide.colRange(1, 4);
    K.copyTo(slice);
    const Mat_<double> dense = matrixFrom(slice, 3, 3, "K");
    EXPECT_TRUE(dense.isContinuous());
    EXPECT_EQ(cv::norm(dense, K, NORM_INF), 0);
    EXPECT_EQ(cv::norm(matrixFrom(Matx33f(K), 3, 3, "K"), K, NORM_INF), 0);
    EXPECT_EQ(cv::norm(matrixFrom(K.getUMat(ACCESS_READ), 3, 3, "K"), K, NORM_INF), 0);
}

TEST(Gmlpnp_Arrays, refusedMatrices)
{
    const std::vector<double> nine(9, 1.0);
    for (const Mat& bad : {Mat(3, 4, CV_64F), Mat(2, 3, CV_64F), Mat(), Mat(nine), Mat(3, 3, CV_64FC2)})
        expectError(Error::StsAssert, "K", [&] { matrixFrom(bad, 3, 3, "K"); });
    expectError(Error::StsAssert, "K", [&] { matrixFrom(nine, 3, 3, "K"); });
    expectError(Error::StsAssert, "K", [] { matrixFrom(noArray(), 3, 3, "K"); });
}

}  // namespace
}  // namespace opencv_test
