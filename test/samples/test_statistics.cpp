// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include <opencv2/core.hpp>

#include "common/progress.hpp"
#include "common/statistics.hpp"

namespace {

using namespace samples;

//! How often the interval holds the true mean, zero, of series whose neighbours have the correlation `rho`.
double coverage(int length, double rho, int series)
{
    cv::RNG random(20261122);
    int covered = 0;
    for (int s = 0; s < series; ++s) {
        std::vector<double> values;
        double state = random.gaussian(1.0);
        for (int i = 0; i < length; ++i) {
            values.push_back(state);
            state = rho * state + std::sqrt(1.0 - rho * rho) * random.gaussian(1.0);
        }
        const Interval interval = bootstrapMean(values, static_cast<uint64_t>(s));
        covered += interval.low <= 0.0 && 0.0 <= interval.high ? 1 : 0;
    }
    return static_cast<double>(covered) / series;
}

TEST(Statistics, intervalHoldsTheMeanAsOftenAsItSays)
{
    // 200 series: 3.3 standard errors of 95 % are 5.1 %.
    EXPECT_GT(coverage(40, 0.0, 200), 0.899);
    EXPECT_GT(coverage(5, 0.0, 400), 0.85) << "short series have no better than about 90 %";
    // Blocks of neighbours do not forget their correlation; single values would cover 86 % here.
    EXPECT_GT(coverage(100, 0.3, 200), 0.88);
}

TEST(Statistics, equalSeedsGiveEqualIntervals)
{
    std::vector<double> values;
    for (int i = 0; i < 30; ++i)
        values.push_back(std::exp(std::sin(7.0 * i)));
    const Interval a = bootstrapMean(values, 7), b = bootstrapMean(values, 7), c = bootstrapMean(values, 8);
    EXPECT_EQ(a.low, b.low);
    EXPECT_EQ(a.high, b.high);
    EXPECT_NE(a.low, c.low);
    EXPECT_LT(a.low, mean(values));
    EXPECT_GT(a.high, mean(values));
}

TEST(Statistics, tooFewValuesGiveNone)
{
    EXPECT_TRUE(std::isnan(bootstrapMean({1.0, 2.0}, 1).low));
    EXPECT_TRUE(std::isnan(mean({})));
    EXPECT_TRUE(std::isnan(median({})));
    EXPECT_EQ(median({5.0, 1.0, 3.0}), 3.0);
}

TEST(ProgressBar, endsFullAndIsSilentWhereNobodyLooks)
{
    std::ostringstream shown, hidden;
    {
        Progress bar(3, "pairs", shown, true), silent(3, "pairs", hidden, false);
        for (int i = 0; i < 3; ++i) {
            bar.step();
            silent.step();
        }
    }
    EXPECT_NE(shown.str().find("[##########                    ] 1/3 pairs"), std::string::npos) << shown.str();
    EXPECT_NE(shown.str().find("[##############################] 3/3 pairs, 0:00 left"), std::string::npos);
    EXPECT_EQ(shown.str().back(), '\n');
    EXPECT_EQ(hidden.str(), "");
}

}  // namespace
