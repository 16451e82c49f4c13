// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_TEST_GMLPNP_STARTED_HPP
#define OPENCV_TEST_GMLPNP_STARTED_HPP

#include "../../src/estimator/initial_pose.hpp"
#include "../../src/estimator/kinds_of_noise.hpp"
#include "../scenes.hpp"

// Problems with the isotropic pose that the estimator starts from.

namespace opencv_test {
namespace started {

using namespace cv::gmlpnp::detail;

struct Problem
{
    Correspondences data;
    Pose start;
};

inline Problem problem(const Scene& scene)
{
    const Correspondences data(scene.objectPoints, scene.rays);
    return {data, initialPoses(data).at(0).pose};
}

// Pixels of a flat-on object of +-30 px, or of depth 0.5 to 5 m, or object noise: what the data are made of is chosen.
inline Scene bearingScene(cv::RNG& rng, int n, double pixels)
{
    std::vector<Vector3d> points(n);
    for (Vector3d& X : points) {
        const double z = 0.5 * std::pow(10., rng.uniform(0., 1.));
        X = z * Vector3d(rng.uniform(-1., 1.), rng.uniform(-1., 1.), 1);
    }
    Scene scene = exactScene(rng, points);
    for (int i = 0; i < n; ++i) {
        scene.imagePoints(i, 0) += rng.gaussian(pixels);
        scene.imagePoints(i, 1) += rng.gaussian(pixels);
        const Vector3d m((scene.imagePoints(i, 0) - 320) / 800, (scene.imagePoints(i, 1) - 240) / 800, 1);
        for (int k = 0; k < 3; ++k)
            scene.rays(i, k) = m(k) / m.norm();
    }
    return scene;
}

// Rays, in radians, to a cube 75 times its side away.
inline Scene farScene(cv::RNG& rng, int n, double noise)
{
    std::vector<Vector3d> points(n);
    for (Vector3d& X : points)
        X = Vector3d(rng.uniform(-1., 1.), rng.uniform(-1., 1.), rng.uniform(-1., 1.)) + Vector3d(0, 0, 150);
    Scene scene = exactScene(rng, points);
    for (int i = 0; i < n; ++i)
        for (int a = 0; a < 2; ++a)
            scene.rays(i, a) += rng.gaussian(noise);
    return scene;
}

}  // namespace started
}  // namespace opencv_test

#endif  // OPENCV_TEST_GMLPNP_STARTED_HPP
