// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "wide_lens.hpp"

// Pixels without a ray take no part, and of a ray nothing but its direction does.

namespace opencv_test {
namespace {

using namespace wide;
using gmlpnp::Result;

// A lens that sees only the left half: masked points are left out and counted.
class LeftHalf : public cv::gmlpnp::CameraModel
{
public:
    bool unprojectPoint(const cv::Point2d& pixel, cv::Vec3d& ray, cv::Matx32d* jacobian) const override
    {
        return pixel.x < 320 && whole->unprojectPoint(pixel, ray, jacobian);
    }
    bool projectPoint(const cv::Vec3d& point, cv::Point2d& pixel) const override
    {
        return whole->projectPoint(point, pixel) && pixel.x < 320;
    }

private:
    cv::Ptr<cv::gmlpnp::CameraModel> whole = cv::gmlpnp::CameraModel::pinhole(paperCamera());
};

TEST(Gmlpnp_Solve, pixelsWithoutARayAreLeftOut)
{
    cv::RNG rng = testRng();
    const Scene scene = paperScene(rng, 60, 0.1, 1);
    cv::Mat_<double> points(0, 3), pixels(0, 2);
    for (int i = 0; i < 60; ++i)
        if (scene.imagePoints(i, 0) < 320) {
            points.push_back(scene.objectPoints.row(i));
            pixels.push_back(scene.imagePoints.row(i));
        }
    ASSERT_GT(points.rows, 10);
    Result masked, chosen;
    ASSERT_TRUE(cv::gmlpnp::solve(scene.objectPoints, scene.imagePoints, cv::makePtr<LeftHalf>(), masked));
    const cv::Ptr<CameraModel> pinhole = CameraModel::pinhole(paperCamera());
    ASSERT_TRUE(cv::gmlpnp::solve(points, pixels, cv::makePtr<PlainLens>(pinhole), chosen));
    EXPECT_EQ(points.rows, masked.usedPoints);
    EXPECT_EQ(chosen.rvec, masked.rvec);
    EXPECT_EQ(chosen.tvec, masked.tvec);
}

// Its rays are as long as the caller happened to make them.
class CarelessLens : public PlainLens
{
public:
    using PlainLens::PlainLens;
    bool unprojectPoint(const cv::Point2d& pixel, cv::Vec3d& ray, cv::Matx32d* jacobian) const override
    {
        const bool seen = PlainLens::unprojectPoint(pixel, ray, jacobian);
        ray *= 1 + 1e-3 * std::abs(pixel.x);
        return seen;
    }
};

TEST(Gmlpnp_Solve, theLengthOfALensesRaysDoesNotMatter)
{
    cv::RNG rng = testRng();
    const Scene scene = paperScene(rng, 30, 0.05, 1);
    const cv::Ptr<CameraModel> pinhole = CameraModel::pinhole(paperCamera());
    Result plain, careless;
    ASSERT_TRUE(cv::gmlpnp::solve(scene.objectPoints, scene.imagePoints, cv::makePtr<PlainLens>(pinhole), plain));
    ASSERT_TRUE(cv::gmlpnp::solve(scene.objectPoints, scene.imagePoints, cv::makePtr<CarelessLens>(pinhole), careless));
    EXPECT_TRUE(poseNear(careless, poseOf(plain), 1e-9, 1e-9));
}

class Gmlpnp_SolveMasked : public testing::Test
{
protected:
    // Alpha above 1/2: pixels outside r^2 = 1 / (beta (2 alpha - 1)) have no ray.
    const Ptr<CameraModel> camera = wideEucm().camera;
    const Point2d outside{kCentre + 3 * kFocal, kCentre};

    void SetUp() override
    {
        Vec3d ray;
        ASSERT_FALSE(camera->unprojectPoint(outside, ray));
    }
};

TEST_F(Gmlpnp_SolveMasked, pixelsWithoutRayDoNotTakePart)
{
    cv::RNG rng = testRng();
    const WideScene scene = wideScene(rng, wideEucm(), 40);
    Mat_<double> pixels = scene.pixels.clone(), keptPoints(0, 3), keptPixels(0, 2);
    for (int i = 0; i < 40; ++i)
        if (i % 4 == 1) {
            pixels(i, 0) = outside.x + i;
            pixels(i, 1) = outside.y - i;
        } else {
            keptPoints.push_back(scene.points.row(i));
            keptPixels.push_back(scene.pixels.row(i));
        }
    Result masked, kept;
    ASSERT_TRUE(gmlpnp::solve(scene.points, pixels, camera, masked));
    ASSERT_TRUE(gmlpnp::solve(keptPoints, keptPixels, camera, kept));
    EXPECT_EQ(30, masked.usedPoints);
    EXPECT_EQ(kept.rvec, masked.rvec);
    EXPECT_EQ(kept.tvec, masked.tvec);
    EXPECT_EQ(kept.cost, masked.cost);
    EXPECT_EQ(0, cv::norm(kept.poseCovariance, masked.poseCovariance, cv::NORM_INF));
    ASSERT_EQ(40, masked.weights.rows);
    for (int i = 0; i < 40; ++i)
        EXPECT_EQ(i % 4 == 1, masked.weights.at<double>(i) == 0) << i;
}

TEST_F(Gmlpnp_SolveMasked, tooFewRaysAreTooFewPoints)
{
    cv::RNG rng = testRng();
    const WideScene scene = wideScene(rng, wideEucm(), 12);
    for (int rays : {0, 3, 4}) {
        Mat_<double> pixels = scene.pixels.clone();
        for (int i = rays; i < 12; ++i)
            pixels(i, 0) = outside.x, pixels(i, 1) = outside.y;
        Result result;
        EXPECT_EQ(rays >= 4, gmlpnp::solve(scene.points, pixels, camera, result)) << rays;
        if (rays < 4) {
            EXPECT_EQ(gmlpnp::STATUS_TOO_FEW_POINTS, result.status) << rays;
        } else {
            EXPECT_EQ(rays, result.usedPoints);
        }
    }
}

}  // namespace
}  // namespace opencv_test
