// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_RANSAC_SAMPLER_HPP
#define OPENCV_GMLPNP_RANSAC_SAMPLER_HPP

#include "../precomp.hpp"

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
    /** @param most samples that will be drawn: by half of them the pool holds every point, but for what is rounded up.
    Where the order means nothing the end of the list would not be looked at otherwise. */
    Sampler(int n, uint64 seed, bool ordered, int most)
        : n_(n),
          rng_(seed),
          pool_(ordered ? SAMPLE_SIZE : n),
          growing_(std::min(most * GROWING, ALL_SAMPLES)),
          samplesOfPool_(growing_)
    {
        for (int i = 0; i < SAMPLE_SIZE; ++i)
            samplesOfPool_ *= double(SAMPLE_SIZE - i) / (n - i);
    }

    Sample next()
    {
        ++drawn_;
        while (pool_ < n_ && drawn_ > endOfPool_)
            grow();
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

    /** Samples of all points that those drawn are as good as: ordered ones are the same, in another order, once the
    pool holds every point. */
    double ofAll() const { return pool_ < n_ ? 0 : drawn_ - roundedUp_; }

private:
    static constexpr double ALL_SAMPLES = 200000;  // after which the paper's pool holds every point
    static constexpr double GROWING = 0.5;         // share of the samples after which ours does, if these are fewer

    // The paper gives each pool a sample at least. Where there are too many points for that the later pools share them.
    void grow()
    {
        const double grown = samplesOfPool_ * (pool_ + 1) / (pool_ + 1 - SAMPLE_SIZE), more = grown - samplesOfPool_;
        const double whole = 2 * pool_ < growing_ ? std::ceil(more) : more;
        endOfPool_ += whole;
        roundedUp_ += whole - more;
        samplesOfPool_ = grown;
        ++pool_;
        newest_ = true;
    }

    int n_;
    RNG rng_;
    int pool_;
    bool newest_ = false;
    double growing_;  // samples until the pool holds every point, but for those rounded up
    double drawn_ = 0, endOfPool_ = 1, samplesOfPool_, roundedUp_ = 0;
};

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_RANSAC_SAMPLER_HPP
