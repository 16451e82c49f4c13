// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "../math/cholesky.hpp"
#include "../noise/tails.hpp"
#include "alternation.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

namespace {

Vector6d gaussNewtonStep(const RaySums& sums)
{
    const CholeskyFactor<6> cholesky(sums.H);
    if (cholesky.positiveDefinite())
        return cholesky.solve(-sums.g);
    const UnitDiagonal H(sums.H);
    return H.scale.cwiseProduct(H.matrix.ldlt().solve(-H.scale.cwiseProduct(sums.g)));
}

constexpr int STEP_HALVINGS = 5;

}  // namespace

// With a fixed noise the cost must fall. With an estimated one L may rise a little: shrinkage and the corrected
// gradient do not follow it exactly. A rise beyond this [nat per point, at least RISE] is a step gone wrong.
constexpr double RISE_PER_POINT = 0.05;
// At the minimum rounding would decide whether the last step counts, and with it the order of the points.
constexpr double ROUNDING = 1e-13;

bool accepted(bool noiseChanged, const RaySums& before, const RaySums& after, int n)
{
    if (!noiseChanged)
        return after.misfit <= before.misfit * (1 + ROUNDING);
    return after.L <= before.L + std::max(RISE, RISE_PER_POINT * n) && 2 * after.inFront > n;
}

namespace {

// Change of L that the next step promises [nat]: half its slope along the step.
double promised(const Estimate& now, const Noise& next, const Vector6d& xi)
{
    const double byPose = 0.5 * std::abs(now.sums.g.dot(xi));
    if (now.kind == NoiseKind::PUBLISHED)  // its noise does not follow L
        return byPose;
    const Matrix3d& R = now.pose.R;
    const Matrix3d dSigma = R * (next.Sigma - now.noise.Sigma) * R.transpose(), dGamma = next.Gamma - now.noise.Gamma;
    const double slope =
        ((now.sums.Zo - now.sums.Go) * dSigma).trace() + ((now.sums.Zb - now.sums.Gb) * dGamma).trace();
    return byPose + 0.25 * std::abs(slope);
}

bool settled(const Estimate& now, const Estimate& next, double promise, double tolerance, int n)
{
    if (now.kind == NoiseKind::PUBLISHED)
        return (next.noise.Sigma - now.noise.Sigma).norm() < tolerance * next.noise.Sigma.norm();
    // With a fixed noise Gauss-Newton converges fast: a tighter end costs a round and gives the minimum itself.
    constexpr double FIXED_TOLERANCE = 1e-6;  // nat
    const bool fixed = isConstant(now.kind) && next.noise.tails.share == 0;
    return promise < (fixed ? std::min(tolerance, FIXED_TOLERANCE) : tolerance) &&
           sameTails(now.noise.tails, next.noise.tails, n, tolerance);
}

// From this many points on a pass costs more than the larger system of Fisher scoring. The first round is MM's, which
// finds its way from an isotropic start.
constexpr int SCORING_POINTS = 200;

// What scoring leaves to do after a round is of second order, so it may stop this much earlier (no figure changes).
constexpr double SCORING_AHEAD = 10;

// The promised change of L below which the sums after the last step are not worth a pass [nat].
double goodEnough(LastSums last)
{
    if (last == LastSums::AT_POSE)
        return 0;
    return (last == LastSums::NOTHING ? SCORING_AHEAD : 1) * DEFAULT_TOLERANCE;
}

// One noise only: for both at once the expected curvature is far from the true one where depths hardly differ.
Products productsFor(NoiseKind kind)
{
    return kind == NoiseKind::OBJECT ? OF_OBJECT : kind == NoiseKind::BEARING ? OF_BEARING : NO_PRODUCTS;
}

bool isIsotropic(const Noise& noise)
{
    const auto isScalar = [](const Matrix3d& C) { return (C - C(0, 0) * Matrix3d::Identity()).isZero(0); };
    return isScalar(noise.Sigma) && isScalar(noise.Gamma);
}

LeverArm leverArmOf(NoiseKind kind)
{
    return kind == NoiseKind::PUBLISHED ? LeverArm::AS_GIVEN : LeverArm::CORRECTED;
}

// Scoring takes the expected curvature for the true one. Where the noise is all but singular that may lead far off, and
// a rise of L says so [nat per point, at least RISE]; MM does not.
bool ledAstray(const RaySums& before, const RaySums& after, int n)
{
    constexpr double ASTRAY_PER_POINT = 0.005;
    return !(after.L <= before.L + std::max(RISE, ASTRAY_PER_POINT * n));
}

// Moves an estimate, which holds pose, noise and kind at the start, to its end.
class Alternation
{
public:
    Alternation(const Correspondences& data, const Stopping& stopping, Estimate& now)
        : data_(data),
          stopping_(stopping),
          now_(now),
          isotropicStart_(isIsotropic(now.noise)),
          c_(stopping.robust ? data.size() : 0),
          tails_(data.hasKnown() || isConstant(now.kind) || stopping.otherKnown, data.size()),
          scoring_(data.size() >= SCORING_POINTS),
          products_(stopping.near ? productsFor(now.kind) : NO_PRODUCTS)
    {}

