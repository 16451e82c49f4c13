// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "precomp.hpp"

#include "alternation.hpp"
#include "cholesky.hpp"
#include "tails.hpp"

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

// By scoring where the last pass has summed the products for it.
Noise nextNoise(const Estimate& now, Products products, int n)
{
    return products ? scoredNoise(now.kind, now.noise, now.sums, now.pose.R)
                    : updatedNoise(now.kind, now.noise, now.sums, now.pose.R, n);
}

}  // namespace

Estimate alternate(const Correspondences& data, const Pose& start, const Noise& noise, NoiseKind kind,
                   const Stopping& stopping)
{
    const int n = data.size();
    const bool isotropicStart = isIsotropic(noise);
    TailSearch tails(data.hasKnown() || isConstant(kind) || stopping.otherKnown, n);
    std::vector<double> c(stopping.robust ? n : 0);
    PassOptions options{leverArmOf(kind), stopping.near ? productsFor(kind) : NO_PRODUCTS,
                        stopping.robust ? c.data() : nullptr, stopping.sampled};
    Estimate now;
    now.pose = start;
    now.noise = noise;
    now.kind = kind;
    const auto pass = [&](const Pose& pose, const Noise& at) {
        RaySums sums = rayPass(data, pose, at, options);
        if (stopping.near && !options.products)
            sums.QQ = now.sums.QQ;
        return sums;
    };
    now.sums = pass(start, noise);
    if (stopping.robust && isotropicStart && tails.areWild(now.sums)) {
        tails.update(now.noise, c.data(), now.sums);
        now.sums = pass(start, now.noise);
    }
    bool scoring = n >= SCORING_POINTS;
    Products products = options.products;  // that the sums of `now` hold
    while (now.rounds < stopping.maxRounds && !now.converged) {
        Vector6d xi = gaussNewtonStep(now.sums);
        Estimate next = now;
        next.rounds++;
        const bool scored = products != NO_PRODUCTS;
        next.noise = nextNoise(now, products, n);
        options.products = scoring && !stopping.near ? productsFor(kind) : NO_PRODUCTS;
        if (!stopping.near)
            products = options.products;
        if (stopping.robust && (now.rounds > 0 || !isotropicStart))  // anisotropy looks like tails
            tails.update(next.noise, c.data(), now.sums);
        next.pose = perturbed(now.pose, xi);
        const double promise = promised(now, next.noise, xi);
        next.converged = settled(now, next, promise, (products ? SCORING_AHEAD : 1) * stopping.tolerance, n);
        const bool last = next.converged || next.rounds == stopping.maxRounds;
        if (last && (stopping.near || promise < goodEnough(stopping.last)))
            return next;
        const bool noiseChanged = !isConstant(kind) || next.noise.tails.share != now.noise.tails.share;
        next.sums = pass(next.pose, next.noise);
        if (scored && ledAstray(now.sums, next.sums, n)) {
            scoring = false;
            products = options.products = NO_PRODUCTS;
            now.sums = pass(now.pose, now.noise);  // c is that of the pose again
            now.rounds++;
            continue;
        }
        for (int k = 0; k < STEP_HALVINGS && !accepted(noiseChanged, now.sums, next.sums, n); ++k) {
            xi *= 0.5;
            next.pose = perturbed(now.pose, xi);
            next.sums = pass(next.pose, next.noise);
        }
        if (!noiseChanged && !accepted(noiseChanged, now.sums, next.sums, n)) {
            now.converged = true;  // no step falls any more: this is the minimum, to rounding
            break;
        }
        now = next;
    }
    return now;
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
