// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "../math/cholesky.hpp"
#include "../noise/scoring.hpp"
#include "alternation.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

Vector6d gaussNewtonStep(const RaySums& sums)
{
    const CholeskyFactor<6> cholesky(sums.H);
    if (cholesky.positiveDefinite())
        return cholesky.solve(-sums.g);
    const UnitDiagonal H(sums.H);
    return H.scale.cwiseProduct(H.matrix.ldlt().solve(-H.scale.cwiseProduct(sums.g)));
}

bool accepted(bool noiseChanged, const RaySums& before, const RaySums& after, int n)
{
    // Rounding: at the minimum it would decide whether the last step counts, and with it the order of the points.
    constexpr double ROUNDING = 1e-13;
    constexpr double RISE_PER_POINT = 0.05;  // nat
    if (!noiseChanged)
        return after.misfit <= before.misfit * (1 + ROUNDING);
    return after.L <= before.L + std::max(RISE, RISE_PER_POINT * n) && 2 * after.inFront > n;
}

namespace {

// What Algorithm 1 as published does otherwise than the marginal likelihood stands here alone.
struct Policy
{
    LeverArm lever;  // Algorithm 1 turns the points as they are
    bool followsL;   // its noise is a mean of squared residuals: L neither promises nor ends anything about it
};

Policy policyOf(NoiseKind kind)
{
    return kind == NoiseKind::PUBLISHED ? Policy{LeverArm::AS_GIVEN, false} : Policy{LeverArm::CORRECTED, true};
}

// From this many points on a pass costs more than the larger system of Fisher scoring. Measured:
// doc/lab/performance.md.
constexpr int SCORING_POINTS = 200;

// After a round of scoring the error that is left is of second order, so the rounds may end this much earlier: no
// figure of doc/lab/ changes.
constexpr double SCORING_AHEAD = 10;

// The promised change of L [nat] below which the sums after the last step are not worth a pass.
double worthNoPass(SumsNeeded sums)
{
    switch (sums) {
        case SumsNeeded::EXACT:
            return 0;
        case SumsNeeded::COMPARABLE:
            return DEFAULT_TOLERANCE;
        default:
            return SCORING_AHEAD * DEFAULT_TOLERANCE;
    }
}

// Scoring takes the expected curvature for the true one. Where the noise is all but singular that may lead far off. A
// rise of L tells [nat per point, at least RISE]; MM has none.
bool scoringFailed(const RaySums& before, const RaySums& after, int n)
{
    constexpr double RISE_PER_POINT = 0.005;
    return !(after.L <= before.L + std::max(RISE, RISE_PER_POINT * n));
}

// Moves an estimate, which holds pose, noise and kind at the start, to its end.
class Alternation
{
public:
    Alternation(const Correspondences& data, const NoiseStart& start, const FitOptions& options, Estimate& now)
        : data_(data),
          options_(options),
          policy_(policyOf(start.kind)),
          fit_(data, start, options.tails),
          now_(now),
          scores_(productsFor(start.kind) != NO_PRODUCTS && (frozen() || data.size() >= SCORING_POINTS)),
          step_(scores_ && frozen() ? NoiseStep::SCORING_FROZEN : NoiseStep::MM)
    {}

    void run()
    {
        begin();
        while (now_.rounds < options_.limits.rounds && !now_.converged)
            round();
    }

private:
    bool frozen() const { return options_.step == NoiseStep::SCORING_FROZEN; }
    bool scoresNow() const { return step_ != NoiseStep::MM; }

    void begin();
    void round();
    RaySums pass(const Estimate& at, NoiseStep next);
    NoiseStep nextStep() const;
    double promised(const Noise& next, const Vector6d& xi) const;
    bool settled(const Noise& next, double promise, double tolerance) const;
    bool endsHere(const Estimate& next, double promise) const;
    bool falls(Estimate& next, Vector6d xi);
    void end(double promise);
    void leaveScoring();

