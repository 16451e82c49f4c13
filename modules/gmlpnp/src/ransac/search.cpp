// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "p3p.hpp"
#include "repeats.hpp"
#include "sampler.hpp"
#include "score.hpp"
#include "search.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

namespace {

constexpr int MIN_INLIERS = SAMPLE_SIZE + 1;  // one at least to agree with the sample

// The fewest samples, even where one would reach the confidence, because three noisy points may give a poor pose.
constexpr int MIN_ITERATIONS = 20;

double samplesOf(int n)
{
    double count = 1;
    for (int k = 0; k < SAMPLE_SIZE; ++k)
        count *= double(std::max(n - k, 0)) / (k + 1);
    return count;
}

/** The number of samples at which the asked confidence is reached. One in five all-inlier samples may be too noisy to
lead to the pose. */
double neededIterations(int inliers, int n, double confidence)
{
    // Fitted: scripts/bench.sh --ransac; held by Gmlpnp_RansacStatistics.confidenceIsKept.
    constexpr double LEADS_TO_POSE = 0.8;
    const double good = LEADS_TO_POSE * samplesOf(inliers) / samplesOf(n);
    return std::log(1 - confidence) / std::log1p(-good);
}

/** A bound of the logarithm of the probability that at least k of n events of probability p happen: the union bound
over any k of them, and Chernoff's for many. */
double logTail(int k, int n, double p)
{
    constexpr int MANY = 50;
    const double share = double(k) / n;
    if (share <= p)
        return 0;
    double bound = 0;
    for (int i = 0; k <= MANY && i < k; ++i)
        bound += std::log(p * (n - i) / (k - i));
    if (k > MANY)
        bound = -n * (share * std::log(share / p) + (share < 1 ? (1 - share) * std::log((1 - share) / (1 - p)) : 0));
    return std::min(bound, 0.);
}

/** Whether so many inliers mean something. Among the `tried` poses the expected number of wrong ones with as many
inliers by chance is then below EXPECTED (a contrario: Moisan and Stival 2004). */
bool significant(int inliers, int n, double chance, double tried)
{
    constexpr double EXPECTED = 0.05;
    return inliers >= MIN_INLIERS &&
           std::log(tried) + logTail(inliers - SAMPLE_SIZE, n - SAMPLE_SIZE, chance) < std::log(EXPECTED);
}

// The pose of a thinner triangle is not worth scoring (least height over longest side).
constexpr double THIN = 1e-3;

bool thin(const Triple& p)
{
    const Vector3d a = p[1] - p[0], b = p[2] - p[0], c = p[2] - p[1];
    const double longest2 = std::max(a.squaredNorm(), std::max(b.squaredNorm(), c.squaredNorm()));
    return !(a.cross(b).norm() > THIN * longest2);
}

/** Counts inliers that agree independently: one per object point and one per ray. Wrong matches of one point to
neighbouring pixels, or of many points to one pixel, all fit where one of them does. */
class Independent
{
public:
    Independent(const Correspondences& data, int most) : points_(data, most), rays_(data, most) {}

    void add(int i)
    {
        if (points_.has(i) || rays_.has(i))
            return;
        points_.add(i);
        rays_.add(i);
    }

    int count() const { return points_.count(); }

private:
    DistinctPoints points_;
    DistinctRays rays_;
};

/** A search with its scored points and the best pose so far. */
class Search
{
public:
    Search(const Correspondences& data, const std::vector<Metric>& metrics, const RansacOptions& options, RNG& rng)
        : data_(data), options_(options), points_(data, metrics, rng)
    {}

    void tryPose(const Pose& pose)
    {
        ++tried_;
        const double enough = bestRaw_ + NEARLY;
        const Score raw = points_.scoreAgainst(pose, enough);
        const bool nearly = raw.cost < enough && raw.inliers >= MIN_INLIERS;
        if (!(raw.cost < bestRaw_ || nearly))
            return;
        bestRaw_ = std::min(bestRaw_, raw.cost);
        keep(pose, points_.score(pose));
        const Pose refined = locallyOptimised(pose);
        keep(refined, points_.score(refined));
    }

    void trySample(const Sample& sample)
    {
        Triple p, m;
        for (int k = 0; k < SAMPLE_SIZE; ++k) {
            p[k] = data_.pointAt(sample[k]);
            m[k] = data_.unitRayAt(sample[k]);
        }
        ++drawn_;
        if (thin(p))
            return;
        std::array<Pose, 4> poses;
        const int count = p3p(p, m, poses);
        for (int k = 0; k < count; ++k)
            tryPose(poses[k]);
    }

