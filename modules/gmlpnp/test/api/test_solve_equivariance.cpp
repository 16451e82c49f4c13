// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../scenes.hpp"

// Frames and units of the data are those of the result.

namespace opencv_test {
namespace {

using cv::gmlpnp::Params;
using cv::gmlpnp::Result;

cv::Mat_<double> affine(const cv::Mat_<double>& m, double scale, double offset = 0)
{
    cv::Mat_<double> out;
    m.convertTo(out, CV_64F, scale, offset);
    return out;
}

cv::Mat_<double> rotated(const Matrix3d& R, const cv::Mat_<double>& rows)
{
    cv::Mat_<double> out(rows.size());
    for (int i = 0; i < rows.rows; ++i) {
        const Vector3d v = R * Vector3d(rows(i, 0), rows(i, 1), rows(i, 2));
        for (int k = 0; k < 3; ++k)
            out(i, k) = v(k);
    }
    return out;
}

// UTM: what the offset costs is the rounding of the coordinates themselves.
TEST(Gmlpnp_Solve, largeOffsetsDoNotMatter)
{
    cv::RNG rng = testRng();
    const Vector3d offset(292742.252, 2731078.97, 186.663);
    for (int method : METHODS) {
        const Scene scene = paperScene(rng, 60, 0.1, 1);
        cv::Mat_<double> far = scene.objectPoints.clone();
        for (int i = 0; i < far.rows; ++i)
            for (int k = 0; k < 3; ++k)
                far(i, k) += offset(k);
        const Result near = solved(scene, paramsOf(method));
        const Result utm = solved(far, scene.rays, paramsOf(method));
        const Pose nearPose = poseOf(near), utmPose = poseOf(utm);
        EXPECT_LT(rotationAngle(nearPose.R, utmPose.R), 1e-8);
        const cv::Vec3d centre = near.cameraCenter + cv::Vec3d(offset.x(), offset.y(), offset.z());
        EXPECT_LT(cv::norm(utm.cameraCenter - centre), 1e-7);
        EXPECT_LT(cv::norm(near.cameraCenterCovariance, utm.cameraCenterCovariance),
                  1e-5 * cv::norm(near.cameraCenterCovariance));
        EXPECT_LT(cv::norm(near.objectNoise, utm.objectNoise), 1e-5 * cv::norm(near.objectNoise));
    }
}

// estimator.md: moving the object by a rigid G moves the pose by G^-1 and Sigma to R_G Sigma R_G^T.
TEST(Gmlpnp_Solve, equivariantUnderMotionOfTheObject)
{
    cv::RNG rng = testRng();
    for (int method : METHODS) {
        const Scene scene = paperScene(rng, 40, 0.1, 1);
        const Matrix3d G = randomRotation(rng);
        const Result a = solved(scene, paramsOf(method));
        const Result b = solved(affine(rotated(G, scene.objectPoints), 1, 5), scene.rays, paramsOf(method));
        const Pose pose = poseOf(a);
        const Matrix3d R = pose.R * G.transpose();
        EXPECT_TRUE(poseNear(b, {R, pose.t - R * Vector3d::Constant(5)}, 1e-8, 1e-7));
        EXPECT_TRUE(matrixNear(matrix3(b.objectNoise), G * matrix3(a.objectNoise) * G.transpose(), 1e-7));
        EXPECT_NEAR(a.cost, b.cost, 1e-6);
    }
}

// Scaling the scene leaves R, scales t and Sigma and shifts L by 2 n log k.
TEST(Gmlpnp_Solve, equivariantUnderScale)
{
    cv::RNG rng = testRng();
    for (int method : METHODS)
        for (double k : {1e-6, 1e3, 1e9}) {
            const Scene scene = paperScene(rng, 40, 0.1, 1);
            const Result a = solved(scene, paramsOf(method));
            const Result b = solved(affine(scene.objectPoints, k), scene.rays, paramsOf(method));
            const Pose pose = poseOf(a);
            EXPECT_TRUE(poseNear(b, {pose.R, k * pose.t}, 1e-9, 1e-8 * k));
            EXPECT_LT(cv::norm(b.objectNoise, k * k * a.objectNoise), 1e-7 * k * k);
            EXPECT_LT(cv::norm(b.bearingNoise, a.bearingNoise), 1e-9);
            EXPECT_NEAR(b.cost, a.cost + 2 * 40 * std::log(k), 1e-6);
            EXPECT_LT(cv::norm(b.cameraCenterCovariance, k * k * a.cameraCenterCovariance), 1e-7 * k * k);
        }
}

// Rotating the camera frame rotates R, t and Gamma.
TEST(Gmlpnp_Solve, equivariantUnderRotationOfTheCamera)
{
    cv::RNG rng = testRng();
    for (int method : METHODS) {
        const Scene scene = paperScene(rng, 40, 0.02, 3);
        const Matrix3d C = randomRotation(rng);
        const Result a = solved(scene, paramsOf(method));
        const Result b = solved(scene.objectPoints, rotated(C, scene.rays), paramsOf(method));
        const Pose pose = poseOf(a);
        EXPECT_TRUE(poseNear(b, {C * pose.R, C * pose.t}, 1e-8, 1e-7));
        EXPECT_TRUE(matrixNear(matrix3(b.bearingNoise), C * matrix3(a.bearingNoise) * C.transpose(), 1e-9));
        EXPECT_NEAR(a.cost, b.cost, 1e-6);
    }
}

}  // namespace
}  // namespace opencv_test
