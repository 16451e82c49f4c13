// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <sstream>

#include "common/isotropy_report.hpp"

namespace {

using namespace samples;

//! Adds noise to a point; called once a point, `pair` counts up.
using Disturb = std::function<cv::Vec3d(cv::RNG&, size_t pair)>;

constexpr size_t kPairs = 12, kPoints = 15;

//! Pairs of pictures of points with noise, their pixels exact.
std::vector<TrueResidual> residualsWith(const Disturb& noise, uint64_t seed)
{
    cv::RNG random(seed);
    std::vector<TrueResidual> residuals;
    for (size_t pair = 0; pair < kPairs; ++pair) {
        CorrespondenceSet set;
        set.cameraMatrix = cv::Matx33d(500, 0, 320, 0, 510, 240, 0, 0, 1);
        set.hasTruth = true;
        set.truth = poseFromRotationVector({0.3, -0.2, 0.4}, {0.1, -0.2, 0.3});
        for (size_t i = 0; i < kPoints; ++i) {
            const double z = random.uniform(1.0, 6.0);
            const cv::Vec3d X(z * random.uniform(-0.6, 0.6), z * random.uniform(-0.4, 0.4), z);
            cv::Point2d pixel;
            EXPECT_TRUE(set.camera()->projectPoint(X, pixel));
            set.imagePoints.push_back(pixel);
            set.objectPoints.emplace_back(set.truth.R.t() * (X - set.truth.t) + noise(random, pair));
        }
        addTrueResiduals(set, pair, residuals);
    }
    return residuals;
}

cv::Vec3d gaussian(cv::RNG& random, double deviation)
{
    return {random.gaussian(deviation), random.gaussian(deviation), random.gaussian(deviation)};
}

//! Isotropic, with the tails of a Student-t of 3 degrees of freedom.
cv::Vec3d heavyTailed(cv::RNG& random, size_t)
{
    const cv::Vec3d e = gaussian(random, 0.01), chi = gaussian(random, 1.0);
    return e * std::sqrt(3.0 / chi.dot(chi));
}

//! Whatever direction a pair errs in, all its points err alike.
Disturb sharedByPair()
{
    return [last = kPairs, common = cv::Vec3d()](cv::RNG& random, size_t pair) mutable {
        if (pair != last)
            common = gaussian(random, 0.02);
        last = pair;
        return cv::Vec3d(common + gaussian(random, 0.005));
    };
}

//! The share of 100 scenes with p < 10 %, by points and by pairs.
cv::Vec2d rejections(const std::function<Disturb()>& noise)
{
    cv::Vec2d share;
    for (uint64_t scene = 0; scene < 100; ++scene) {
        const Isotropy test = testIsotropy(residualsWith(noise(), 100 + scene), scene);
        share += cv::Vec2d(test.pointsP < 0.1 ? 0.01 : 0.0, test.pairsP < 0.1 ? 0.01 : 0.0);
    }
    return share;
}

TEST(Isotropy, residualsLieAcrossTheirRays)
{
    const auto residuals = residualsWith(heavyTailed, 1);
    ASSERT_EQ(residuals.size(), kPairs * kPoints);
    for (const TrueResidual& r : residuals) {
        EXPECT_LT(std::abs(r.object.dot(r.ray)), 1e-12);
        EXPECT_NEAR(cv::norm(r.ray), 1.0, 1e-12);
    }
    const Isotropy test = testIsotropy(residuals, 1);
    EXPECT_NEAR(cv::trace(test.moments), cv::trace(test.isotropic), 1e-15);
    for (const TrueResidual& r : residualsWith([](cv::RNG&, size_t) { return cv::Vec3d(); }, 1))
        EXPECT_LT(cv::norm(r.object), 1e-12);
}

TEST(Isotropy, theResidualIsTheShortestWayToTheRay)
{
    CorrespondenceSet set;
    set.truth.t = cv::Vec3d(0.0, 0.0, 1.0);
    set.objectPoints = {{0.1, 0.0, 1.0}, {0.0, 0.0, -3.0}};  // the second is behind the camera
    set.imagePoints = {{0.0, 0.0}, {0.0, 0.0}};
    std::vector<TrueResidual> residuals;
    addTrueResiduals(set, 4, residuals);
    ASSERT_EQ(residuals.size(), 1u);
    EXPECT_EQ(residuals[0].pair, 4u);
    EXPECT_LT(cv::norm(residuals[0].object - cv::Vec3d(0.1, 0.0, 0.0)), 1e-15);
    EXPECT_NEAR(residuals[0].depth, 2.0, 1e-15);
}

TEST(Isotropy, rejectsIsotropicNoiseNoOftenerThanItSays)
{
    const cv::Vec2d share = rejections([] { return Disturb(heavyTailed); });
    for (int i = 0; i < 2; ++i) {  // 10 % of 100 scenes, 3.3 standard errors
        EXPECT_LT(share[i], 0.2);
        EXPECT_GT(share[i], 0.0);
    }
}

TEST(Isotropy, pairsThatShareAnErrorFoolOnlyTheTestOfPoints)
{
    const cv::Vec2d share = rejections(sharedByPair);
    EXPECT_GT(share[0], 0.8);
    EXPECT_LT(share[1], 0.2);
}

TEST(Isotropy, findsTheDirectionOfTheNoise)
{
    const auto noise = [](cv::RNG& random, size_t) { return cv::Vec3d(random.gaussian(0.03), 0.0, 0.0); };
    const Isotropy test = testIsotropy(residualsWith(noise, 3), 3);
    EXPECT_LT(test.pointsP, 0.001);
    EXPECT_LT(test.pairsP, 0.01);
    EXPECT_GT(test.moments(0, 0), 5.0 * test.moments(1, 1));
    EXPECT_GT(test.distance, 0.3);
}

TEST(Isotropy, needsResiduals)
{
    EXPECT_THROW(testIsotropy({}, 1), std::runtime_error);
}

TEST(Isotropy, residualsAreWrittenWithTheTest)
{
    const std::vector<TrueResidual> residuals = {{0, {1, 2, 3}, {0.5, 0, 0}, {0, 0, 1}, 7}};
    Isotropy isotropy;
    isotropy.moments = cv::Matx33d::diag(cv::Vec3d(0.25, 0, 0));
    isotropy.isotropic = cv::Matx33d::diag(cv::Vec3d(0.125, 0.125, 0));
    isotropy.distance = 0.5;
    isotropy.pairsP = 0.25;
    const std::string path = ::testing::TempDir() + "gmlpnp_true_residuals.csv";
    const std::vector<std::string> pairs = {"pair"};
    writeTrueResiduals(path, residuals, isotropy, {"study", {"map", {"east", "north", "up"}}, "m", pairs});
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    EXPECT_EQ(text.str(),
              "# kind isotropy\n# title study\n# frame map\n# axes east north up\n# unit m\n"
              "# moments 0.25 0 0 0 0 0 0 0 0\n# isotropic 0.125 0 0 0 0.125 0 0 0 0\n# distance 0.5\n# p_residuals 1\n"
              "# p_pairs 0.25\n# Object frame; e leads from the ray to the object point.\n"
              "pair,X,Y,Z,ex,ey,ez,depth,ray_x,ray_y,ray_z\n"
              "pair,1,2,3,0.5,0,0,7,0.000000000,0.000000000,1.000000000\n");
}

}  // namespace
