// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

// Memory of calls with many points, by the most that was resident. A process of its own for each test: the peak never
// falls.

#include <gtest/gtest.h>

#include <sys/resource.h>

#include <iostream>
#include <vector>

#include "opencv2/gmlpnp.hpp"
#include "sanitized.hpp"

namespace {

const bool cannotMeasure = SANITIZED != 0;  // shadow memory is resident too

double peakBytes()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return 1024. * static_cast<double>(usage.ru_maxrss);
}

struct Data
{
    std::vector<cv::Point3d> points;
    std::vector<cv::Point2d> pixels;
};

const cv::Matx33d K(800, 0, 320, 0, 800, 240, 0, 0, 1);

Data noisyData(int n)
{
    cv::RNG rng(7);
    Data data;
    data.points.reserve(n);
    data.pixels.reserve(n);
    for (int i = 0; i < n; ++i) {
        const cv::Vec3d X(rng.uniform(-2., 2.), rng.uniform(-2., 2.), rng.uniform(4., 8.));
        data.points.emplace_back(X[0] + rng.gaussian(.1), X[1] + rng.gaussian(.05), X[2] + rng.gaussian(.02));
        data.pixels.emplace_back(800 * X[0] / X[2] + 320, 800 * X[1] / X[2] + 240);
    }
    return data;
}

void solvePose(const Data& data)
{
    cv::Vec3d rvec, tvec;
    ASSERT_TRUE(cv::gmlpnp::solvePnP(data.points, data.pixels, K, cv::noArray(), rvec, tvec));
}

void solveAndSay(const Data& data)
{
    cv::gmlpnp::Result result;
    ASSERT_TRUE(cv::gmlpnp::solve(data.points, data.pixels, K, cv::noArray(), result));
}

class Memory : public testing::Test
{
protected:
    void SetUp() override
    {
        if (cannotMeasure)
            GTEST_SKIP() << "resident memory says nothing under a sanitizer";
    }

    // Bytes a point beside the caller's arrays.
    template <class Call>
    void expectAtMost(double bytes, const Call& call)
    {
        const int n = 1000000;
        call(noisyData(1000));  // what a first call sets up
        const Data data = noisyData(n);
        const double before = peakBytes();
        call(data);
        const double found = (peakBytes() - before) / n;
        std::cout << found << " bytes a point" << std::endl;
        RecordProperty("bytes", std::to_string(found));
        EXPECT_GT(found, 48);  // or nothing was measured
        EXPECT_LT(found, bytes);
    }
};

TEST_F(Memory, ofAPose)
{
    expectAtMost(88, solvePose);
}

TEST_F(Memory, ofEverything)
{
    expectAtMost(112, solveAndSay);
}

TEST_F(Memory, ofTenMillionPoints)
{
    const Data data = noisyData(10000000);
    solveAndSay(data);
    std::cout << peakBytes() / 1e9 << " GB in all" << std::endl;
    EXPECT_LT(peakBytes(), 2e9);
}

}  // namespace
