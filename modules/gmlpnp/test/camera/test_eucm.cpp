// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "camera_util.hpp"

namespace opencv_test {
namespace {

using namespace camera;

const Matx33d kK = matrixK(300, 302, 320, 240, 0.5);

// The formula in long double, apart from the code under test.
Point2d oracle(const Vec3d& X, double alpha, double beta)
{
    const long double x = X[0], y = X[1], z = X[2], d = std::sqrt(beta * (x * x + y * y) + z * z);
    const long double rho = alpha * d + (1 - static_cast<long double>(alpha)) * z;
    return {static_cast<double>(kK(0, 0) * x / rho + kK(0, 1) * y / rho + kK(0, 2)),
            static_cast<double>(kK(1, 1) * y / rho + kK(1, 2))};
}

// Z = -w d on a unit ray: tan^2 = (1 / w^2 - 1) / beta behind the lens.
double endOfDomain(double alpha, double beta)
{
    const double w = alpha <= 0.5 ? alpha / (1 - alpha) : (1 - alpha) / alpha;
    return w == 0 ? CV_PI / 2 : CV_PI - std::atan(std::sqrt((1 / (w * w) - 1) / beta));
}

TEST(Gmlpnp_CameraEucm, wholeDomain)
{
    for (const double beta : {0.5, 1.0, 1.8})
        for (const double alpha : {0.0, 0.2, 0.45, 0.55, 0.7, 0.9, 1.0}) {
            const Ptr<CameraModel> camera = CameraModel::eucm(kK, alpha, beta);
            const double end = endOfDomain(alpha, beta);
            Point2d pixel;
            Vec3d ray;
            for (const double angle : spaced(0, end - 2e-3, 200)) {
                const Vec3d m = direction(angle, 0.7);
                ASSERT_TRUE(camera->projectPoint(m, pixel)) << alpha << " " << beta << " " << angle;
                const Point2d expected = oracle(m, alpha, beta);
                ASSERT_LT(cv::norm(pixel - expected), 1e-10 * (1 + cv::norm(expected))) << alpha << " " << beta;
                ASSERT_TRUE(camera->unprojectPoint(pixel, ray)) << alpha << " " << beta;
                ASSERT_LT(cv::norm(ray - m), 1e-11) << alpha << " " << beta << " " << angle;
            }
            EXPECT_TRUE(camera->projectPoint(direction(end - 1e-7, 0.7), pixel)) << alpha << " " << beta;
            EXPECT_FALSE(camera->projectPoint(direction(end + 1e-7, 0.7), pixel)) << alpha << " " << beta;
        }
}

TEST(Gmlpnp_CameraEucm, pixelsOfTheDomain)
{
    const double alpha = 0.7, beta = 1.2, radius = 300 / std::sqrt(beta * (2 * alpha - 1));
    const Ptr<CameraModel> camera = CameraModel::eucm(kK, alpha, beta);
    Vec3d ray;
    EXPECT_TRUE(camera->unprojectPoint({320 + radius * (1 - 1e-9), 240}, ray));
    EXPECT_NEAR(std::acos(ray[2]), endOfDomain(alpha, beta), 1e-4);
    EXPECT_FALSE(camera->unprojectPoint({320 + radius * (1 + 1e-9), 240}, ray));
    EXPECT_TRUE(CameraModel::eucm(kK, 0.5, beta)->unprojectPoint({1e6, -1e6}, ray));
}

TEST(Gmlpnp_CameraEucm, betaOneIsTheUnifiedCamera)
{
    // alpha = xi / (1 + xi); the focal lengths differ by 1 + xi.
    const double xi = 0.8;
    const Matx33d K = matrixK(300, 302, 320, 240), scaled = matrixK(300 * (1 + xi), 302 * (1 + xi), 320, 240);
    const Ptr<CameraModel> eucm = CameraModel::eucm(K, xi / (1 + xi), 1);
    const Ptr<CameraModel> mei = CameraModel::omnidir(scaled, noArray(), xi);
    for (const Vec3d& m : polarGrid(120 * kDegree)) {
        Point2d a, b;
        ASSERT_TRUE(eucm->projectPoint(m, a));
        ASSERT_TRUE(mei->projectPoint(m, b));
        ASSERT_LT(cv::norm(a - b), 1e-9) << m;
    }
}

TEST(Gmlpnp_CameraEucm, alphaZeroIsThePinhole)
{
    const Matx33d K = matrixK(300, 302, 320, 240);
    Mat a, b;
    CameraModel::eucm(K, 0, 1)->project(pointsInFront(3), a);
    CameraModel::pinhole(K)->project(pointsInFront(3), b);
    EXPECT_LT(cv::norm(a, b, NORM_INF), 1e-10);
}

}  // namespace
}  // namespace opencv_test