    bool finished(int drawn, const Sampler& sampler)
    {
        // After ten times as many draws as there are samples, e^-10 of the samples have not come.
        constexpr double EXHAUSTED = 10;
        if (drawn >= EXHAUSTED * samplesOf(points_.size()))
            return true;
        if (drawn < MIN_ITERATIONS || best_.inliers < MIN_INLIERS)
            return false;
        if (sampler.ofAll() >= neededIterations(best_.inliers, points_.size(), options_.confidence))
            return true;
        // All ordered samples came from the pool, which may have a larger share of inliers.
        const int pool = sampler.pool();
        if (pool == points_.size())
            return false;
        const int inPool = independentAmongFirst(pool);
        return drawn >= neededIterations(inPool, pool, options_.confidence) &&
               significant(inPool, pool, options_.chance, distinct());
    }

    /** The best pose, refined on all points until its inliers stay; none where they mean nothing. */
    std::optional<Pose> result()
    {
        if (!meansSomething())
            return std::nullopt;
        for (int round = 0; round < FINAL_ROUNDS; ++round) {
            Pose pose = bestPose_;
            const double before = best_.cost;
            if (!points_.step(pose, NARROW, points_.size()))
                break;
            keep(pose, points_.score(pose));
            if (!(best_.cost < before * (1 - SETTLED)))
                break;
        }
        return bestPose_;
    }

private:
    static constexpr double WIDE = 3, NARROW = 1.5;  // thresholds
    static constexpr double NEARLY = 1;              // a pose with one inlier fewer than the best is still refined
    static constexpr int FINAL_ROUNDS = 10;
    static constexpr double SETTLED = 1e-3;  // of the cost

    void keep(const Pose& pose, const Score& score)
    {
        if (!(score.cost < best_.cost))
            return;
        best_ = score;
        bestPose_ = pose;
        prefix_.clear();
    }

    Pose locallyOptimised(Pose pose) const
    {
        for (const double width : {WIDE, WIDE, NARROW, NARROW})
            if (!points_.step(pose, width, ScoredPoints::SCREENED))
                break;
        return pose;
    }

    // The number of poses tried without those of samples that came again.
    double distinct() const { return tried_ * std::min(1., samplesOf(points_.size()) / std::max(drawn_, 1.)); }

    // Whether the best pose has more independent inliers than chance would give, or all of the points.
    bool meansSomething() const
    {
        const int n = points_.size();
        int enough = MIN_INLIERS;
        while (best_.inliers < n && enough <= best_.inliers && !significant(enough, n, options_.chance, distinct()))
            ++enough;
        if (enough > best_.inliers)
            return false;
        Independent independent(data_, enough);
        const std::vector<bool> inliers = points_.inliers(bestPose_);
        for (int i = 0; i < n && independent.count() < enough; ++i)
            if (inliers[i])
                independent.add(i);
        return independent.count() == enough;
    }

    int independentAmongFirst(int count)
    {
        if (prefix_.empty()) {
            Independent independent(data_, best_.inliers);
            prefix_.push_back(0);
            for (const bool inlier : points_.inliers(bestPose_)) {
                if (inlier)
                    independent.add(static_cast<int>(prefix_.size()) - 1);
                prefix_.push_back(independent.count());
            }
        }
        return prefix_[count];
    }

    const Correspondences& data_;
    const RansacOptions& options_;
    ScoredPoints points_;
    Score best_{std::numeric_limits<double>::infinity(), 0};
    Pose bestPose_;
    double bestRaw_ = std::numeric_limits<double>::infinity();  // of the poses of samples, as they came
    double drawn_ = 0, tried_ = 0;                              // samples, poses
    std::vector<int> prefix_;  // independent inliers of the best among the first so many points
};

}  // namespace

std::optional<Consensus> findConsensus(const Correspondences& data, const std::vector<Metric>& metrics,
                                       const RansacOptions& options)
{
    RNG rng(options.seed);
    Search search(data, metrics, options, rng);
    Sampler sampler(data.size(), rng.next(), options.ordered, options.maxIterations);
    if (options.guess)
        search.tryPose(data.fromObject(*options.guess));
    int drawn = 0;
    while (drawn < options.maxIterations && !search.finished(drawn, sampler)) {
        search.trySample(sampler.next());
        ++drawn;
    }
    const std::optional<Pose> pose = search.result();
    if (!pose)
        return std::nullopt;
    return Consensus{data.toObject(*pose), drawn};
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
