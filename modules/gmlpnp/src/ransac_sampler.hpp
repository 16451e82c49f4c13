// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_RANSAC_SAMPLER_HPP
#define OPENCV_GMLPNP_RANSAC_SAMPLER_HPP

#include "precomp.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

constexpr int SAMPLE_SIZE = 3;
using Sample = std::array<int, SAMPLE_SIZE>;

/** Samples of three of n points: of all with equal probability, or best first (PROSAC: Chum and Matas 2005, Eq. (3)).
The same seed gives the same samples on every platform. */
class Sampler
{
public:
    Sampler(int n, uint64 seed, bool ordered) : n_(n), rng_(seed), pool_(ordered ? SAMPLE_SIZE : n)
    {
        for (int i = 0; i < SAMPLE_SIZE; ++i)
            samplesOfPool_ *= double(SAMPLE_SIZE - i) / (n - i);
    }

    Sample next()
    {
        ++drawn_;
        while (pool_ < n_ && drawn_ > endOfPool_) {
            const double grown = samplesOfPool_ * (pool_ + 1) / (pool_ + 1 - SAMPLE_SIZE);
            endOfPool_ += std::ceil(grown - samplesOfPool_);
            samplesOfPool_ = grown;
            ++pool_;
            newest_ = true;
        }
        // While a pool is new, its newest point is in each sample.
        Sample sample;
        const bool withNewest = newest_ && pool_ < n_;
        sample[0] = withNewest ? pool_ - 1 : rng_.uniform(0, pool_);
        for (int k = 1; k < SAMPLE_SIZE; ++k)
            do
                sample[k] = rng_.uniform(0, withNewest ? pool_ - 1 : pool_);
            while (std::find(sample.begin(), sample.begin() + k, sample[k]) != sample.begin() + k);
        return sample;
    }

    /** The points that samples have come from: the first so many. */
    int pool() const { return pool_; }

private:
    static constexpr double ALL_SAMPLES = 200000;  // after which the pool holds every point

    int n_;
    RNG rng_;
    int pool_;
    bool newest_ = false;
    double drawn_ = 0, endOfPool_ = 1, samplesOfPool_ = ALL_SAMPLES;
};

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_RANSAC_SAMPLER_HPP
