// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "common/residuals.hpp"

namespace {

using namespace samples;

const cv::Matx33d kSigma(4e-4, 1e-4, 0, 1e-4, 3e-4, -1e-4, 0, -1e-4, 9e-4), kGamma(1e-6, 0, 0, 0, 2e-6, 0, 0, 0, 1e-6);

cv::gmlpnp::Result resultWith(const cv::Matx33d& Sigma, const cv::Matx33d& Gamma)
{
    cv::gmlpnp::Result result;
    result.rvec = cv::Vec3d(0.2, -0.1, 0.3);
    result.tvec = cv::Vec3d(0.1, 0.2, 4.0);
    result.objectNoise = cv::Mat(Sigma, true);
    result.bearingNoise = cv::Mat(Gamma, true);
    return result;
}

//! The triangular L with L L^T = C; its product with normal numbers has the covariance C.
cv::Matx33d cholesky(const cv::Matx33d& C)
{
    cv::Matx33d L = cv::Matx33d::zeros();
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j <= i; ++j) {
            double rest = C(i, j);
            for (int k = 0; k < j; ++k)
                rest -= L(i, k) * L(j, k);
            L(i, j) = i == j ? std::sqrt(rest) : rest / L(j, j);
        }
    return L;
}

//! Points seen from the result's pose with the result's own noise.
CorrespondenceSet sceneOf(const cv::gmlpnp::Result& result, int count, double noise)
{
    cv::RNG random(4711);
    const auto normal = [&](const cv::Matx33d& covariance) {
        return noise * (cholesky(covariance) * cv::Vec3d(random.gaussian(1), random.gaussian(1), random.gaussian(1)));
    };
    CorrespondenceSet set;
    set.path = "scene.txt";
    set.cameraMatrix = cv::Matx33d(500, 0, 320, 0, 510, 240, 0, 0, 1);
    set.distCoeffs = {0.1, -0.2, 0.001, 0.002};
    const Pose pose = poseFromRotationVector(result.rvec, result.tvec);
    const auto camera = cv::gmlpnp::CameraModel::pinhole(set.cameraMatrix, set.distCoeffs);
    for (int i = 0; i < count; ++i) {
        const cv::Vec3d p(random.uniform(-1., 1.), random.uniform(-1., 1.), random.uniform(-1., 1.)), X = pose * p;
        cv::Point2d pixel;
        EXPECT_TRUE(camera->projectPoint(X + cv::norm(X) * normal(kGamma), pixel));
        set.objectPoints.emplace_back(p + normal(kSigma));
        set.imagePoints.push_back(pixel);
    }
    return set;
}

TEST(Residuals, vanishForExactData)
{
    const cv::gmlpnp::Result result = resultWith(kSigma, kGamma);
    const std::vector<Residual> residuals = residualsOf(sceneOf(result, 30, 0.0), result);
    ASSERT_EQ(residuals.size(), 30u);
    for (const Residual& r : residuals) {
        EXPECT_LT(cv::norm(r.pixels), 1e-9);
        EXPECT_LT(cv::norm(r.object), 1e-9);
        EXPECT_TRUE(r.inside);
    }
}

TEST(Residuals, leadFromTheRayToTheObjectPoint)
{
    // Also for a Sigma of rank one, where the residual must stay in its range.
    for (const cv::Matx33d& Sigma : {kSigma, cv::Matx33d(1e-4, 0, 0, 0, 0, 0, 0, 0, 0)}) {
        const cv::gmlpnp::Result result = resultWith(Sigma, kGamma);
        const CorrespondenceSet set = sceneOf(result, 30, 1.0);
        const Pose pose = poseFromRotationVector(result.rvec, result.tvec);
        const auto camera = cv::gmlpnp::CameraModel::pinhole(set.cameraMatrix, set.distCoeffs);
        const std::vector<Residual> residuals = residualsOf(set, result);
        ASSERT_EQ(residuals.size(), set.objectPoints.size());
        for (size_t i = 0; i < residuals.size(); ++i) {
            cv::Vec3d ray;
            ASSERT_TRUE(camera->unprojectPoint(set.imagePoints[i], ray));
            const cv::Vec3d onRay = pose * cv::Vec3d(set.objectPoints[i]) - residuals[i].object;
            EXPECT_LT(cv::norm(onRay.cross(ray)), 1e-9);
        }
    }
}

TEST(Residuals, ninetyFivePercentOfThemAreInsideForTheTrueNoise)
{
    const cv::gmlpnp::Result result = resultWith(kSigma, kGamma);
    const std::vector<Residual> residuals = residualsOf(sceneOf(result, 4000, 1.0), result);
    const auto inside = std::count_if(residuals.begin(), residuals.end(), [](const Residual& r) { return r.inside; });
    const double share = static_cast<double>(inside) / static_cast<double>(residuals.size());
    EXPECT_NEAR(share, 0.95, 4.0 * std::sqrt(0.95 * 0.05 / 4000.0));
}

