// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../scenes.hpp"

// Units and offsets are not in the pose.

namespace opencv_test {
namespace {

using namespace cv::gmlpnp::detail;
using cv::gmlpnp::Params;
using cv::gmlpnp::Result;

cv::Mat_<double> affine(const cv::Mat& points, double scale, const cv::Vec3d& offset)
{
    cv::Mat_<double> out(points.size());
    for (int i = 0; i < out.rows; ++i)
        for (int k = 0; k < 3; ++k)
            out(i, k) = scale * points.at<double>(i, k) + offset[k];
    return out;
}

// Metres and millimetres, with everything that has a unit of length: known noises, a guess, the threshold of RANSAC is
// in pixels.
TEST(Gmlpnp_Numerics, millimetres)
{
    cv::RNG rng = testRng();
    for (int k = 0; k < 4; ++k) {
        const Scene scene = paperScene(rng, 40, 0.05, 1);
        Params m = paramsOf(METHODS[k % 2]);
        if (k > 1) {  // these have no length in them
            m.bearingNoise = cv::Mat_<double>::eye(3, 3) * 1e-6;
            m.pixelCovariances = cv::Mat_<double>::ones(40, 1);
        }
        m.objectNoise = cv::Mat_<double>::eye(3, 3) * 0.0025;
        m.objectCovariances = cv::Mat_<double>::zeros(40, 9);
        for (int i = 0; i < 40; ++i)
            for (int axis = 0; axis < 3; ++axis)
                m.objectCovariances.at<double>(i, 4 * axis) = 1e-4 * (i + 1);
        m.useExtrinsicGuess = true;
        const Vector3d r = logSO3(scene.truth.R), t = scene.truth.t;
        m.rvec = {r.x() + 0.02, r.y(), r.z() - 0.03};
        m.tvec = {t.x(), t.y() + 0.1, t.z()};
        Params mm = m;
        mm.objectNoise = cv::Mat(m.objectNoise * 1e6);  // a new one: the arrays of Params are shared
        mm.objectCovariances = cv::Mat(m.objectCovariances * 1e6);
        mm.tvec = 1000 * m.tvec;
        Result a, b;
        ASSERT_TRUE(cv::gmlpnp::solve(scene.objectPoints, scene.imagePoints, paperCamera(), cv::noArray(), a, m));
        ASSERT_TRUE(cv::gmlpnp::solve(affine(scene.objectPoints, 1000, {}), scene.imagePoints, paperCamera(),
                                      cv::noArray(), b, mm));
        EXPECT_TRUE(poseNear(b, {poseOf(a).R, 1000 * poseOf(a).t}, 1e-11, 1e-8));
        EXPECT_LT(cv::norm(b.cameraCenterCovariance, 1e6 * a.cameraCenterCovariance),
                  1e-9 * cv::norm(b.cameraCenterCovariance));
        EXPECT_LT(cv::norm(b.bearingNoise, a.bearingNoise), 1e-9 * cv::norm(a.bearingNoise) + 1e-30);
    }
}

// Map coordinates in double: the offset costs no more than the rounding of the coordinates themselves (ECEF: 1e-9 m).
TEST(Gmlpnp_Numerics, mapCoordinates)
{
    const cv::Vec3d UTM(292742.252, 5731078.97, 186.663), ECEF(4041839.13, 624193.82, 4884512.07);
    cv::RNG rng = testRng();
    for (int method : METHODS)
        for (const cv::Vec3d& offset : {UTM, ECEF}) {
            const Scene scene = paperScene(rng, 60, 0.05, 1);
            const cv::Mat_<double> far = affine(scene.objectPoints, 1, offset);
            Result near, map;
            std::vector<int> inliersNear, inliersMap;
            ASSERT_TRUE(cv::gmlpnp::solve(scene.objectPoints, scene.imagePoints, paperCamera(), cv::noArray(), near,
                                          paramsOf(method)));
            ASSERT_TRUE(cv::gmlpnp::solve(far, scene.imagePoints, paperCamera(), cv::noArray(), map, paramsOf(method)));
            EXPECT_LT(rotationAngle(poseOf(near).R, poseOf(map).R), 1e-8);
            EXPECT_LT(cv::norm(map.cameraCenter - near.cameraCenter - offset), 1e-7);
            ASSERT_TRUE(cv::gmlpnp::solveRansac(scene.objectPoints, scene.imagePoints, paperCamera(), cv::noArray(),
                                                near, inliersNear, {}, paramsOf(method)));
            ASSERT_TRUE(cv::gmlpnp::solveRansac(far, scene.imagePoints, paperCamera(), cv::noArray(), map, inliersMap,
                                                {}, paramsOf(method)));
            EXPECT_EQ(inliersNear, inliersMap);
            EXPECT_LT(cv::norm(map.cameraCenter - near.cameraCenter - offset), 1e-7);
        }
}

}  // namespace
}  // namespace opencv_test
