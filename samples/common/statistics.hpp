// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_SAMPLES_STATISTICS_HPP
#define GMLPNP_SAMPLES_STATISTICS_HPP

#include <cstdint>
#include <vector>

namespace samples {

/** An interval of 95 %; NaN at both ends where too few values are there to give one. */
struct Interval
{
    double low, high;
};

//! NaN without values.
double mean(const std::vector<double>& values);

//! The middle value, the upper one of two; NaN without values.
double median(std::vector<double> values);

/** 95 % interval of the mean of a series by the moving-block bootstrap (Kuensch, Annals of Statistics 1989): blocks of
cbrt(n) neighbours are drawn together, because pairs of images that share a frame err together. The percentiles are
spread from the mean by t / z sqrt(n / (n - 1)), which short series need (Hesterberg, The American Statistician 2015).
Equal values and seed give equal intervals. Fewer than three values give none. */
Interval bootstrapMean(const std::vector<double>& values, uint64_t seed);

}  // namespace samples

#endif  // GMLPNP_SAMPLES_STATISTICS_HPP
