// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "precomp.hpp"

#include "p3p.hpp"
#include "ransac.hpp"
#include "ransac_sampler.hpp"
#include "ransac_score.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

Metric pixelMetric(const Eigen::Matrix<double, 3, 2>& rayByPixel, double threshold)
{
    const Eigen::Matrix2d N = rayByPixel.transpose() * rayByPixel;
    const double trace = N.trace(), det = N.determinant();
    constexpr double SINGULAR = 1e-20;  // a panorama's pole: all pixels of a row are one ray
    if (det > SINGULAR * trace * trace)
        return N.inverse() * rayByPixel.transpose() / threshold;
    return N * rayByPixel.transpose() / (trace * trace * threshold);
}

Metric angularMetric(const Vector3d& ray, double threshold)
{
    Metric B;
    B.row(0) = ray.unitOrthogonal().transpose();
    B.row(1) = ray.cross(B.row(0).transpose()).transpose();
    return B / std::tan(threshold);
}

namespace {

constexpr int MIN_INLIERS = SAMPLE_SIZE + 1;  // one at least to agree with the sample

// Samples that show the confidence even where one would do: three noisy points may give a poor pose.
constexpr int MIN_ITERATIONS = 20;

/** Samples after which one of inliers alone was drawn with the asked confidence. */
double neededIterations(int inliers, int n, double confidence)
{
    double clean = 1;  // share of the samples that are
    for (int k = 0; k < SAMPLE_SIZE; ++k)
        clean *= double(std::max(inliers - k, 0)) / (n - k);
    if (clean >= 1)
        return 0;
    return std::log(1 - confidence) / std::log1p(-clean);
}

/** Whether so many inliers mean something: the expected number of wrong poses, among those that were tried, that have
as many by chance is below EXPECTED (a contrario: Moisan and Stival 2004; tail of the binomial by Chernoff's bound). */
bool significant(int inliers, int n, double chance, double tried)
{
    constexpr double EXPECTED = 0.05;
    if (inliers < MIN_INLIERS)
        return false;
    const double others = n - SAMPLE_SIZE, share = (inliers - SAMPLE_SIZE) / others;
    if (share <= chance)
        return false;
    const double miss = share < 1 ? (1 - share) * std::log((1 - share) / (1 - chance)) : 0;
    const double divergence = share * std::log(share / chance) + miss;
    return std::log(tried / EXPECTED) < others * divergence;
}

// A thin triangle gives no pose worth scoring: least height over longest side.
constexpr double THIN = 1e-3;

bool thin(const Triple& p)
{
    const Vector3d a = p[1] - p[0], b = p[2] - p[0], c = p[2] - p[1];
    const double longest2 = std::max(a.squaredNorm(), std::max(b.squaredNorm(), c.squaredNorm()));
    return !(a.cross(b).norm() > THIN * longest2);
}

/** A search: what is scored against what, and the best so far. */
class Search
{
public:
    Search(const Correspondences& data, const std::vector<Metric>& metrics, const RansacOptions& options, RNG& rng)
        : data_(data), options_(options), points_(data, metrics, rng)
    {}

    void tryPose(const Pose& pose)
    {
        ++tried_;
        const Score raw = points_.scoreAgainst(pose, bestRaw_);
        if (!(raw.cost < bestRaw_))
            return;
        bestRaw_ = raw.cost;
        keep(pose, points_.score(pose));
        const Pose refined = locallyOptimised(pose);
        keep(refined, points_.score(refined));
    }

    void trySample(const Sample& sample)
    {
        Triple p, m;
        for (int k = 0; k < SAMPLE_SIZE; ++k) {
            p[k] = data_.pointAt(sample[k]);
            m[k] = data_.rayAt(sample[k]);
        }
        if (thin(p))
            return;
        std::array<Pose, 4> poses;
        const int count = p3p(p, m, poses);
        for (int k = 0; k < count; ++k)
            tryPose(poses[k]);
    }

    bool finished(int drawn, int pool)
    {
        if (drawn < MIN_ITERATIONS || best_.inliers < MIN_INLIERS)
            return false;
        if (drawn >= neededIterations(best_.inliers, points_.size(), options_.confidence))
            return true;
        // Ordered samples all came from the pool, which may have more inliers.
        if (pool == points_.size())
            return false;
        const int inPool = inliersAmongFirst(pool);
        return drawn >= neededIterations(inPool, pool, options_.confidence) &&
               significant(inPool, pool, options_.chance, tried_);
    }

    /** All points, until the inliers stay. */
    std::optional<Pose> result()
    {
        const bool all = best_.inliers == points_.size() && best_.inliers >= MIN_INLIERS;
        if (!all && !significant(best_.inliers, points_.size(), options_.chance, tried_))
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

    int inliersAmongFirst(int count)
    {
        if (prefix_.empty()) {
            prefix_.push_back(0);
            for (const bool inlier : points_.inliers(bestPose_))
                prefix_.push_back(prefix_.back() + inlier);
        }
        return prefix_[count];
    }

    const Correspondences& data_;
    const RansacOptions& options_;
    ScoredPoints points_;
    Score best_{std::numeric_limits<double>::infinity(), 0};
    Pose bestPose_;
    double bestRaw_ = std::numeric_limits<double>::infinity();  // of the poses of samples, as they came
    double tried_ = 0;
    std::vector<int> prefix_;  // inliers of the best among the first so many points
};

}  // namespace

std::optional<Consensus> findConsensus(const Correspondences& data, const std::vector<Metric>& metrics,
                                       const RansacOptions& options)
{
    RNG rng(options.seed);
    Search search(data, metrics, options, rng);
    Sampler sampler(data.size(), rng.next(), options.ordered);
    if (options.guess)
        search.tryPose(data.fromObject(*options.guess));
    int drawn = 0;
    while (drawn < options.maxIterations && !search.finished(drawn, sampler.pool())) {
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