    const Correspondences& data_;
    const FitOptions& options_;
    const Policy policy_;
    NoiseFit fit_;
    Estimate& now_;
    bool scores_;     // whether the noise is scored from the second round on
    NoiseStep step_;  // that the sums of now_ are good for
};

void Alternation::begin()
{
    // The first pass of a start near its end sums the products that all rounds use.
    const NoiseStep first = scoresNow() ? NoiseStep::SCORING_SAMPLED : NoiseStep::MM;
    now_.sums = pass(now_, first);
    if (fit_.addWildTails(now_.noise, now_.sums))
        now_.sums = pass(now_, first);
}

void Alternation::round()
{
    const Vector6d xi = gaussNewtonStep(now_.sums);
    const bool scored = scoresNow();
    Estimate next = now_;
    next.rounds++;
    next.noise = fit_.next(now_.noise, now_.sums, now_.pose.R, step_);
    next.pose = perturbed(now_.pose, xi);
    step_ = nextStep();
    const double promise = promised(next.noise, xi);
    next.converged = settled(next.noise, promise, (scoresNow() ? SCORING_AHEAD : 1) * options_.limits.tolerance);
    if (!endsHere(next, promise)) {
        next.sums = pass(next, step_);
        if (scored && scoringFailed(now_.sums, next.sums, data_.size())) {
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

// The first round is one of MM, which finds its way from an isotropic start.
NoiseStep Alternation::nextStep() const
{
    return scores_ ? options_.step : NoiseStep::MM;
}

// The sums at an estimate, with the products that the next step needs.
RaySums Alternation::pass(const Estimate& at, NoiseStep next)
{
    const bool sums = next == NoiseStep::SCORING || next == NoiseStep::SCORING_SAMPLED;
    RaySums out = rayPass(data_, at.pose, at.noise,
                          {policy_.lever, sums ? productsFor(now_.kind) : NO_PRODUCTS, fit_.residuals(),
                           next == NoiseStep::SCORING_SAMPLED});
    if (next == NoiseStep::SCORING_FROZEN)
        out.QQ = now_.sums.QQ;
    return out;
}

// Change of L that the next step promises [nat]: half its slope along the step of the pose, a quarter along that of the
// noise, which goes twice as far.
double Alternation::promised(const Noise& next, const Vector6d& xi) const
{
    const double byPose = 0.5 * std::abs(now_.sums.g.dot(xi));
    if (!policy_.followsL)
        return byPose;
    const Matrix3d& R = now_.pose.R;
    const Matrix3d dSigma = R * (next.Sigma - now_.noise.Sigma) * R.transpose(), dGamma = next.Gamma - now_.noise.Gamma;
    const double slope =
        ((now_.sums.Zo - now_.sums.Go) * dSigma).trace() + ((now_.sums.Zb - now_.sums.Gb) * dGamma).trace();
    return byPose + 0.25 * std::abs(slope);
}

bool Alternation::settled(const Noise& next, double promise, double tolerance) const
{
    if (!policy_.followsL)
        return (next.Sigma - now_.noise.Sigma).norm() < tolerance * next.Sigma.norm();
    // With a fixed noise Gauss-Newton converges fast: a tighter end costs a round and gives the minimum itself.
    constexpr double FIXED_TOLERANCE = 1e-6;  // nat
    const bool fixed = isConstant(now_.kind) && next.tails.share == 0;
    return promise < (fixed ? std::min(tolerance, FIXED_TOLERANCE) : tolerance) &&
           sameTails(now_.noise.tails, next.tails, data_.size(), tolerance);
}

// Whether the round is the last and the sums after it are not worth a pass.
bool Alternation::endsHere(const Estimate& next, double promise) const
{
    const bool last = next.converged || next.rounds == options_.limits.rounds;
    return last && (options_.sums == SumsNeeded::ANY || promise < worthNoPass(options_.sums));
}

// Halves the step as long as it goes wrong; false where it always does.
bool Alternation::falls(Estimate& next, Vector6d xi)
{
    constexpr int HALVINGS = 5;
    const bool noiseChanged = !isConstant(now_.kind) || next.noise.tails.share != now_.noise.tails.share;
    const auto fine = [&] { return accepted(noiseChanged, now_.sums, next.sums, data_.size()); };
    for (int k = 0; k < HALVINGS && !fine(); ++k) {
        xi *= 0.5;
        next.pose = perturbed(now_.pose, xi);
        next.sums = pass(next, step_);
    }
    return noiseChanged || fine();
}

// No step falls any more: either this is the minimum, to rounding, or the quadratic model does not hold here.
void Alternation::end(double promise)
{
    constexpr double OF_MISFIT = 1e-9;
    now_.converged = promise <= std::max(options_.limits.tolerance, OF_MISFIT * now_.sums.misfit);
    if (!now_.converged)
        now_.rounds = options_.limits.rounds;
}

// The pass is made again where the round began, because the residuals are those of its end.
void Alternation::leaveScoring()
{
    scores_ = false;
    step_ = NoiseStep::MM;
    now_.sums = pass(now_, step_);
    now_.rounds++;
}

}  // namespace

Estimate alternate(const Correspondences& data, const Pose& start, const NoiseStart& noise, const FitOptions& options)
{
    Estimate estimate;
    estimate.pose = start;
    estimate.noise = noise.noise;
    estimate.kind = noise.kind;
    Alternation(data, noise, options, estimate).run();
    return estimate;
}

Pose isotropicPose(const Correspondences& data, const Pose& start)
{
    constexpr Limits LIMITS = {30, 1e-12};
    return alternate(data, start, {isotropic(1, 0), NoiseKind::FIXED}, {LIMITS}).pose;
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
