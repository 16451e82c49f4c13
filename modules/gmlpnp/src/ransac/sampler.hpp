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

/** Draws samples of three of n points: with equal probability from all, or best first (PROSAC: Chum and Matas 2005,
Eq. (3)). The same seed gives the same samples on every platform. */
class Sampler
{
public:
    /** @param n the number of points, at least three.
    @param seed seed of the generator.
    @param ordered whether the points stand best first.
    @param most the most samples that will be drawn. After half of them the pool holds every point (rounding aside).
    Otherwise the end of the list would never be drawn, even where the order means nothing. */
    Sampler(int n, uint64 seed, bool ordered, int most)
        : n_(n),
          rng_(seed),
          pool_(ordered ? SAMPLE_SIZE : n),
          growing_(std::min(most * GROWING_SHARE, ALL_SAMPLES)),
          samplesOfPool_(growing_)
    {
        for (int i = 0; i < SAMPLE_SIZE; ++i)
            samplesOfPool_ *= double(SAMPLE_SIZE - i) / (n - i);
    }

    /** Returns three different points. */
    Sample next()
    {
        ++drawn_;
        while (pool_ < n_ && drawn_ > endOfPool_)
            grow();
        // As long as the pool grows, each sample holds its newest point.
        Sample sample;
        const bool withNewest = newest_ && pool_ < n_;
        sample[0] = withNewest ? pool_ - 1 : rng_.uniform(0, pool_);
        for (int k = 1; k < SAMPLE_SIZE; ++k)
            do
                sample[k] = rng_.uniform(0, withNewest ? pool_ - 1 : pool_);
            while (std::find(sample.begin(), sample.begin() + k, sample[k]) != sample.begin() + k);
        return sample;
    }

    /** Returns the size of the pool: samples have come from so many first points. */
    int pool() const { return pool_; }

    /** Returns how many samples of all points those drawn are worth. Once the pool holds every point, ordered samples
    are the same as others in another order; before that they are worth none. */
    double ofAll() const { return pool_ < n_ ? 0 : drawn_ - roundedUp_; }

private:
    static constexpr double ALL_SAMPLES = 200000;  // the paper's pool holds every point after so many samples
    // Ours holds every point after this share of the samples that may be drawn, if these are fewer.
    // fitted: doc/ransac.md, "Order"; held by Gmlpnp_Ransac.orderedSamplesComeToAllPoints
    static constexpr double GROWING_SHARE = 0.5;

    // Adds the next point to the pool: T_(n+1) of Eq. (3) and T'_(n+1) behind it. The paper gives each pool at least
    // one sample. Where there are too many points for that the later pools share samples.
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
    double growing_;  // the pool holds every point after so many samples and those rounded up
    double drawn_ = 0;
    double endOfPool_ = 1;  // T' of Eq. (3): the pool grows after so many samples
    double samplesOfPool_;  // T of Eq. (3)
    double roundedUp_ = 0;  // sum of T' - T over all pools
};

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_RANSAC_SAMPLER_HPP
