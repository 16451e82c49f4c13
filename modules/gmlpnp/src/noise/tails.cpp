// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "tails.hpp"

// Heavy tails: most points are Gaussian, a share of them has a wider noise (doc/theory.md, section 3).

namespace cv {
namespace gmlpnp {
namespace detail {

namespace {

// A Gaussian noise fitted to few points follows the wildest of them so well that their tails hardly show. Below this
// many points the test asks for less. Fitted: scripts/figures.sh tails; held by Gmlpnp_RobustStatistics.
constexpr int FEW = 50;
// Fewer points lose more by tails that are not there than they gain by real ones. Fitted likewise.
constexpr int MIN_POINTS_TAILS = 8;

// Score test for tails heavier than Gaussian. Of Gaussian residuals  sum (c^2/4 - c)  has the mean 0 and the variance 8
// n. With the scale fitted, too,  sum (c^2/4 - 2 c + 2)  has the variance 4 n. The root of twice the variance promises
// a gain of one nat.
bool promisesTails(const RaySums& sums, bool scaleKnown, int n)
{
    if (n < MIN_POINTS_TAILS)
        return false;
    if (scaleKnown)
        return sums.c2 / 4 - sums.c > std::sqrt(16. * n);
    const double share = std::min(1., static_cast<double>(n) / FEW);
    return sums.c2 / 4 - 2 * sums.c + 2 * n > share * share * std::sqrt(8. * n);
}

// A noise that does not have the shape of the data shows tails, too. They go as the shape comes, and a Student-t of the
// same scale does not explain them.
bool showAtTheSameScale(const double* c, const RaySums& sums, int n)
{
    constexpr std::array<Tails, TRIED_TAILS> students = {Tails{1, 1, 16}, {1, 1, 8}, {1, 1, 4}, {1, 1, 2}};
    constexpr std::array<double, TRIED_TAILS> same = {1, 1, 1, 1};
    std::array<TailSums, TRIED_TAILS> found;
    rayKernels(n).tails(c, n, students.data(), same.data(), found.data());
    return std::any_of(found.begin(), found.end(),
                       [&](const TailSums& student) { return -logarithm(student.g) < 0.5 * sums.c; });
}

bool mayHaveTails(const double* c, const RaySums& sums, bool scaleKnown, int n)
{
    return promisesTails(sums, scaleKnown, n) && (scaleKnown || n < FEW || showAtTheSameScale(c, sums, n));
}

// The shares that are tried double from one to the next.
constexpr std::array<double, TRIED_TAILS> SHARES = {0.05, 0.1, 0.2, 0.4};

// For each share the factor by which the noise fits best.
using Factors = std::array<double, TRIED_TAILS>;
using TriedSums = std::array<TailSums, TRIED_TAILS>;

TriedSums sumsAt(const Factors& factors, Tails tails, const double* c, int n)
{
    std::array<Tails, TRIED_TAILS> tried;
    for (int k = 0; k < TRIED_TAILS; ++k) {
        tails.share = SHARES[k];
        tried[k] = tails;
    }
    TriedSums sums;
    rayKernels(n).tails(c, n, tried.data(), factors.data(), sums.data());
    return sums;
}

// The EM step of a factor is  lambda <- lambda sum w c / (2n).
void improve(Factors& factors, const TriedSums& sums, int n)
{
    for (int k = 0; k < TRIED_TAILS; ++k)
        factors[k] *= sums[k].wc / (2 * n);
}

// The factors at first, where a Gaussian was fitted to all points.
Factors firstFactors(double scale, const Tails& tails, const double* c, int n)
{
    constexpr double NARROWER = 0.5;
    constexpr int STEPS = 2;
    Factors factors;
    factors.fill(NARROWER * scale);
    for (int step = 0; step < STEPS; ++step)
        improve(factors, sumsAt(factors, tails, c, n), n);
    return factors;
}

// The part of L that each share decides [nat].
std::array<double, TRIED_TAILS> costsOf(const Factors& factors, const TriedSums& sums, int n)
{
    std::array<double, TRIED_TAILS> costs{};
    for (int k = 0; k < TRIED_TAILS; ++k)
        costs[k] = n * std::log(factors[k]) - logarithm(sums[k].g);
    return costs;
}

// A share between those that are tried. Its cost follows from theirs.
struct Between
{
    double share;
    double prior;                           // over that of the Gaussian
    std::array<double, TRIED_TAILS> basis;  // of the cubic through the costs, over the logarithm of the share
};

constexpr int PER_DOUBLING = 4, BETWEEN_COUNT = (TRIED_TAILS - 1) * PER_DOUBLING + 1;
using BetweenArray = std::array<Between, BETWEEN_COUNT>;

BetweenArray sharesBetween()
{
    // The prior of a share over that of half of it; the least is as likely as none. Fitted: scripts/figures.sh tails;
    // held by Gmlpnp_RobustStatistics.
    constexpr double PRIOR = 2.5;
    BetweenArray all{};
    for (int i = 0; i < BETWEEN_COUNT; ++i) {
        const double doublings = static_cast<double>(i) / PER_DOUBLING;
        all[i].share = SHARES[0] * std::exp2(doublings);
        all[i].prior = std::pow(PRIOR, doublings) * TRIED_TAILS / BETWEEN_COUNT;
        for (int k = 0; k < TRIED_TAILS; ++k) {
            all[i].basis[k] = 1;
            for (int j = 0; j < TRIED_TAILS; ++j)
                all[i].basis[k] *= j == k ? 1 : (doublings - j) / (k - j);
        }
    }
    return all;
}

// The posterior mean of the share. Where the likelihood is flat it errs less than the maximum; elsewhere the two agree.
double meanShare(double gaussian, const std::array<double, TRIED_TAILS>& fitted)
{
    static const BetweenArray all = sharesBetween();
    constexpr double LIKE_GAUSSIAN = 0.0125;  // below, the weights hardly differ
    std::array<double, BETWEEN_COUNT> costs{};
    for (int i = 0; i < BETWEEN_COUNT; ++i)
        for (int k = 0; k < TRIED_TAILS; ++k)
            costs[i] += all[i].basis[k] * fitted[k];
    const double least = std::min(gaussian, *std::min_element(costs.begin(), costs.end()));
    double total = std::exp(least - gaussian), sum = 0;
    for (int i = 0; i < BETWEEN_COUNT; ++i) {
        const double likely = all[i].prior * std::exp(least - costs[i]);
        total += likely;
        sum += likely * all[i].share;
    }
    return sum >= LIKE_GAUSSIAN * total ? sum / total : 0;
}

// The factor at any share. Its logarithm is interpolated linearly between the shares that are tried and the Gaussian's
// `scale` at none.
double factorAt(double share, double scale, const Factors& factors)
{
    int k = 0;
    while (k + 1 < TRIED_TAILS && SHARES[k] < share)
        ++k;
    const double before = k > 0 ? SHARES[k - 1] : 0, from = k > 0 ? factors[k - 1] : scale;
    return from * std::pow(factors[k] / from, (share - before) / (SHARES[k] - before));
}

// Sigma and Gamma change with the share. The factors are relative to them.
void rescale(Noise& noise, Factors& factors, double share, double scale)
{
    const double factor = factorAt(share, scale, factors),
                 change = factor / factorAt(noise.tails.share, scale, factors);
    noise.Sigma *= change;
    noise.Gamma *= change;
    for (double& entry : factors)
        entry /= factor;
}

}  // namespace

void TailSearch::update(Noise& noise, const double* c, const RaySums& sums)
{
    Tails& tails = noise.tails;
    const bool atFloor = !scaleKnown_ && sums.c < n_;  // the data are better than the floor of the noise
    if (atFloor)
        tails.share = 0;
    if (atFloor || (tails.share == 0 && !mayHaveTails(c, sums, scaleKnown_, n_)))
        return;

    const double scale = scaleKnown_ ? 1 : sums.c / (2 * n_);
    if (tails.share == 0 && !scaleKnown_)
        factors_ = firstFactors(scale, tails, c, n_);
    const TriedSums found = sumsAt(factors_, tails, c, n_);
    const double gaussian = scaleKnown_ ? 0.5 * sums.c : n_ * std::log(scale) + n_;
    const double share = meanShare(gaussian, costsOf(factors_, found, n_));
    if (!scaleKnown_) {
        improve(factors_, found, n_);
        rescale(noise, factors_, share, scale);
    }
    tails.share = share;
}

bool TailSearch::areWild(const RaySums& sums) const
{
    // The mean of c^2 / 4 at the right scale is 2 for isotropic noise, and 3 for noise along one direction. Fitted:
    // scripts/figures.sh tails; held by Gmlpnp_RobustStatistics.
    constexpr double WILD = 5;
    const double scale = sums.c / (2 * n_);
    return !scaleKnown_ && sums.c >= n_ && sums.c2 / 4 > WILD * n_ * scale * scale;
}

bool sameTails(const Tails& a, const Tails& b, int n, double tolerance)
{
    constexpr double SAME = 0.1;  // relative: moves L and the pose less than the tolerance does
    const double step = std::abs(a.share - b.share), larger = std::max(a.share, b.share);
    if (step <= SAME * larger)  // also where neither has tails
        return true;
    // This is an upper bound, because the information about a share is less than n / share.
    return n * step * step / (2 * larger) < tolerance;
}

TailInformation tailInformation(const Tails& tails)
{
    if (tails.share == 0)
        return {1, 1};
    // Means over c are integrated by v with v^2 = 1 / (1 + c / (dof spread2)). A Student-t is a polynomial of v, so the
    // rule of Gauss and Legendre is exact for it.
    constexpr int INTERVALS = 16;
    constexpr double NODES[] = {-0.8611363115940526, -0.3399810435848563, 0.3399810435848563, 0.8611363115940526};
    constexpr double WEIGHTS[] = {0.3478548451374538, 0.6521451548625461, 0.6521451548625461, 0.3478548451374538};
    const double reach = tails.dof * tails.spread2;
    TailInformation sum{0, 0};
    for (int k = 0; k < INTERVALS; ++k)
        for (int j = 0; j < 4; ++j) {
            const double v = (k + 0.5 + NODES[j] / 2) / INTERVALS, dv = WEIGHTS[j] / 2 / INTERVALS;
            const double c = reach * (1 / (v * v) - 1), dc = 2 * reach / (v * v * v) * dv;
            const TailTerms at = tailTerms(tails, c);
            const double wwc = at.w * at.w * c, mass = at.g / 2 * dc;
            sum.pose += mass * wwc / 2;
            sum.noise += mass * wwc * c / 8;
        }
    sum.pose /= 1 - tails.share + tails.share / tails.spread2;  // E w
    return sum;
}

double nearestStudentT(const Tails& tails)
{
    if (tails.share == 0)
        return std::numeric_limits<double>::infinity();
    return 1 / std::sqrt(tails.share);  // within 3 % for shares to .4 of the default width
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
