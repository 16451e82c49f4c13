// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "common.hpp"
#include "distortion.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {
namespace {

const double kStartTolerance = 1e-3;  // relative: the radial start only has to reach Newton's basin
const double kResidual = 1e-12;       // of G(u) - distorted, relative to max(1, |distorted|)
const double kLastDigit = std::numeric_limits<double>::epsilon();  // of the residual, relative likewise
const int kMaxNewtonSteps = 50;
const int kMaxHalvings = 12;
const int kSafeRadiusSteps = 64;
const int kPathSteps = 32;            // samples between safeRadius and a point outside of it
const double kLargestSafeRadius = 8;  // 83 degrees off the axis of a pinhole; beyond, each path is looked at
const double kFoldMargin = 1e-3;      // relative: where to start when the radial part alone has no solution
const double kFirstStride = 0.25;     // of the way from the centre to the distorted point
const double kLastStride = 1.0 / 1024;

double hypotenuse(const Point2d& p)
{
    return std::sqrt(p.x * p.x + p.y * p.y);
}

double lowestEigenvalueOfSymmetricPart(const Matx22d& J)
{
    const double mean = 0.5 * (J(0, 0) + J(1, 1));
    const double difference = 0.5 * (J(0, 0) - J(1, 1)), off = 0.5 * (J(0, 1) + J(1, 0));
    return mean - std::sqrt(difference * difference + off * off);
}

// N M + 2 q (N' M - N M'), whose sign is that of d(r R)/dr at q = r^2.
void radialSlopeSign(const double* N, const double* M, double* P)
{
    std::fill(P, P + 7, 0.0);
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            P[i + j] += N[i] * M[j] * (1 + 2 * (i - j));
}

}  // namespace

Distortion::Distortion(const std::vector<double>& D)
    : N{1, D[0], D[1], D[4]}, M{1, D[5], D[6], D[7]}, p1(D[2]), p2(D[3]), s1(D[8]), s2(D[9]), s3(D[10]), s4(D[11])
{
    none = std::all_of(D.begin(), D.begin() + 12, [](double d) { return d == 0; });
    isRadial = p1 == 0 && p2 == 0 && s1 == 0 && s2 == 0 && s3 == 0 && s4 == 0;
    double P[7];
    radialSlopeSign(N, M, P);
    const double q = std::min(firstPositiveRoot(P, 6), std::min(firstPositiveRoot(N, 3), firstPositiveRoot(M, 3)));
    foldRadius = std::sqrt(q);
    safeRadius = foldRadius;
    if (isRadial)
        return;
    safeRadius = 0;
    const double step = std::min(foldRadius, kLargestSafeRadius) / kSafeRadiusSteps;
    for (int i = 1; i <= kSafeRadiusSteps && lowestEigenvalueBound(i * step) > 0; ++i)
        safeRadius = i * step;
}

// r R(r^2) and its slope by r.
double Distortion::radial(double r, double& slope) const
{
    const double q = r * r;
    const double n = N[0] + q * (N[1] + q * (N[2] + q * N[3])), m = M[0] + q * (M[1] + q * (M[2] + q * M[3]));
    const double dn = N[1] + q * (2 * N[2] + q * 3 * N[3]), dm = M[1] + q * (2 * M[2] + q * 3 * M[3]);
    const double w = 1 / m, R = n * w;
    slope = R + 2 * q * (dn - R * dm) * w;
    return r * R;
}

// Not above any eigenvalue of the symmetric part of J on the circle of radius r.
double Distortion::lowestEigenvalueBound(double r) const
{
    double slope;
    const double ratio = radial(r, slope) / r;
    const double tangential = 6 * r * std::sqrt(p1 * p1 + p2 * p2);
    const double x = std::abs(s1) + 2 * r * r * std::abs(s2), y = std::abs(s3) + 2 * r * r * std::abs(s4);
    return std::min(ratio, slope) - tangential - 2 * r * (x + y);
}