    void run()
    {
        begin();
        while (now_.rounds < stopping_.maxRounds && !now_.converged)
            round();
    }

private:
    void begin();
    void round();
    Noise nextNoise();
    RaySums pass(const Estimate& at, Products products);
    Products productsOfRound() const;
    double tolerance() const;
    bool endsHere(const Estimate& next, double promise) const;
    bool falls(Estimate& next, Vector6d xi);
    void end(double promise);
    void leaveScoring();

    const Correspondences& data_;
    const Stopping& stopping_;
    Estimate& now_;
    const bool isotropicStart_;
    std::vector<double> c_;
    TailSearch tails_;
    bool scoring_;
    Products products_;  // that the sums of now_ hold
};

void Alternation::begin()
{
    now_.sums = pass(now_, products_);
    if (stopping_.robust && isotropicStart_ && tails_.areWild(now_.sums)) {
        tails_.update(now_.noise, c_.data(), now_.sums);
        now_.sums = pass(now_, products_);
    }
}

void Alternation::round()
{
    const Vector6d xi = gaussNewtonStep(now_.sums);
    Estimate next = now_;
    next.rounds++;
    next.noise = nextNoise();
    next.pose = perturbed(now_.pose, xi);
    const bool scored = products_ != NO_PRODUCTS;
    if (!stopping_.near)
        products_ = productsOfRound();
    const double promise = promised(now_, next.noise, xi);
    next.converged = settled(now_, next, promise, tolerance(), data_.size());
    if (!endsHere(next, promise)) {
        next.sums = pass(next, productsOfRound());
        if (scored && ledAstray(now_.sums, next.sums, data_.size())) {
            leaveScoring();
            return;
        }
        if (!falls(next, xi)) {
            end(promise);
            return;
        }
    }
    now_ = next;
}

// By scoring where the last pass has summed the products for it.
Noise Alternation::nextNoise()
{
    Noise next = products_ ? scoredNoise(now_.kind, now_.noise, now_.sums, now_.pose.R)
                           : updatedNoise(now_.kind, now_.noise, now_.sums, now_.pose.R, data_.size());
    if (stopping_.robust && (now_.rounds > 0 || !isotropicStart_))  // anisotropy looks like tails
        tails_.update(next, c_.data(), now_.sums);
    return next;
}

// Near the end the products of the first pass will do.
RaySums Alternation::pass(const Estimate& at, Products products)
{
    RaySums sums =
        rayPass(data_, at.pose, at.noise,
                {leverArmOf(now_.kind), products, stopping_.robust ? c_.data() : nullptr, stopping_.sampled});
    if (stopping_.near && products != products_)
        sums.QQ = now_.sums.QQ;
    return sums;
}

Products Alternation::productsOfRound() const
{
    return scoring_ && !stopping_.near ? productsFor(now_.kind) : NO_PRODUCTS;
}

double Alternation::tolerance() const
{
    return (products_ ? SCORING_AHEAD : 1) * stopping_.tolerance;
}

// Whether the round is the last and what follows from its sums is not worth a pass.
bool Alternation::endsHere(const Estimate& next, double promise) const
{
    return (next.converged || next.rounds == stopping_.maxRounds) &&
           (stopping_.near || promise < goodEnough(stopping_.last));
}

// Halves the step as long as it goes wrong; false where it always does.
bool Alternation::falls(Estimate& next, Vector6d xi)
{
    const bool noiseChanged = !isConstant(now_.kind) || next.noise.tails.share != now_.noise.tails.share;
    const auto fine = [&] { return accepted(noiseChanged, now_.sums, next.sums, data_.size()); };
    for (int k = 0; k < STEP_HALVINGS && !fine(); ++k) {
        xi *= 0.5;
        next.pose = perturbed(now_.pose, xi);
        next.sums = pass(next, productsOfRound());
    }
    return noiseChanged || fine();
}

// No step falls any more: this is the minimum, to rounding, or else a place where the quadratic model is none.
void Alternation::end(double promise)
{
    constexpr double OF_MISFIT = 1e-9;
    now_.converged = promise <= std::max(stopping_.tolerance, OF_MISFIT * now_.sums.misfit);
    if (!now_.converged)
        now_.rounds = stopping_.maxRounds;
}

// The pass again where the round began: c_ is that of the pose then.
void Alternation::leaveScoring()
{
    scoring_ = false;
    products_ = NO_PRODUCTS;
    now_.sums = pass(now_, NO_PRODUCTS);
    now_.rounds++;
}

}  // namespace

