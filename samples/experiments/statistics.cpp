// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <opencv2/core.hpp>

namespace experiments {

namespace {

constexpr int RESAMPLES = 1000;
constexpr double NONE = std::numeric_limits<double>::quiet_NaN();

// The statistic of all trials and of the resamples; `statistic(index, count)`.
template <class Statistic>
Interval interval(const std::vector<int>& indices, int trials, const Statistic& statistic)
{
    std::vector<int> identity(trials);
    for (int k = 0; k < trials; ++k)
        identity[k] = k;
    const double value = statistic(identity.data());
    std::vector<double> resampled;
    for (int r = 0; r < RESAMPLES; ++r) {
        const double one = statistic(&indices[static_cast<size_t>(r) * trials]);
        if (!std::isnan(one))
            resampled.push_back(one);
    }
    if (std::isnan(value) || resampled.empty())
        return {NONE, NONE, NONE};
    std::sort(resampled.begin(), resampled.end());
    const auto quantile = [&](double q) {
        return resampled[static_cast<size_t>(q * static_cast<double>(resampled.size() - 1))];
    };
    return {value, quantile(0.025), quantile(0.975)};
}

}  // namespace

Bootstrap::Bootstrap(int trials) : trials_(trials)
{
    cv::RNG rng(20240519);
    indices_.resize(static_cast<size_t>(RESAMPLES) * trials);
    for (int& index : indices_)
        index = rng.uniform(0, trials);
}

Interval Bootstrap::ratio(const std::vector<double>& values, const std::vector<double>& reference) const
{
    return interval(indices_, trials_, [&](const int* index) {
        double a = 0, b = 0;
        for (int k = 0; k < trials_; ++k) {
            const double x = values[index[k]], y = reference[index[k]];
            if (std::isnan(x) || std::isnan(y))
                continue;
            a += x;
            b += y;
        }
        return b > 0 ? a / b : NONE;
    });
}

Interval Bootstrap::mean(const std::vector<double>& values) const
{
    return ratio(values, std::vector<double>(values.size(), 1));
}

double median(std::vector<double> values)
{
    values.erase(std::remove_if(values.begin(), values.end(), [](double x) { return std::isnan(x); }), values.end());
    if (values.empty())
        return NONE;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return values.size() % 2 ? *middle : (*middle + *std::max_element(values.begin(), middle)) / 2;
}

int countNumbers(const std::vector<double>& values)
{
    return static_cast<int>(std::count_if(values.begin(), values.end(), [](double x) { return !std::isnan(x); }));
}

Interval share(int hits, int count)
{
    const double n = count, p = hits / n, z = 1.959964;
    const double middle = (p + z * z / (2 * n)) / (1 + z * z / n);
    const double half = z / (1 + z * z / n) * std::sqrt(p * (1 - p) / n + z * z / (4 * n * n));
    return {p, std::min(p, middle - half), std::max(p, middle + half)};  // equal at 0 and 1, but for rounding
}

}  // namespace experiments
