// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_EXPERIMENTS_STATISTICS_HPP
#define GMLPNP_EXPERIMENTS_STATISTICS_HPP

#include <vector>

namespace experiments {

/** A value and its 95 % interval. */
struct Interval
{
    double value, low, high;
};

/** Resamples of trials for the percentile bootstrap, 1000 of them with a fixed seed: drawn once, so that solvers are
compared on the same resamples. */
class Bootstrap
{
public:
    explicit Bootstrap(int trials);

    /** Mean over the trials whose value is a number. */
    Interval mean(const std::vector<double>& values) const;
    /** Mean of `values` divided by the mean of `reference`, over the trials where both are numbers. */
    Interval ratio(const std::vector<double>& values, const std::vector<double>& reference) const;

private:
    int trials_;
    std::vector<int> indices_;
};

/** Median of the numbers among the values; not a number where there are none. */
double median(std::vector<double> values);

int countNumbers(const std::vector<double>& values);

/** Wilson's interval of a share. */
Interval share(int hits, int count);

}  // namespace experiments

#endif  // GMLPNP_EXPERIMENTS_STATISTICS_HPP
