// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../../src/camera/common.hpp"
#include "../../src/camera/distortion.hpp"
#include "camera_util.hpp"

namespace opencv_test {
namespace {

using camera::spaced;
using gmlpnp::detail::Distortion;
using gmlpnp::detail::firstPositiveRoot;
using gmlpnp::detail::solveIncreasing;

const double kInf = std::numeric_limits<double>::infinity();

// Coefficients of c0 (1 - x / r_1) (1 - x / r_2) ...
std::vector<double> withRoots(const std::vector<double>& roots)
{
    std::vector<double> c = {1};
    for (const double r : roots) {
        c.push_back(0);
        for (size_t i = c.size() - 1; i > 0; --i)
            c[i] -= c[i - 1] / r;
    }
    return c;
}

double firstRoot(const std::vector<double>& c)
{
    return firstPositiveRoot(c.data(), static_cast<int>(c.size()) - 1);
}

TEST(Gmlpnp_CameraCommon, firstPositiveRoot)
{
    EXPECT_EQ(firstRoot({1}), kInf);
    EXPECT_EQ(firstRoot({1, 2, 3}), kInf);
    EXPECT_EQ(firstRoot({1, -2, 5}), kInf);  // complex roots
    EXPECT_NEAR(firstRoot({1, 0, -4}), 0.5, 1e-15);
    EXPECT_NEAR(firstRoot({1, -0.25, 0, 0}), 4, 1e-14);
    EXPECT_NEAR(firstRoot({1, 0, 0, 0, -1}), 1, 1e-15);
    EXPECT_NEAR(firstRoot(withRoots({3, -1, 0.7, 5})), 0.7, 1e-13);
    EXPECT_NEAR(firstRoot(withRoots({-3, -1, -0.7, 2})), 2, 1e-12);
    EXPECT_NEAR(firstRoot(withRoots({1, 1.001, 2, 3, 4, 5})), 1, 1e-9);
    EXPECT_EQ(firstRoot(withRoots({-3, -1, -0.7})), kInf);
    EXPECT_NEAR(firstRoot({1, -1e-9}), 1e9, 1);
}

TEST(Gmlpnp_CameraCommon, firstPositiveRootIsApproachedFromBelow)
{
    RNG rng(20240917);
    for (int trial = 0; trial < 2000; ++trial) {
        std::vector<double> c(2 + trial % 6);
        c[0] = 1;
        for (size_t i = 1; i < c.size(); ++i)
            c[i] = rng.uniform(-2., 2.);
        const double root = firstRoot(c);
        const int degree = static_cast<int>(c.size()) - 1;
        for (int k = 0; k <= 1000; ++k) {
            const double x = std::min(root, 20.0) * k / 1000;
            ASSERT_GE(gmlpnp::detail::polynomial(c.data(), degree, x), -1e-12) << "trial " << trial << " at " << x;
        }
        if (root < kInf) {
            ASSERT_LE(gmlpnp::detail::polynomial(c.data(), degree, root * (1 + 1e-12)), 1e-12) << "trial " << trial;
        }
    }
}

TEST(Gmlpnp_CameraCommon, solveIncreasing)
{
    const auto cube = [](double x, double& slope) {
        slope = 3 * x * x;
        return x * x * x;
    };
    EXPECT_NEAR(solveIncreasing(cube, 8, 0, 10, 9, 1e-15), 2, 1e-15);
    EXPECT_NEAR(solveIncreasing(cube, 8, 0, 10, 0, 1e-15), 2, 1e-15);  // starts where the slope is zero
    EXPECT_EQ(solveIncreasing(cube, 0, 0, 10, 0, 1e-15), 0);
    const auto flat = [](double x, double& slope) {
        slope = 1 / (1 + x * x);
        return std::atan(x);
    };
    EXPECT_NEAR(solveIncreasing(flat, 1.5, 0, 1e6, 1e5, 1e-15), std::tan(1.5), 1e-13);  // plain Newton diverges
}

struct Case
{
    const char* name;
    std::vector<double> D;  // k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4
};

const Case kCases[] = {
    {"none", {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}},
    {"barrel", {-0.3, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}},
    {"wide", {-0.26, 0.10, 0.0003, -0.0002, 0, 0, 0, 0, 0, 0, 0, 0}},
    {"tum", {0.2624, -0.9531, -0.0054, 0.0026, 1.1633, 0, 0, 0, 0, 0, 0, 0}},
    {"pincushion", {0.5, 0.3, 0.001, 0.002, 0.1, 0, 0, 0, 0, 0, 0, 0}},
    {"rational", {0.47, -2.4, 0.0008, -0.0004, 1.7, 0.35, -2.2, 1.6, 0, 0, 0, 0}},
    {"pole", {0.1, 0, 0, 0, 0, -1.0, 0, 0, 0, 0, 0, 0}},
    {"tangential", {0, 0, 0.03, -0.05, 0, 0, 0, 0, 0, 0, 0, 0}},
    {"prism", {-0.1, 0.02, 0.001, 0.001, 0, 0, 0, 0, 0.05, -0.01, -0.03, 0.02}},
};

// Every point of the domain on a dense grid comes back, no matter how near to the fold.
TEST(Gmlpnp_CameraDistortion, inverseOverTheWholeDomain)
{
    for (const Case& c : kCases) {
        const Distortion distortion(c.D);
        int inside = 0, outside = 0;
        for (const double y : spaced(-3, 3.01, 117))
            for (const double x : spaced(-3, 3.02, 123)) {
                const Point2d u(x, y);
                Point2d back;
                Matx22d J, Jback;
                if (!distortion.contains(u)) {
                    ++outside;
                    continue;
                }
                ++inside;
                const Point2d d = distortion.apply(u, J);
                ASSERT_GT(determinant(J), 0) << c.name << u;
                ASSERT_TRUE(distortion.invert(d, back, Jback)) << c.name << u << determinant(J);
                // A residual e is an error of e / (smallest singular value of J), at most.
                ASSERT_LT(cv::norm(u - back), 2e-12 * (1 + cv::norm(d)) * cv::norm(J) / determinant(J)) << c.name << u;
            }
        EXPECT_GT(inside, 300) << c.name;
        RecordProperty(std::string(c.name) + "_outside", outside);
    }
}

// What the inverse returns is right and in the domain, also for distorted points that the domain does not reach.
TEST(Gmlpnp_CameraDistortion, inverseIsNeverWrong)
{
    for (const Case& c : kCases) {
        const Distortion distortion(c.D);
        for (const double y : spaced(-6, 6.01, 103))
            for (const double x : spaced(-6, 6.02, 107)) {
                Point2d u;
                Matx22d J;
                if (!distortion.invert({x, y}, u, J))
                    continue;
                ASSERT_TRUE(distortion.contains(u)) << c.name;
                ASSERT_LT(cv::norm(distortion.apply(u, J) - Point2d(x, y)), 2e-12 * (1 + std::hypot(x, y))) << c.name;
            }
    }
}

TEST(Gmlpnp_CameraDistortion, randomCoefficients)
{
    RNG rng(8);
    int inside = 0, lost = 0;
    for (int trial = 0; trial < 300; ++trial) {
        std::vector<double> D(12);
        const double sizes[] = {0.4, 0.3, 0.02, 0.02, 0.2, 0.3, 0.2, 0.1, 0.02, 0.01, 0.02, 0.01};
        for (int i = 0; i < 12; ++i)
            D[i] = (i >= 5 && trial % 2 == 0) ? 0 : rng.uniform(-sizes[i], sizes[i]);
        const Distortion distortion(D);
        for (int k = 0; k < 400; ++k) {
            const Point2d u(rng.uniform(-1.5, 1.5), rng.uniform(-1.5, 1.5));
            Point2d back;
            Matx22d J;
            if (!distortion.contains(u))
                continue;
            ++inside;
            const Point2d d = distortion.apply(u, J);
            const double conditioned = std::min(1.0, determinant(J) / (1 + cv::norm(J)));
            lost += !(distortion.invert(d, back, J) && cv::norm(u - back) * conditioned < 1e-12);
        }
    }
    EXPECT_GT(inside, 30000);
    EXPECT_EQ(lost, 0);
}

// 1 - 0.9 r^2 = 0: the turning point of r (1 - 0.3 r^2).
TEST(Gmlpnp_CameraDistortion, foldOfABarrel)
{
    const Distortion distortion(kCases[1].D);
    const double r = std::sqrt(1 / 0.9), edge = r * (1 - 0.3 * r * r);
    Point2d u;
    Matx22d J;
    EXPECT_TRUE(distortion.contains({r * (1 - 1e-12), 0}));
    EXPECT_FALSE(distortion.contains({r * (1 + 1e-12), 0}));
    ASSERT_TRUE(distortion.invert({0, edge * (1 - 1e-9)}, u, J));
    EXPECT_LT(u.y, r);
    EXPECT_GT(u.y, r * (1 - 1e-4));
    EXPECT_FALSE(distortion.invert({0, edge * (1 + 1e-9)}, u, J));
}

// However short the way to the fold is: at the centre there is no distortion.
TEST(Gmlpnp_CameraDistortion, theCentreIsAlwaysInTheDomain)
{
    for (const double p : {0., 0.1, 0.95, 100.}) {
        const Distortion distortion({0, 0, p, p, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
        EXPECT_TRUE(distortion.contains({0, 0})) << p;
        Point2d u(7, 7);
        Matx22d J;
        EXPECT_TRUE(distortion.invert({0, 0}, u, J)) << p;
        EXPECT_EQ(Point2d(0, 0), u) << p;
    }
}

TEST(Gmlpnp_CameraDistortion, jacobian)
{
    const double h = 2e-4;
    for (const Case& c : kCases) {
        const Distortion distortion(c.D);
        for (const Point2d& u : {Point2d(0, 0), Point2d(1e-8, -1e-8), Point2d(0.3, -0.2), Point2d(-0.6, -0.5)}) {
            Matx22d J, Jn, ignored;
            distortion.apply(u, J);
            for (int j = 0; j < 2; ++j) {
                const Point2d e = j == 0 ? Point2d(h, 0) : Point2d(0, h);
                const Point2d d = (distortion.apply(u - 2 * e, ignored) - distortion.apply(u + 2 * e, ignored) +
                                   8 * (distortion.apply(u + e, ignored) - distortion.apply(u - e, ignored))) /
                                  (12 * h);
                Jn(0, j) = d.x;
                Jn(1, j) = d.y;
            }
            EXPECT_LT(cv::norm(J - Jn), 1e-9) << c.name << u;
        }
    }
}

}  // namespace
}  // namespace opencv_test
