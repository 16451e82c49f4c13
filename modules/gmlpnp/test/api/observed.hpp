// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_TEST_GMLPNP_OBSERVED_HPP
#define OPENCV_TEST_GMLPNP_OBSERVED_HPP

#include <functional>

#include "../camera/camera_util.hpp"
#include "../scenes.hpp"

// Matches of a scene through a lens, some of them wrong, and what RANSAC says of them.

namespace opencv_test {
namespace ransac {

using namespace camera;
using gmlpnp::Params;
using gmlpnp::RansacParams;
using gmlpnp::Result;

// Pixels of the scene in a lens, with noise; the last of them anywhere. Points may lie anywhere around the camera.
struct Observed
{
    Scene scene;
    Mat_<double> pixels;
    int good;
};

inline Observed observed(cv::RNG& rng, const CameraModel& lens, int n, double outliers, double px, bool flat = false)
{
    std::vector<Vector3d> points;
    Observed out;
    out.pixels.create(n, 2);
    Point2d pixel;
    while (static_cast<int>(points.size()) < n)
        for (const Vector3d& X : flat ? boxPoints(rng, n, true) : surroundingPoints(rng, n))
            if (static_cast<int>(points.size()) < n && lens.projectPoint(Vec3d(X.x(), X.y(), X.z()), pixel) &&
                std::abs(pixel.x) < 4000 && std::abs(pixel.y) < 4000) {
                const int i = static_cast<int>(points.size());
                out.pixels(i, 0) = pixel.x + rng.gaussian(px);
                out.pixels(i, 1) = pixel.y + rng.gaussian(px);
                points.push_back(X);
            }
    out.scene = exactScene(rng, points);
    out.good = n - static_cast<int>(std::lround(outliers * n));
    const Mat all = out.pixels.clone();
    for (int i = out.good; i < n; ++i)  // the pixel of another point: as wrong matches are
        for (int k = 0; k < 2; ++k)
            out.pixels(i, k) = all.at<double>(rng.uniform(0, n), k) + rng.uniform(-100., 100.);
    return out;
}

inline Ptr<CameraModel> paperLens()
{
    return CameraModel::pinhole(paperCamera());
}

inline std::vector<int> rowsOf(const Mat& inliers)
{
    EXPECT_EQ(CV_32SC1, inliers.type());
    EXPECT_EQ(1, inliers.cols);
    return {inliers.begin<int>(), inliers.end<int>()};
}

// Rows that have a ray and whose reprojection error is at most the threshold.
inline std::vector<int> withinThreshold(const CameraModel& lens, const Observed& data, const Result& result,
                                        double threshold)
{
    const Pose pose = poseOf(result);
    std::vector<int> rows;
    for (int i = 0; i < data.pixels.rows; ++i) {
        const double* p = data.scene.objectPoints[i];
        const Vector3d X = pose * Vector3d(p[0], p[1], p[2]);
        Point2d pixel;
        Vec3d ray;
        if (lens.unprojectPoint({data.pixels(i, 0), data.pixels(i, 1)}, ray) &&
            lens.projectPoint(Vec3d(X.x(), X.y(), X.z()), pixel) &&
            std::hypot(pixel.x - data.pixels(i, 0), pixel.y - data.pixels(i, 1)) <= threshold)
            rows.push_back(i);
    }
    return rows;
}

inline void repeat(cv::RNG& rng, Mat_<double>& points, Mat_<double>& pixels, int row, double px)
{
    points.push_back(points.row(row).clone());
    pixels.push_back(pixels.row(row).clone());
    pixels(pixels.rows - 1, 0) += rng.uniform(-px, px);
    pixels(pixels.rows - 1, 1) += rng.uniform(-px, px);
}

}  // namespace ransac
}  // namespace opencv_test

#endif  // OPENCV_TEST_GMLPNP_OBSERVED_HPP
