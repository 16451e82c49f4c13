// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "common/isotropy.hpp"

#include <cmath>
#include <map>
#include <stdexcept>

namespace samples {

namespace {

constexpr int kTurns = 1999;
//! Turns are by multiples of half a circle over this, a power of two: the test is exact for any group of turns.
constexpr unsigned kAngles = 1024;

//! A symmetric 3x3 matrix whose Frobenius norm is the vector's: off-diagonal entries count twice.
cv::Vec6d flattened(const cv::Matx33d& C)
{
    const double root = std::sqrt(2.0);
    return {C(0, 0), C(1, 1), C(2, 2), root * C(0, 1), root * C(0, 2), root * C(1, 2)};
}

//! By the angle a about its ray e turns into e' with  e' e'^T = (isotropic part) + cos(2a) even + sin(2a) odd.
struct Spin
{
    cv::Vec6d even, odd;

    explicit Spin(const TrueResidual& residual)
    {
        const cv::Vec3d& e = residual.object;
        const cv::Vec3d f = residual.ray.cross(e);
        even = flattened(0.5 * (e * e.t() - f * f.t()));
        odd = flattened(0.5 * (e * f.t() + f * e.t()));
    }

    Spin& operator+=(const Spin& other)
    {
        even += other.even;
        odd += other.odd;
        return *this;
    }
};

std::vector<cv::Vec2d> cosinesAndSines()
{
    std::vector<cv::Vec2d> table;
    for (unsigned i = 0; i < kAngles; ++i)
        table.emplace_back(std::cos(2.0 * CV_PI * i / kAngles), std::sin(2.0 * CV_PI * i / kAngles));
    return table;
}

//! The share of random turns that bring the moments at least as far from the isotropic ones as they are.
double shareAsFar(const std::vector<Spin>& spins, uint64_t seed)
{
    const std::vector<cv::Vec2d> table = cosinesAndSines();
    cv::Vec6d observed;
    for (const Spin& spin : spins)
        observed += spin.even;
    const double distance = observed.dot(observed);
    cv::RNG random(seed);
    int asFar = 0;
    for (int turn = 0; turn < kTurns; ++turn) {
        cv::Vec6d turned;
        for (const Spin& spin : spins) {
            const cv::Vec2d& angle = table[random.next() % kAngles];
            for (int i = 0; i < 6; ++i)
                turned[i] += angle[0] * spin.even[i] + angle[1] * spin.odd[i];
        }
        asFar += turned.dot(turned) >= distance ? 1 : 0;
    }
    return (1.0 + asFar) / (1.0 + kTurns);
}

}  // namespace

void addTrueResiduals(const CorrespondenceSet& set, size_t pair, std::vector<TrueResidual>& residuals)
{
    const auto camera = set.camera();
    for (size_t i = 0; i < set.objectPoints.size(); ++i) {
        const cv::Vec3d point = set.objectPoints[i], X = set.truth * point;
        cv::Vec3d ray;
        if (!camera->unprojectPoint(set.imagePoints[i], ray) || !(ray.dot(X) > 0.0))
            continue;
        const double depth = ray.dot(X);
        residuals.push_back({pair, point, set.truth.R.t() * (X - depth * ray), set.truth.R.t() * ray, depth});
    }
}

Isotropy testIsotropy(const std::vector<TrueResidual>& residuals, uint64_t seed)
{
    if (residuals.empty())
        throw std::runtime_error("no residuals under the true motion");
    Isotropy result;
    std::vector<Spin> points;
    std::map<size_t, Spin> pairs;
    const double share = 1.0 / static_cast<double>(residuals.size());
    for (const TrueResidual& r : residuals) {
        const cv::Vec3d& e = r.object;
        result.mean += share * e;
        result.moments += share * (e * e.t());
        result.isotropic += share * 0.5 * e.dot(e) * (cv::Matx33d::eye() - r.ray * r.ray.t());
        points.emplace_back(r);
        const auto entry = pairs.emplace(r.pair, points.back());
        if (!entry.second)
            entry.first->second += points.back();
    }
    std::vector<Spin> sums;
    for (const auto& pair : pairs)
        sums.push_back(pair.second);
    result.residuals = residuals.size();
    result.pairs = sums.size();
    result.distance = cv::norm(result.moments - result.isotropic) / cv::trace(result.moments);
    result.pointsP = shareAsFar(points, seed);
    result.pairsP = shareAsFar(sums, seed + 1);
    return result;
}

}  // namespace samples
