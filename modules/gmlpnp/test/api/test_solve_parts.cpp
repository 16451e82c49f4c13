// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../scenes.hpp"
#include "../statistics.hpp"

namespace opencv_test {
namespace {

using cv::gmlpnp::Result;

struct Cell
{
    int method, n;
    double sigma;  // of the object noise
    int scenes;

    std::string name() const
    {
        return methodName(method) + cv::format("%dPoints%dMillimetres", n, cvRound(1000 * sigma));
    }
    friend void PrintTo(const Cell& cell, std::ostream* out) { *out << cell.name(); }
};

class Gmlpnp_PartsStatistics : public testing::TestWithParam<Cell>
{};

// Where only the pose is asked for, that of many points comes from a part of them and two passes over all: its mean
// error must be that of the estimate from all of them, to one part in a hundred.
TEST_P(Gmlpnp_PartsStatistics, thePoseOfManyPointsIsAsGoodAsFromAllOfThem)
{
    const Cell& cell = GetParam();
    cv::RNG rng = testRng();
    RatioOfMeans ratio;
    int different = 0;
    for (int k = 0; k < cell.scenes; ++k) {
        const Scene scene = paperScene(rng, cell.n, cell.sigma, 1);
        const Result result = solved(scene, paramsOf(cell.method));
        cv::Vec3d rvec, tvec;
        ASSERT_TRUE(cv::gmlpnp::solvePnP(scene.objectPoints, scene.imagePoints, paperCamera(), cv::noArray(), rvec,
                                         tvec, false, cell.method));
        const double byPart = rotationAngle(poseOf(rvec, tvec).R, scene.truth.R);
        const double byAll = rotationAngle(poseOf(result).R, scene.truth.R);
        ratio.add(byPart, byAll);
        different += byPart != byAll;
    }
    EXPECT_TRUE(atMost(ratio.value(), 1.01, ratio.deviation(), 2.5));
    EXPECT_LT(2.5 * ratio.deviation(), 0.1) << "too few scenes to tell";
    EXPECT_GT(different, 0) << "the part was not used";
}

std::vector<Cell> cells()
{
    std::vector<Cell> all;
    for (const int method : METHODS) {
        for (const double sigma : {0., 0.01, 0.1, 0.5})
            all.push_back({method, 1000, sigma, 600});
        for (const double sigma : {0.1, 0.5})
            all.push_back({method, 10000, sigma, 400});
    }
    return all;
}

INSTANTIATE_TEST_SUITE_P(/**/, Gmlpnp_PartsStatistics, testing::ValuesIn(cells()), nameOf<Cell>);

}  // namespace
}  // namespace opencv_test
