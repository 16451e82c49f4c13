// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "camera_util.hpp"

namespace opencv_test {
namespace {

using namespace camera;

const Matx33d kK = matrixK(190, 191, 320, 240, 0.5);

// The formula in long double, apart from the code under test.
Point2d oracle(const Vec3d& X, double xi, double alpha)
{
    const long double x = X[0], y = X[1], z = X[2], d1 = std::sqrt(x * x + y * y + z * z), z1 = xi * d1 + z;
    const long double d2 = std::sqrt(x * x + y * y + z1 * z1),
                      rho = alpha * d2 + (1 - static_cast<long double>(alpha)) * z1;
    return {static_cast<double>(kK(0, 0) * x / rho + kK(0, 1) * y / rho + kK(0, 2)),
            static_cast<double>(kK(1, 1) * y / rho + kK(1, 2))};
}

double limitOfSecondSphere(double alpha)
{
    return alpha <= 0.5 ? alpha / (1 - alpha) : (1 - alpha) / alpha;
}

// The ray to the point of the second sphere at cosine -w: (t sqrt(1 - w^2), -t w - xi) has length 1.
double endOfDomain(double xi, double alpha)
{
    const double w = limitOfSecondSphere(alpha), t = -w * xi + std::sqrt(w * w * xi * xi + 1 - xi * xi);
    return std::acos(std::max(-1.0, -t * w - xi));
}

// The bound of the paper, Z > -w2 d1.
double endOfDomainInThePaper(double xi, double alpha)
{
    const double w = limitOfSecondSphere(alpha);
    return std::acos(-(w + xi) / std::sqrt(2 * w * xi + xi * xi + 1));
}

const double kXis[] = {-0.6, -0.27, 0.0, 0.3, 0.7};
const double kAlphas[] = {0.0, 0.2, 0.45, 0.57, 0.8, 1.0};

TEST(Gmlpnp_CameraDoubleSphere, wholeDomain)
{
    for (const double xi : kXis)
        for (const double alpha : kAlphas) {
            const Ptr<CameraModel> camera = CameraModel::doubleSphere(kK, xi, alpha);
            const double end = endOfDomain(xi, alpha);
            Point2d pixel;
            Vec3d ray;
            for (const double angle : spaced(0, end - 2e-3, 200)) {
                const Vec3d m = direction(angle, 0.7);
                ASSERT_TRUE(camera->projectPoint(m, pixel)) << xi << " " << alpha << " " << angle;
                const Point2d expected = oracle(m, xi, alpha);
                ASSERT_LT(cv::norm(pixel - expected), 1e-10 * (1 + cv::norm(expected))) << xi << " " << alpha;
                ASSERT_TRUE(camera->unprojectPoint(pixel, ray)) << xi << " " << alpha;
                ASSERT_LT(cv::norm(ray - m), 1e-11) << xi << " " << alpha << " " << angle;
            }
            EXPECT_TRUE(camera->projectPoint(direction(end - 1e-7, 0.7), pixel)) << xi << " " << alpha;
            EXPECT_FALSE(camera->projectPoint(direction(end + 1e-7, 0.7), pixel)) << xi << " " << alpha;
        }
}

// Documents the departure from the paper, whose closed form is the domain at w = 1 and at xi = 0 only.
TEST(Gmlpnp_CameraDoubleSphere, theBoundOfThePaper)
{
    for (const double xi : kXis)
        EXPECT_NEAR(endOfDomainInThePaper(xi, 0.5), endOfDomain(xi, 0.5), 1e-7) << xi;
    for (const double alpha : kAlphas)
        EXPECT_NEAR(endOfDomainInThePaper(0, alpha), endOfDomain(0, alpha), 1e-7) << alpha;

    // Too narrow: wholeDomain above goes round the directions in between.
    EXPECT_GT(endOfDomain(0.3, 0.8), endOfDomainInThePaper(0.3, 0.8) + 1 * kDegree);

    // Too wide: a direction within it has the pixel of another one.
    const double xi = -0.6, alpha = 0.8;
    ASSERT_LT(endOfDomain(xi, alpha), endOfDomainInThePaper(xi, alpha) - 1 * kDegree);
    const Vec3d beyond = direction(endOfDomain(xi, alpha) + 0.5 * kDegree, 0.7);
    const Ptr<CameraModel> camera = CameraModel::doubleSphere(kK, xi, alpha);
    Vec3d other;
    ASSERT_TRUE(camera->unprojectPoint(oracle(beyond, xi, alpha), other));
    EXPECT_GT(cv::norm(other - beyond), 0.5 * kDegree);
    Point2d pixel;
    EXPECT_FALSE(camera->projectPoint(beyond, pixel));
}

TEST(Gmlpnp_CameraDoubleSphere, pixelsOfTheDomain)
{
    const double xi = -0.27, alpha = 0.7, radius = 190 / std::sqrt(2 * alpha - 1);
    const Ptr<CameraModel> camera = CameraModel::doubleSphere(kK, xi, alpha);
    Vec3d ray;
    EXPECT_TRUE(camera->unprojectPoint({320 + radius * (1 - 1e-9), 240}, ray));
    EXPECT_NEAR(std::acos(ray[2]), endOfDomain(xi, alpha), 1e-4);
    EXPECT_FALSE(camera->unprojectPoint({320 + radius * (1 + 1e-9), 240}, ray));
    EXPECT_TRUE(CameraModel::doubleSphere(kK, xi, 0.5)->unprojectPoint({1e6, -1e6}, ray));
}

TEST(Gmlpnp_CameraDoubleSphere, coincidingSpheresAreEucmWithBetaOne)
{
    const Ptr<CameraModel> ds = CameraModel::doubleSphere(kK, 0, 0.6), eucm = CameraModel::eucm(kK, 0.6, 1);
    for (const Vec3d& m : polarGrid(120 * kDegree)) {
        Point2d a, b;
        ASSERT_TRUE(ds->projectPoint(m, a));
        ASSERT_TRUE(eucm->projectPoint(m, b));
        ASSERT_LT(cv::norm(a - b), 1e-10) << m;
    }
}

}  // namespace
}  // namespace opencv_test