Point2d Distortion::apply(const Point2d& u, Matx22d& J) const
{
    const double x = u.x, y = u.y, xx = x * x, yy = y * y, xy = x * y, q = xx + yy;
    const double n = N[0] + q * (N[1] + q * (N[2] + q * N[3])), m = M[0] + q * (M[1] + q * (M[2] + q * M[3]));
    const double dn = N[1] + q * (2 * N[2] + q * 3 * N[3]), dm = M[1] + q * (2 * M[2] + q * 3 * M[3]);
    const double w = 1 / m, R = n * w, dR = 2 * (dn - R * dm) * w;  // dR: twice the derivative by r^2
    const double prismX = 2 * (s1 + 2 * s2 * q), prismY = 2 * (s3 + 2 * s4 * q);
    const double cross = dR * xy + 2 * (p1 * x + p2 * y);
    J = Matx22d(R + dR * xx + 2 * p1 * y + 6 * p2 * x + prismX * x, cross + prismX * y, cross + prismY * x,
                R + dR * yy + 6 * p1 * y + 2 * p2 * x + prismY * y);
    return {x * R + 2 * p1 * xy + p2 * (q + 2 * xx) + q * (s1 + s2 * q),
            y * R + p1 * (q + 2 * yy) + 2 * p2 * xy + q * (s3 + s4 * q)};
}

bool Distortion::contains(const Point2d& u) const
{
    const double r = hypotenuse(u);
    if (r < safeRadius || r == 0)
        return true;
    if (isRadial || !(r < foldRadius))
        return false;
    for (int i = 1; i <= kPathSteps; ++i) {
        const double reach = (safeRadius + (r - safeRadius) * i / kPathSteps) / r;
        Matx22d J;
        apply(u * reach, J);
        if (!(lowestEigenvalueOfSymmetricPart(J) > 0))
            return false;
    }
    return true;
}

// The solution without p and s: within reach of Newton's method.
bool Distortion::startRadially(const Point2d& distorted, Point2d& u) const
{
    const double target = hypotenuse(distorted);
    if (target == 0) {
        u = distorted;
        return true;
    }
    const auto curve = [this](double r, double& slope) { return radial(r, slope); };
    double high = std::min(foldRadius, 2 * target), slope;
    while (radial(high, slope) < target && high < foldRadius)
        high = std::min(foldRadius, 2 * high);
    double r = foldRadius * (1 - kFoldMargin);
    if (radial(high, slope) >= target)
        r = solveIncreasing(curve, target, 0, high, target, kStartTolerance);
    else if (isRadial || !std::isfinite(foldRadius))
        return false;
    u = distorted * (r / target);
    return true;
}

// Newton's method, halving the step where the residual would not shrink, until rounding stops it.
bool Distortion::refine(const Point2d& distorted, Point2d& u, Matx22d& J) const
{
    const double scale = std::max(1.0, hypotenuse(distorted));
    Point2d excess = apply(u, J) - distorted;
    double size = hypotenuse(excess);
    for (int step = 0; step < kMaxNewtonSteps && size > kLastDigit * scale; ++step) {
        const Vec2d move = inverse(J) * Vec2d(excess.x, excess.y);
        double damping = 1;
        bool shrunk = false;
        for (int halving = 0; halving < kMaxHalvings && !shrunk; ++halving, damping *= 0.5) {
            const Point2d trial(u.x - damping * move[0], u.y - damping * move[1]);
            Matx22d Jt;
            const Point2d e = apply(trial, Jt) - distorted;
            shrunk = hypotenuse(e) < size;
            if (shrunk) {
                u = trial;
                J = Jt;
                excess = e;
                size = hypotenuse(e);
            } else if (size <= kResidual * scale)
                return true;  // at the last digit: nothing left to halve
        }
        if (!shrunk)
            break;
    }
    return size <= kResidual * scale;
}

// Along the straight way from the centre to the distorted point: slow, for what lies close to the fold.
bool Distortion::follow(const Point2d& distorted, Point2d& u, Matx22d& J) const
{
    u = Point2d(0, 0);
    double reached = 0, stride = kFirstStride;
    while (reached < 1) {
        const double next = std::min(1.0, reached + stride);
        Point2d trial = u;
        if (refine(distorted * next, trial, J) && contains(trial)) {
            u = trial;
            reached = next;
        } else if ((stride *= 0.5) < kLastStride)
            return false;
    }
    return true;
}

bool Distortion::invert(const Point2d& distorted, Point2d& u, Matx22d& J) const
{
    if (!(distorted.dot(distorted) < kLargestSquaredRadius))
        return false;
    if (none) {
        u = distorted;
        J = Matx22d::eye();
        return true;
    }
    // The domain holds one solution at most, so that any start that leads into it will do: the quickest first.
    u = distorted;
    if (refine(distorted, u, J) && contains(u))
        return true;
    if (startRadially(distorted, u) && refine(distorted, u, J) && contains(u))
        return true;
    return !isRadial && follow(distorted, u, J);
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
