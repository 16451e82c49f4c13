// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_TEST_GMLPNP_KERNEL_DATA_HPP
#define OPENCV_TEST_GMLPNP_KERNEL_DATA_HPP

#include "../../src/rays/ray_pass.hpp"
#include "../scenes.hpp"

// Data for the loops of an instruction set, and how nearly two of them agree.

namespace opencv_test {
namespace kernels {

using namespace cv::gmlpnp::detail;

// Every number of lanes that the last block may lack, and a large number of points.
inline std::vector<int> sizesFor(const RayKernels& kernels)
{
    std::vector<int> out = {203};
    for (int n = std::max(2, kernels.lanes); n <= 40; ++n)
        out.push_back(n);
    return out;
}

inline Correspondences randomData(cv::RNG& rng, int n, bool known)
{
    const Scene scene = exactScene(rng, surroundingPoints(rng, n));
    cv::Mat_<double> points = scene.objectPoints.clone(), object, rays;
    for (double& x : points)
        x += rng.gaussian(0.05);
    if (known) {
        object.create(n, 9);
        rays.create(n, 9);
        for (int i = 0; i < n; ++i) {
            Eigen::Map<Matrix3d>{object[i]} = randomNoise(rng, 0.1);
            Eigen::Map<Matrix3d>{rays[i]} = randomNoise(rng, 0.01);
        }
    }
    return Correspondences(Observations{points, scene.rays, object, rays});
}

inline Pose somePose(cv::RNG& rng)
{
    return {randomRotation(rng), 2 * gaussian3(rng)};
}

inline testing::AssertionResult near(double a, double b, double size)
{
    constexpr double ROUNDING = 1e-12;  // of sums of 200 terms in another order, and with fused multiplications
    if (std::abs(a - b) <= ROUNDING * (std::abs(size) + 1e-300))
        return testing::AssertionSuccess();
    return testing::AssertionFailure() << a << " and " << b << " differ by " << a - b;
}

template <class Matrix>
testing::AssertionResult near(const Matrix& a, const Matrix& b)
{
    return matrixNear(a, b, 1e-11 * a.norm());
}

}  // namespace kernels
}  // namespace opencv_test

#endif  // OPENCV_TEST_GMLPNP_KERNEL_DATA_HPP
