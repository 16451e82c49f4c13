// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "test_precomp.hpp"

#include "scenes.hpp"
#include "statistics.hpp"

namespace opencv_test {

namespace {

constexpr double NO_BOUND = std::numeric_limits<double>::infinity();

double upperTail(double sigmas)
{
    return 0.5 * std::erfc(sigmas / std::sqrt(2.));
}

// NaN is outside.
testing::AssertionResult judged(double value, double low, double high, double falseAlarm)
{
    const testing::TestInfo* info = testing::UnitTest::GetInstance()->current_test_info();
    const std::string name = std::string(info->test_case_name()) + "." + info->name();
    const std::string line = cv::format("%s, seed %llu: %g in [%g, %g], false alarms %.0e", name.c_str(),
                                        static_cast<unsigned long long>(testSeed()), value, low, high, falseAlarm);
    std::cout << "[statistic ] " << line << std::endl;
    if (value >= low && value <= high)
        return testing::AssertionSuccess() << line;
    return testing::AssertionFailure() << "outside: " << line << "\nalone: --gtest_filter=" << name << "\n";
}

double binomial(int count, int trials, double share)
{
    if (share <= 0 || share >= 1)
        return count == (share <= 0 ? 0 : trials);
    return std::exp(std::lgamma(trials + 1.) - std::lgamma(count + 1.) - std::lgamma(trials - count + 1.) +
                    count * std::log(share) + (trials - count) * std::log1p(-share));
}

// The largest count that chance allows: more have a probability below `rare`.
int mostBy(int trials, double share, double rare)
{
    int count = trials;
    double tail = 0;
    while (count > 0 && tail + binomial(count, trials, share) < rare)
        tail += binomial(count--, trials, share);
    return count;
}

}  // namespace

testing::AssertionResult within(double value, double low, double high, double deviation, double sigmas)
{
    const double falseAlarm = (low == high ? 2 : 1) * upperTail(sigmas);
    return judged(value, low - sigmas * deviation, high + sigmas * deviation, falseAlarm);
}

testing::AssertionResult withinSigma(double value, double expected, double deviation, double sigmas)
{
    return within(value, expected, expected, deviation, sigmas);
}

testing::AssertionResult atMost(double value, double high, double deviation, double sigmas)
{
    return within(value, -NO_BOUND, high, deviation, sigmas);
}

testing::AssertionResult shareWithin(int count, int trials, double low, double high)
{
    const double rare = upperTail(SIGMAS);
    return judged(count, trials - mostBy(trials, 1 - low, rare), mostBy(trials, high, rare),
                  (low == high ? 2 : 1) * rare);
}

testing::AssertionResult shareAtMost(int count, int trials, double high)
{
    return shareWithin(count, trials, 0, high);
}

testing::AssertionResult shareAtLeast(int count, int trials, double low)
{
    return shareWithin(count, trials, low, 1);
}

testing::AssertionResult asChiSquared6(double value)
{
    constexpr double RARE = 1e-4, QUANTILE = 27.856;
    return judged(value, 0, QUANTILE, RARE);
}

void Mean::add(double value)
{
    ++count_;
    sum_ += value;
    squares_ += value * value;
}

double Mean::value() const
{
    return sum_ / count_;
}

double Mean::deviation() const
{
    return std::sqrt((squares_ / count_ - value() * value()) / count_);
}

void RatioOfMeans::add(double ours, double theirs)
{
    ++count_;
    ours_ += ours;
    theirs_ += theirs;
    ours2_ += ours * ours;
    theirs2_ += theirs * theirs;
    product_ += ours * theirs;
}

double RatioOfMeans::value() const
{
    return ours_ / theirs_;
}

double RatioOfMeans::deviation() const
{
    const double ratio = value();
    return std::sqrt(ours2_ - 2 * ratio * product_ + ratio * ratio * theirs2_) / theirs_;
}

void Consistency::add(double nees)
{
    ++trials_;
    sum_ += nees;
    inside_ += nees < CHI2_6_95;
}

}  // namespace opencv_test
