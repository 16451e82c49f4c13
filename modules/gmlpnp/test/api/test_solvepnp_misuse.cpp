// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../expect_error.hpp"
#include "reference.hpp"

// The contract of a drop-in for cv::solvePnP: what is refused.

namespace opencv_test {
namespace {

constexpr int FLAGS[] = {cv::gmlpnp::SOLVEPNP_GMLPNP, cv::gmlpnp::SOLVEPNP_GMLPNP_MARGINAL};

TEST(Gmlpnp_SolvePnP, wrongInputsAreRefusedByName)
{
    cv::RNG rng = testRng();
    const Reference r = reference(rng);
    const cv::Mat P = r.scene.objectPoints, U = r.scene.imagePoints;
    cv::Mat intP;
    P.convertTo(intP, CV_32S);
    cv::Mat rvec, tvec;
    for (int flag : FLAGS) {
        const auto call = [&](cv::InputArray p, cv::InputArray u, cv::InputArray K, cv::InputArray D) {
            return [=, &p, &u, &K, &D, &rvec, &tvec] { cv::gmlpnp::solvePnP(p, u, K, D, rvec, tvec, false, flag); };
        };
        const cv::Mat none, Pt = P.t(), three = P.rowRange(0, 3), threeU = U.rowRange(0, 3), fewer = U.rowRange(0, 11);
        expectError(cv::Error::StsAssert, "objectPoints", call(Pt, U, r.K, none));
        expectError(cv::Error::StsAssert, "objectPoints", call(intP, U, r.K, none));
        expectError(cv::Error::StsAssert, "objectPoints", call(none, U, r.K, none));
        expectError(cv::Error::StsAssert, "objectPoints", call(three, threeU, r.K, none));
        expectError(cv::Error::StsAssert, "imagePoints", call(P, fewer, r.K, none));
        expectError(cv::Error::StsAssert, "imagePoints", call(P, none, r.K, none));
        expectError(cv::Error::StsAssert, "imagePoints", call(P, P, r.K, none));
        const cv::Mat K34 = cv::Mat::eye(3, 4, CV_64F), K9 = cv::Mat::ones(9, 1, CV_64F),
                      K0 = cv::Mat::zeros(3, 3, CV_64F), D3 = cv::Mat::zeros(3, 1, CV_64F);
        expectError(cv::Error::StsAssert, "K", call(P, U, K34, none));
        expectError(cv::Error::StsAssert, "K", call(P, U, K9, none));
        expectError(cv::Error::StsAssert, "K", call(P, U, none, none));
        expectError(cv::Error::StsBadArg, "K", call(P, U, K0, none));
        expectError(cv::Error::StsAssert, "D", call(P, U, r.K, D3));
    }
    EXPECT_TRUE(rvec.empty());
    EXPECT_TRUE(tvec.empty());
}

TEST(Gmlpnp_SolvePnP, badDataIsFalseAndTouchesNothing)
{
    cv::RNG rng = testRng();
    const Reference r = reference(rng);
    const int n = r.scene.objectPoints.rows;
    cv::Mat_<double> line(n, 3), place(n, 3, 2.), onePixel(n, 2, 100.);
    for (int i = 0; i < n; ++i)
        line(i, 0) = 0.3 * i, line(i, 1) = -0.1 * i, line(i, 2) = 0.2 * i;
    cv::Mat_<double> nanP = r.scene.objectPoints.clone(), infU = r.scene.imagePoints.clone();
    nanP(2, 0) = std::nan("");
    infU(5, 1) = HUGE_VAL;
    const std::pair<cv::Mat, cv::Mat> cases[] = {{line, r.scene.imagePoints},
                                                 {place, r.scene.imagePoints},
                                                 {r.scene.objectPoints, onePixel},
                                                 {nanP, r.scene.imagePoints},
                                                 {r.scene.objectPoints, infU}};
    for (int flag : FLAGS)
        for (const auto& bad : cases) {
            cv::Vec3d rvec(1, 2, 3), tvec(4, 5, 6);
            EXPECT_FALSE(cv::gmlpnp::solvePnP(bad.first, bad.second, r.K, cv::noArray(), rvec, tvec, false, flag));
            EXPECT_EQ(cv::Vec3d(1, 2, 3), rvec);
            EXPECT_EQ(cv::Vec3d(4, 5, 6), tvec);
        }
}

}  // namespace
}  // namespace opencv_test
