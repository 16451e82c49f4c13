// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_TEST_STATISTICS_HPP
#define OPENCV_GMLPNP_TEST_STATISTICS_HPP

#include "test_precomp.hpp"

#include <algorithm>
#include <cmath>
#include <string>

// Statements about random problems, in suites named ...Statistics (ctest label `statistics`). A cell is a test of its
// own with its own seed, so that one command reruns it. Another seed, or another rounding of the same sums, draws other
// problems: a true statement then fails with the probability that its line of output names.

namespace opencv_test {

/** Deviations that a statistic may be off by chance. A Gaussian one is off by more in 6e-5 of all draws, in 3e-5 on one
side: with two hundred statements one draw in a hundred of all of them fails somewhere. */
constexpr double SIGMAS = 4;

/** Each of the following says whether a statistic is one that chance allows where the statement is true. All print the
same line, also where they hold: test and cell, seed, value, bounds, probability of a false alarm. */

/** The true value lies from `low` to `high`, and `value` has this standard deviation. */
testing::AssertionResult within(double value, double low, double high, double deviation, double sigmas = SIGMAS);
testing::AssertionResult withinSigma(double value, double expected, double deviation, double sigmas = SIGMAS);
testing::AssertionResult atMost(double value, double high, double deviation, double sigmas = SIGMAS);

/** The true share lies from `low` to `high`: by the binomial distribution, not its Gaussian limit. */
testing::AssertionResult shareWithin(int count, int trials, double low, double high);
testing::AssertionResult shareAtMost(int count, int trials, double high);
testing::AssertionResult shareAtLeast(int count, int trials, double low);

/** Squared deviation in units of its covariance, as large as chi-squared with 6 degrees of freedom becomes. */
testing::AssertionResult asChiSquared6(double value);

/** A mean over problems, with its deviation. */
class Mean
{
public:
    void add(double value);
    double value() const;
    double deviation() const;

private:
    double count_ = 0, sum_ = 0, squares_ = 0;
};

/** The ratio of two means over the same problems. What both have in common cancels in its deviation (delta method). */
class RatioOfMeans
{
public:
    void add(double ours, double theirs);
    double value() const;
    double deviation() const;

private:
    double count_ = 0, ours_ = 0, theirs_ = 0, ours2_ = 0, theirs2_ = 0, product_ = 0;
};

/** Squared deviations of true poses in units of their covariances (NEES). */
class Consistency
{
public:
    void add(double nees);
    int trials() const { return trials_; }
    /** Those within the 95 % ellipsoid. */
    int inside() const { return inside_; }
    double mean() const { return sum_ / trials_; }
    /** Deviation of the mean where the covariances are true: chi-squared with 6 degrees of freedom. */
    double deviation() const { return std::sqrt(12. / trials_); }

private:
    int trials_ = 0, inside_ = 0;
    double sum_ = 0;
};

/** What a method and a cell are called in the name of their test. */
inline std::string methodName(int method)
{
    return method == cv::gmlpnp::SOLVEPNP_GMLPNP ? "published" : "marginal";
}

/** A number as part of a name: 0p05 is 0.05. */
inline std::string nameOfNumber(const testing::TestParamInfo<double>& info)
{
    std::string name = cv::format("%g", info.param);
    std::replace(name.begin(), name.end(), '.', 'p');
    std::replace(name.begin(), name.end(), '-', 'm');
    return name;
}

template <class Cell>
std::string nameOf(const testing::TestParamInfo<Cell>& info)
{
    return info.param.name();
}

}  // namespace opencv_test

#endif  // OPENCV_GMLPNP_TEST_STATISTICS_HPP
