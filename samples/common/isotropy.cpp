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

//! By the angle a about its ray e turns into e' with  e' e'^T = (isotropic part) + cos(2a) even + sin(2a) odd.
struct Spin
{
    cv::Matx33d even = cv::Matx33d::zeros(), odd = cv::Matx33d::zeros();

    explicit Spin(const TrueResidual& residual)
    {
        const cv::Vec3d& e = residual.object;
        const cv::Vec3d f = residual.ray.cross(e);
        even = 0.5 * (e * e.t() - f * f.t());
        odd = 0.5 * (e * f.t() + f * e.t());
    }

    Spin& operator+=(const Spin& other)
    {
        even += other.even;
        odd += other.odd;
        return *this;
    }
};

//! The share of random turns that bring the moments at least as far from the isotropic ones as they are.
double shareAsFar(const std::vector<Spin>& spins, uint64_t seed)
{
    cv::Matx33d observed = cv::Matx33d::zeros();
    for (const Spin& spin : spins)
        observed += spin.even;
    const double distance = cv::norm(observed);
    cv::RNG random(seed);
    int asFar = 0;
    for (int turn = 0; turn < kTurns; ++turn) {
        cv::Matx33d turned = cv::Matx33d::zeros();
        for (const Spin& spin : spins) {
            const double angle = random.uniform(0.0, 2.0 * CV_PI);
            turned += std::cos(angle) * spin.even + std::sin(angle) * spin.odd;
        }
        asFar += cv::norm(turned) >= distance ? 1 : 0;
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
