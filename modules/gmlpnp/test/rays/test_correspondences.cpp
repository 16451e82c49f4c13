// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../../src/rays/correspondences.hpp"
#include "../scenes.hpp"

namespace opencv_test {
namespace {

using namespace cv::gmlpnp::detail;

cv::Mat_<double> affine(const cv::Mat_<double>& m, double scale, double offset)
{
    cv::Mat_<double> out;
    m.convertTo(out, CV_64F, scale, offset);
    return out;
}

TEST(Gmlpnp_Correspondences, areCentredScaledAndUnit)
{
    cv::RNG rng = testRng();
    const Scene scene = paperScene(rng, 40, 0.1, 1);
    const Correspondences data(affine(scene.objectPoints, 1000, 5e5), affine(scene.rays, 7, 0));
    Vector3d mean = Vector3d::Zero();
    double square = 0;
    for (int i = 0; i < data.size(); ++i) {
        mean += data.pointAt(i) / data.size();
        square += data.pointAt(i).squaredNorm() / data.size();
        EXPECT_NEAR(data.scaledRayAt(i).norm(), 1, 1e-15);
    }
    EXPECT_TRUE(matrixNear(mean, Vector3d::Zero(), 1e-12));
    EXPECT_NEAR(square, 1, 1e-12);
}

TEST(Gmlpnp_Correspondences, posesGoToTheObjectFrameAndBack)
{
    cv::RNG rng = testRng();
    const Scene scene = paperScene(rng, 20, 0.1, 1);
    const cv::Mat_<double> points = affine(scene.objectPoints, 3, 100);
    const Correspondences data(points, scene.rays);
    const Pose pose{randomRotation(rng), gaussian3(rng)}, normalised = data.fromObject(pose);
    EXPECT_TRUE(poseNear(data.toObject(normalised), pose, 1e-14, 1e-12));
    for (int i = 0; i < data.size(); ++i) {
        const Vector3d p(points(i, 0), points(i, 1), points(i, 2));
        EXPECT_TRUE(matrixNear(pose * p, data.scale * (normalised * data.pointAt(i)), 1e-11));
    }
}

TEST(Gmlpnp_Correspondences, degenerateIsALineAPlaceOrOneDirection)
{
    cv::RNG rng = testRng();
    const Scene scene = paperScene(rng, 12, 0.1, 1);
    cv::Mat_<double> line(12, 3), place(12, 3, 3.7e6), flat = scene.objectPoints.clone(), oneRay(12, 3);
    for (int i = 0; i < 12; ++i) {
        const double x = rng.uniform(-1., 1.);
        line(i, 0) = 1 + x, line(i, 1) = 2 - 3 * x, line(i, 2) = 0.3 * x;
        flat(i, 2) = 0;
        oneRay(i, 0) = 0.1, oneRay(i, 1) = 0.2, oneRay(i, 2) = 1;
    }
    EXPECT_TRUE(Correspondences(line, scene.rays).degenerate());
    EXPECT_TRUE(Correspondences(affine(line, 1, 1e6), scene.rays).degenerate());
    EXPECT_TRUE(Correspondences(place, scene.rays).degenerate());
    EXPECT_TRUE(Correspondences(scene.objectPoints, oneRay).degenerate());
    EXPECT_FALSE(Correspondences(flat, scene.rays).degenerate());
    EXPECT_FALSE(Correspondences(affine(scene.objectPoints, 1, 1e7), scene.rays).degenerate());
}

TEST(Gmlpnp_Correspondences, finiteSeesEveryBadNumber)
{
    cv::RNG rng = testRng();
    const Scene scene = paperScene(rng, 5, 0.1, 1);
    EXPECT_TRUE(Correspondences(scene.objectPoints, scene.rays).finite());
    for (double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL})
        for (int k = 0; k < 3; ++k) {
            cv::Mat_<double> points = scene.objectPoints.clone(), rays = scene.rays.clone();
            points(4, k) = bad;
            rays(3, k) = bad;
            EXPECT_FALSE(Correspondences(points, scene.rays).finite());
            EXPECT_FALSE(Correspondences(scene.objectPoints, rays).finite());
        }
    cv::Mat_<double> zeroRay = scene.rays.clone();
    zeroRay.row(2) = 0;
    EXPECT_FALSE(Correspondences(scene.objectPoints, zeroRay).finite());
}

TEST(Gmlpnp_Correspondences, aPartIsOfTheWholeAndSpreadOverIt)
{
    cv::RNG rng = testRng();
    const Scene scene = paperScene(rng, 1000, 0.1, 1);
    const Correspondences all(scene.objectPoints, scene.rays), part = all.part(300);
    ASSERT_EQ(300, part.size());
    EXPECT_EQ(all.scale, part.scale);
    EXPECT_EQ(all.centre, part.centre);
    EXPECT_TRUE(part.finite());
    EXPECT_FALSE(part.degenerate());
    int i = 0;  // each of its points is one of all, in their order, at most two stretches behind the one before
    for (int k = 0; k < part.size(); ++k, ++i) {
        const int first = i;
        while (i < all.size() && all.pointAt(i) != part.pointAt(k))
            ++i;
        ASSERT_LT(i, all.size());
        EXPECT_LE(i - first, 7);
        EXPECT_LT((all.scaledRayAt(i) - part.scaledRayAt(k)).norm(), 1e-15);
    }
}

TEST(Gmlpnp_Correspondences, aPartKnowsTheCovariancesOfItsPoints)
{
    cv::RNG rng = testRng();
    const Scene scene = paperScene(rng, 100, 0.1, 1);
    cv::Mat_<double> known(100, 9, 0.0);
    for (int i = 0; i < 100; ++i)
        known(i, 0) = known(i, 4) = known(i, 8) = scene.objectPoints(i, 0) * scene.objectPoints(i, 0);
    const Correspondences all(Observations{scene.objectPoints, scene.rays, known, {}}), part = all.part(30);
    for (int k = 0; k < part.size(); ++k) {
        const double x = part.pointAt(k).x() + part.centre.x() / part.scale;
        EXPECT_NEAR(x * x, part.knownObject(k)(2, 2), 1e-12);
    }
}

}  // namespace
}  // namespace opencv_test
