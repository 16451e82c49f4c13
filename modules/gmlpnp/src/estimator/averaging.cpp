// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "averaging.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

namespace {

// Statistics: a kind less likely than this share of the best does not move the pose.
constexpr double NEGLIGIBLE = 1e-3;

using Shares = std::array<double, KINDS>;
using Deviations = std::array<Vector6d, KINDS>;

// Shares of e^-cost; none of what is negligible.
template <class Cost>
Shares sharesOf(const KindFits& fits, const Cost& cost)
{
    double least = std::numeric_limits<double>::infinity(), total = 0;
    for (const KindFit& fit : fits)
        least = std::min(least, cost(fit));
    Shares shares{};
    for (int k = 0; k < fits.size(); ++k) {
        const double weight = std::exp(least - cost(fits[k]));
        shares[k] = weight > NEGLIGIBLE ? weight : 0;
        total += shares[k];
    }
    for (double& share : shares)
        share /= total;
    return shares;
}

Deviations deviationsFrom(const KindFit& best, const KindFits& fits)
{
    Deviations xi;
    xi.fill(Vector6d::Zero());
    for (int k = 0; k < fits.size(); ++k)
        if (&fits[k] != &best)
            xi[k] = difference(fits[k].estimate.pose, best.estimate.pose);
    return xi;
}

Vector6d meanOf(const Deviations& xi, const Shares& shares)
{
    Vector6d mean = Vector6d::Zero();
    for (int k = 0; k < KINDS; ++k)
        if (shares[k] > 0)
            mean += shares[k] * xi[k];
    return mean;
}

// The spread is summed as squares: poses may be so far apart that differences of their squares are rounding.
Matrix6d spreadAbout(const Vector6d& centre, const Deviations& xi, const Shares& shares)
{
    Matrix6d spread = Matrix6d::Zero();
    for (int k = 0; k < KINDS; ++k)
        if (shares[k] > 0)
            spread += shares[k] * (xi[k] - centre) * (xi[k] - centre).transpose();
    return spread;
}

// The pose has fitted away six of the 2n residual coordinates, so an estimated noise comes out too small.
Noise restricted(const Estimate& estimate, int n)
{
    Noise noise = estimate.noise;
    if (estimatesObject(estimate.kind))
        noise.Sigma *= restriction(n);
    if (estimatesBearing(estimate.kind))
        noise.Gamma *= restriction(n);
    return noise;
}

double evidenceFor(const KindFit& best, const KindFits& fits)
{
    double evidence = best.estimate.evidence;
    for (const KindFit& fit : fits)
        if (&fit != &best)
            evidence = std::min(evidence, std::max(0., fit.L() - best.L()));
    return evidence;
}

}  // namespace

double negligibleMargin()
{
    return -std::log(NEGLIGIBLE);
}

KindFits withoutNegligible(const KindFits& fits)
{
    double likeliest = std::numeric_limits<double>::infinity(), best = likeliest;
    for (const KindFit& fit : fits) {
        likeliest = std::min(likeliest, fit.L());
        best = std::min(best, fit.posterior());
    }
    KindFits kept;
    for (const KindFit& fit : fits)
        if (std::exp(likeliest - fit.L()) > NEGLIGIBLE || std::exp(best - fit.posterior()) > NEGLIGIBLE)
            kept.add(fit);
    return kept;
}

Estimate averaged(const Correspondences& data, const KindFits& fits, SumsNeeded sums)
{
    const KindFit& best = *std::min_element(
        fits.begin(), fits.end(), [](const KindFit& a, const KindFit& b) { return a.posterior() < b.posterior(); });
    Estimate out = best.estimate;
    out.evidence = evidenceFor(best, fits);
    const Deviations xi = deviationsFrom(best, fits);
    const Vector6d mean = meanOf(xi, sharesOf(fits, [](const KindFit& fit) { return fit.posterior(); }));
    const Shares likelihood = sharesOf(fits, [](const KindFit& fit) { return fit.L(); });
    out.spread = spreadAbout(mean, xi, likelihood);
    out.pose = perturbed(best.estimate.pose, mean);
    out.noise = restricted(out, data.size());
    const bool far = !(0.5 * mean.dot(best.estimate.sums.H * mean) < RISE);
    if (sums == SumsNeeded::EXACT || far)
        out.sums = rayPass(data, out.pose, out.noise);
    // Between two minima the mean is a pose that no kind of noise speaks for.
    if (far && !accepted(true, best.estimate.sums, out.sums, data.size())) {
        out.pose = best.estimate.pose;
        out.spread = spreadAbout(Vector6d::Zero(), xi, likelihood);
        out.sums = rayPass(data, out.pose, out.noise);
    }
    return out;
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