Estimate alternate(const Correspondences& data, const Pose& start, const Noise& noise, NoiseKind kind,
                   const Stopping& stopping)
{
    Estimate estimate;
    estimate.pose = start;
    estimate.noise = noise;
    estimate.kind = kind;
    Alternation(data, stopping, estimate).run();
    return estimate;
}

namespace {

// Proposition 1 with the noise of the part.
Estimate publishedStep(const Correspondences& data, Estimate now)
{
    now.sums = rayPass(data, now.pose, now.noise, {LeverArm::AS_GIVEN});
    now.pose = perturbed(now.pose, gaussNewtonStep(now.sums));
    now.rounds = 1;
    return now;
}

Estimate fewRounds(const Correspondences& data, const Estimate& from, Stopping stopping)
{
    constexpr double LEFT = 4;  // nat: what the last step leaves is far less
    stopping.near = true;
    stopping.robust = false;
    stopping.tolerance = std::max(stopping.tolerance, productsFor(from.kind) ? LEFT / SCORING_AHEAD : LEFT);
    stopping.maxRounds = 3;
    return alternate(data, from.pose, from.noise, from.kind, stopping);
}

}  // namespace

Estimate overAll(const Correspondences& data, const Estimate& ofPart, int size, const Stopping& stopping)
{
    const bool published = ofPart.kind == NoiseKind::PUBLISHED;
    Estimate now = published ? publishedStep(data, ofPart) : fewRounds(data, ofPart, stopping);
    const Vector6d xi = difference(now.pose, ofPart.pose);
    constexpr double UNLIKELY = 60;  // xi^T H xi is n / size times chi-squared of 6 degrees of freedom
    const bool far = !(xi.dot(now.sums.H * xi) <= UNLIKELY * data.size() / size);
    if (far || !(published || now.converged))
        now = alternate(data, now.pose, now.noise, now.kind, stopping);
    now.rounds += ofPart.rounds;
    now.evidence = ofPart.evidence;
    return now;
}

Pose isotropicPose(const Correspondences& data, const Pose& start)
{
    return alternate(data, start, isotropic(1, 0), NoiseKind::FIXED, {30, 1e-12, false}).pose;
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
