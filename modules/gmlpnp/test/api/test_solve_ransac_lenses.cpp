// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "observed.hpp"

// RANSAC with rays in any direction.

namespace opencv_test {
namespace {

using namespace ransac;

TEST(Gmlpnp_SolveRansac, lensesBeyond180Degrees)
{
    cv::RNG rng = testRng();
    const Matx33d K = matrixK(300, 302, 640, 480);
    const std::vector<Ptr<CameraModel>> lenses = {
        CameraModel::fisheye(K, Vec4d(-0.02, 0.004, -0.001, 0.0001)),
        CameraModel::omnidir(K, Vec4d(-0.1, 0.02, 0, 0), 1.2), CameraModel::eucm(K, 0.65, 1.1),
        CameraModel::doubleSphere(K, -0.2, 0.6), CameraModel::equirectangular(Size(1600, 800))};
    for (size_t k = 0; k < lenses.size(); ++k)
        for (const double outliers : {0.1, 0.6}) {
            const Observed data = observed(rng, *lenses[k], 150, outliers, 0.5);
            Result result;
            Mat inliers;
            ASSERT_TRUE(solveRansac(data.scene.objectPoints, data.pixels, lenses[k], result, inliers)) << "lens " << k;
            EXPECT_TRUE(poseNear(result, data.scene.truth, 0.005, 0.02)) << "lens " << k;
            const std::vector<int> rows = rowsOf(inliers), expected = withinThreshold(*lenses[k], data, result, 8);
            // Across the seam of the panorama the picture says otherwise.
            EXPECT_TRUE(std::includes(rows.begin(), rows.end(), expected.begin(), expected.end())) << "lens " << k;
            EXPECT_LE(rows.size(), expected.size() + (k == 4 ? 3 : 0)) << "lens " << k;
        }
}

TEST(Gmlpnp_SolveRansac, seamOfAPanorama)
{
    // Half of the points appear at the left edge, of which half are seen at the right one.
    cv::RNG rng = testRng();
    const Ptr<CameraModel> lens = CameraModel::equirectangular(Size(2000, 1000));
    std::vector<Vector3d> points;
    Mat_<double> pixels(40, 2);
    for (int i = 0; i < 40; ++i) {
        const double turn = CV_PI - rng.uniform(0., 0.004), up = rng.uniform(-1., 1.);
        points.emplace_back(rng.uniform(3., 6.) * Vector3d(std::sin(turn), std::tan(up), std::cos(turn)));
        points.back().x() = i % 2 ? points.back().x() : rng.uniform(-3., 3.);
        Point2d pixel;
        ASSERT_TRUE(lens->projectPoint(Vec3d(points[i].x(), points[i].y(), points[i].z()), pixel));
        pixels(i, 0) = pixel.x + (i % 4 == 1 ? (pixel.x > 1000 ? -1999.5 : 1999.5) : 0);  // half a pixel off
        pixels(i, 1) = pixel.y;
    }
    const Scene scene = exactScene(rng, points);
    Result result;
    Mat inliers;
    ASSERT_TRUE(solveRansac(scene.objectPoints, pixels, lens, result, inliers));
    EXPECT_EQ(40, inliers.rows);
    EXPECT_TRUE(poseNear(result, scene.truth, 0.01, 0.05));
}

TEST(Gmlpnp_SolveRansac, rays)
{
    cv::RNG rng = testRng();
    for (const double threshold : {1e-6, 1e-3, 0.05}) {
        Scene scene = exactScene(rng, surroundingPoints(rng, 200));
        for (int i = 0; i < 120; ++i) {
            const Vector3d m = gaussian3(rng);
            for (int k = 0; k < 3; ++k)
                scene.rays(i, k) = m(k);
        }
        RansacParams ransac;
        ransac.threshold = threshold;
        Result result;
        Mat inliers;
        ASSERT_TRUE(solveRaysRansac(scene.objectPoints, scene.rays, result, inliers, ransac)) << threshold;
        EXPECT_TRUE(poseNear(result, scene.truth, threshold, 5 * threshold));
        EXPECT_GE(inliers.rows, 80);
        for (const int i : rowsOf(inliers)) {
            const Vector3d p(scene.objectPoints[i]), m(scene.rays[i]), X = poseOf(result) * p;
            EXPECT_LE(std::atan2(m.cross(X).norm(), m.dot(X)), threshold * (1 + 1e-9));
        }
    }
}

}  // namespace
}  // namespace opencv_test
