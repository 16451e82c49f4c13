// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../scenes.hpp"

namespace opencv_test {
namespace {

using cv::gmlpnp::Result;

// Where only the pose is asked for, that of many points comes from a part of them and two passes over all: its mean
// error must be that of the estimate from all of them, within what pairs of the same problems can tell.
TEST(Gmlpnp_Solve, thePoseOfManyPointsIsAsGoodAsFromAllOfThem)
{
    struct Cell
    {
        int n;
        double sigma;
        int scenes;
    };
    cv::RNG rng = testRng();
    for (int method : METHODS)
        for (const Cell& cell : {Cell{1000, 0, 600}, Cell{1000, 0.01, 600}, Cell{1000, 0.1, 600}, Cell{1000, 0.5, 600},
                                 Cell{10000, 0.1, 400}, Cell{10000, 0.5, 400}}) {
            double all = 0, more = 0, more2 = 0;
            for (int k = 0; k < cell.scenes; ++k) {
                const Scene scene = paperScene(rng, cell.n, cell.sigma, 1);
                const Result result = solved(scene, paramsOf(method));
                cv::Vec3d rvec, tvec;
                ASSERT_TRUE(cv::gmlpnp::solvePnP(scene.objectPoints, scene.imagePoints, paperCamera(), cv::noArray(),
                                                 rvec, tvec, false, method));
                const double error = rotationAngle(poseOf(result).R, scene.truth.R);
                const double difference = rotationAngle(poseOf(rvec, tvec).R, scene.truth.R) - error;
                all += error / cell.scenes;
                more += difference / cell.scenes;
                more2 += difference * difference / cell.scenes;
            }
            const double deviation = std::sqrt((more2 - more * more) / cell.scenes);
            std::cout << cv::format("method %d, %d points, %g m: %.3f +- %.3f\n", method, cell.n, cell.sigma,
                                    1 + more / all, 1.96 * deviation / all);
            EXPECT_LT(more - 2.5 * deviation, 0.01 * all) << "method " << method << ", sigma " << cell.sigma;
            EXPECT_LT(2.5 * deviation, 0.1 * all) << "too few scenes to tell";
            EXPECT_GT(more2, 0) << "the part was not used";
        }
}

}  // namespace
}  // namespace opencv_test