TEST(Residuals, ellipsesOfTails)
{
    EXPECT_NEAR(squaredRadiusOf95Percent(0.0), 5.991464547107979, 1e-12);
    EXPECT_NEAR(squaredRadiusOf95Percent(1e-9), 5.991464547107979, 1e-6);
    EXPECT_NEAR(squaredRadiusOf95Percent(1.0), 6.25 * 2.0 * 19.0, 1e-9);  // twice the F distribution's, 2 and 2

    cv::RNG random(1);
    const double reach = squaredRadiusOf95Percent(0.2);
    int inside = 0;
    for (int k = 0; k < 40000; ++k) {
        const double normal = -2.0 * std::log(random.uniform(0.0, 1.0));
        const double studentT = 12.5 * (1.0 / random.uniform(0.0, 1.0) - 1.0);
        inside += (random.uniform(0.0, 1.0) < 0.2 ? studentT : normal) < reach;
    }
    EXPECT_NEAR(inside / 40000.0, 0.95, 4.0 * std::sqrt(0.95 * 0.05 / 40000.0));
}

TEST(Residuals, ofAnyCamera)
{
    const cv::gmlpnp::Result result = resultWith(kSigma, kGamma);
    CorrespondenceSet set = sceneOf(result, 30, 0.0);
    const auto fisheye = cv::gmlpnp::CameraModel::fisheye(set.cameraMatrix);
    const Pose pose = poseFromRotationVector(result.rvec, result.tvec);
    for (size_t i = 0; i < set.objectPoints.size(); ++i)
        ASSERT_TRUE(fisheye->projectPoint(pose * cv::Vec3d(set.objectPoints[i]), set.imagePoints[i]));
    const std::vector<Residual> residuals = residualsOf(*fisheye, set, result);
    ASSERT_EQ(residuals.size(), set.objectPoints.size());
    for (const Residual& r : residuals)
        EXPECT_LT(cv::norm(r.pixels), 1e-9);
}

TEST(Residuals, bearingNoiseInPixels)
{
    const auto camera =
        cv::gmlpnp::CameraModel::fisheye(cv::Matx33d(300, 0, 320, 0, 200, 240, 0, 0, 1));  // px per rad, any angle
    const cv::Matx33d Gamma(4e-6, 1e-6, 0, 1e-6, 9e-6, 0, 0, 0, 25e-6);
    const PixelScale middle = meanPixelScale(*camera, {{320, 240}}, Gamma);
    EXPECT_LT(cv::norm(middle.bearingNoise - cv::Matx22d(0.36, 0.06, 0.06, 0.36)), 1e-9);
    EXPECT_NEAR(middle.pixelsPerRadian, std::sqrt(300.0 * 200.0), 1e-9);
    // 90 degrees to the right: the noise along the axis now moves the pixel along u, by as much as in the middle;
    // around the axis, there are pi / 2 times as many pixels to a radian.
    const PixelScale right = meanPixelScale(*camera, {{320 + 150 * CV_PI, 240}}, Gamma);
    EXPECT_LT(cv::norm(right.bearingNoise - cv::Matx22d(25e-6 * 9e4, 0, 0, 9e-6 * 1e4 * CV_PI * CV_PI)), 1e-9);
    EXPECT_EQ(meanPixelScale(*camera, {}, Gamma).pixelsPerRadian, 0.0);
}

TEST(Residuals, areWrittenInARowEach)
{
    const cv::gmlpnp::Result result = resultWith(kSigma, kGamma);
    CorrespondenceSet set = sceneOf(result, 30, 1.0);
    set.unit = "m";
    set.imageSize = {640, 480};
    const std::vector<Residual> residuals = residualsOf(set, result);
    const std::string path = ::testing::TempDir() + "gmlpnp_residuals.csv";
    writeResiduals(path, set, residuals, "GMLPNP");
    std::ifstream stream(path);
    std::string head, line;
    while (std::getline(stream, line) && line[0] == '#')
        head += line + "\n";
    EXPECT_EQ(head,
              "# kind residuals\n# title scene: 30 points, GMLPNP\n# unit m\n# image_size 640 480\n"
              "# squared_radius_95 5.99146455\n");
    EXPECT_EQ(line,
              "u,v,residual_u,residual_v,cov_uu,cov_uv,cov_vv,x,y,z,cov_xx,cov_xy,cov_xz,cov_yy,cov_yz,cov_zz,"
              "inside");
    for (const Residual& r : residuals) {
        std::vector<double> row;
        ASSERT_TRUE(std::getline(stream, line));
        std::istringstream cells(line);
        for (std::string cell; std::getline(cells, cell, ',');)
            row.push_back(std::stod(cell));
        ASSERT_EQ(row.size(), 17u) << line;
        EXPECT_NEAR(row[0], r.observed.x, 1e-6);
        EXPECT_NEAR(row[3], r.pixels[1], 1e-6);
        EXPECT_NEAR(row[6], r.pixelCovariance(1, 1), 1e-6);
        EXPECT_NEAR(row[9], r.object[2], 1e-6);
        EXPECT_NEAR(row[14], r.objectCovariance(1, 2), 1e-9);
        EXPECT_EQ(row[16] != 0.0, r.inside);
    }
    EXPECT_FALSE(std::getline(stream, line));
    EXPECT_THROW(writeResiduals(::testing::TempDir() + "missing_folder/x.csv", set, residuals, ""), std::runtime_error);
}

}  // namespace
