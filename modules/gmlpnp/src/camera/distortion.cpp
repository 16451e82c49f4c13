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

// Rounding.
constexpr double LARGEST_RESIDUAL = 1e-12;  // of G(u) - distorted, relative to max(1, |distorted|)
constexpr double LAST_DIGIT = std::numeric_limits<double>::epsilon();  // of the same residual

// Limits of Newton's method and steps along a path. Lenses in use need few of them; the tests of camera/test_distortion
// hold the rest.
constexpr double START_TOLERANCE = 1e-3;  // relative: the radial start only has to reach Newton's basin
constexpr int MAX_NEWTON_STEPS = 50;
constexpr int MAX_HALVINGS = 12;
constexpr int SAFE_RADIUS_STEPS = 64;
constexpr int PATH_STEPS = 32;             // samples between safeRadius_ and a point outside of it
constexpr double LARGEST_SAFE_RADIUS = 8;  // 83 degrees off the axis of a pinhole; beyond, each path is tested
constexpr double FOLD_MARGIN = 1e-3;       // relative: the start lies so far inside of the fold if no radius solves R
constexpr double FIRST_STRIDE = 0.25;      // of the way from the centre to the distorted point
constexpr double LAST_STRIDE = 1.0 / 1024;

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

// Sets the polynomial N M + 2 q (N' M - N M'), which has the sign of d(r R)/dr at q = r^2.
void radialSlopeSign(const double* N, const double* M, double* P)
{
    std::fill(P, P + 7, 0.0);
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            P[i + j] += N[i] * M[j] * (1 + 2 * (i - j));
}

}  // namespace

Distortion::Distortion(const std::vector<double>& D)
    : N_{1, D[0], D[1], D[4]},
      M_{1, D[5], D[6], D[7]},
      p1_(D[2]),
      p2_(D[3]),
      s1_(D[8]),
      s2_(D[9]),
      s3_(D[10]),
      s4_(D[11])
{
    none_ = std::all_of(D.begin(), D.begin() + 12, [](double d) { return d == 0; });
    isRadial_ = p1_ == 0 && p2_ == 0 && s1_ == 0 && s2_ == 0 && s3_ == 0 && s4_ == 0;
    double P[7];
    radialSlopeSign(N_, M_, P);
    const double q = std::min(firstPositiveRoot(P, 6), std::min(firstPositiveRoot(N_, 3), firstPositiveRoot(M_, 3)));
    foldRadius_ = std::sqrt(q);
    safeRadius_ = foldRadius_;
    if (isRadial_)
        return;
    safeRadius_ = 0;
    const double step = std::min(foldRadius_, LARGEST_SAFE_RADIUS) / SAFE_RADIUS_STEPS;
    for (int i = 1; i <= SAFE_RADIUS_STEPS && lowestEigenvalueBound(i * step) > 0; ++i)
        safeRadius_ = i * step;
}

// Returns r R(r^2) and sets its slope by r.
double Distortion::radial(double r, double& slope) const
{
    const double q = r * r;
    const double n = N_[0] + q * (N_[1] + q * (N_[2] + q * N_[3])), m = M_[0] + q * (M_[1] + q * (M_[2] + q * M_[3]));
    const double dn = N_[1] + q * (2 * N_[2] + q * 3 * N_[3]), dm = M_[1] + q * (2 * M_[2] + q * 3 * M_[3]);
    const double w = 1 / m, R = n * w;
    slope = R + 2 * q * (dn - R * dm) * w;
    return r * R;
}

// Returns a lower bound of the eigenvalues of the symmetric part of J on the circle of radius r.
double Distortion::lowestEigenvalueBound(double r) const
{
    double slope;
    const double ratio = radial(r, slope) / r;
    const double tangential = 6 * r * std::sqrt(p1_ * p1_ + p2_ * p2_);
    const double x = std::abs(s1_) + 2 * r * r * std::abs(s2_), y = std::abs(s3_) + 2 * r * r * std::abs(s4_);
    return std::min(ratio, slope) - tangential - 2 * r * (x + y);
}

Point2d Distortion::apply(const Point2d& u, Matx22d& J) const
{
    const double x = u.x, y = u.y, xx = x * x, yy = y * y, xy = x * y, q = xx + yy;
    const double n = N_[0] + q * (N_[1] + q * (N_[2] + q * N_[3])), m = M_[0] + q * (M_[1] + q * (M_[2] + q * M_[3]));
    const double dn = N_[1] + q * (2 * N_[2] + q * 3 * N_[3]), dm = M_[1] + q * (2 * M_[2] + q * 3 * M_[3]);
    const double w = 1 / m, R = n * w, dR = 2 * (dn - R * dm) * w;  // dR is twice the derivative by r^2
    const double prismX = 2 * (s1_ + 2 * s2_ * q), prismY = 2 * (s3_ + 2 * s4_ * q);
    const double cross = dR * xy + 2 * (p1_ * x + p2_ * y);
    J = Matx22d(R + dR * xx + 2 * p1_ * y + 6 * p2_ * x + prismX * x, cross + prismX * y, cross + prismY * x,
                R + dR * yy + 6 * p1_ * y + 2 * p2_ * x + prismY * y);
    return {x * R + 2 * p1_ * xy + p2_ * (q + 2 * xx) + q * (s1_ + s2_ * q),
            y * R + p1_ * (q + 2 * yy) + 2 * p2_ * xy + q * (s3_ + s4_ * q)};
}

bool Distortion::applyInside(Point2d& u) const
{
    if (none_)
        return true;
    if (!contains(u))
        return false;
    Matx22d J;
    u = apply(u, J);
    return true;
}

bool Distortion::contains(const Point2d& u) const
{
    const double r = hypotenuse(u);
    if (r < safeRadius_ || r == 0)
        return true;
    if (isRadial_ || !(r < foldRadius_))
        return false;
    for (int i = 1; i <= PATH_STEPS; ++i) {
        const double reach = (safeRadius_ + (r - safeRadius_) * i / PATH_STEPS) / r;
        Matx22d J;
        apply(u * reach, J);
        if (!(lowestEigenvalueOfSymmetricPart(J) > 0))
            return false;
    }
    return true;
}

// Starts at the solution without p and s, which lies within reach of Newton's method.
bool Distortion::startRadially(const Point2d& distorted, Point2d& u) const
{
    const double target = hypotenuse(distorted);
    if (target == 0) {
        u = distorted;
        return true;
    }
    const auto curve = [this](double r, double& slope) { return radial(r, slope); };
    double high = std::min(foldRadius_, 2 * target), slope;
    while (radial(high, slope) < target && high < foldRadius_)
        high = std::min(foldRadius_, 2 * high);
    double r = foldRadius_ * (1 - FOLD_MARGIN);
    if (radial(high, slope) >= target)
        r = solveIncreasing(curve, target, 0, high, target, START_TOLERANCE);
    else if (isRadial_ || !std::isfinite(foldRadius_))
        return false;
    u = distorted * (r / target);
    return true;
}

// Runs Newton's method until rounding stops it. A step that would not shrink the residual is halved.
bool Distortion::refine(const Point2d& distorted, Point2d& u, Matx22d& J) const
{
    const double scale = std::max(1.0, hypotenuse(distorted));
    Point2d excess = apply(u, J) - distorted;
    double size = hypotenuse(excess);
    for (int step = 0; step < MAX_NEWTON_STEPS && size > LAST_DIGIT * scale; ++step) {
        const Vec2d move = inverse(J) * Vec2d(excess.x, excess.y);
        double damping = 1;
        bool shrunk = false;
        for (int halving = 0; halving < MAX_HALVINGS && !shrunk; ++halving, damping *= 0.5) {
            const Point2d trial(u.x - damping * move[0], u.y - damping * move[1]);
            Matx22d Jt;
            const Point2d e = apply(trial, Jt) - distorted;
            shrunk = hypotenuse(e) < size;
            if (shrunk) {
                u = trial;
                J = Jt;
                excess = e;
                size = hypotenuse(e);
            } else if (size <= LARGEST_RESIDUAL * scale)
                return true;  // the residual is at the last digit, where halving no longer helps
        }
        if (!shrunk)
            break;
    }
    return size <= LARGEST_RESIDUAL * scale;
}

// Follows the straight way from the centre to the distorted point. This is slow and is meant for points close to the
// fold.
bool Distortion::follow(const Point2d& distorted, Point2d& u, Matx22d& J) const
{
    u = Point2d(0, 0);
    double reached = 0, stride = FIRST_STRIDE;
    while (reached < 1) {
        const double next = std::min(1.0, reached + stride);
        Point2d trial = u;
        if (refine(distorted * next, trial, J) && contains(trial)) {
            u = trial;
            reached = next;
        } else if ((stride *= 0.5) < LAST_STRIDE)
            return false;
    }
    return true;
}

bool Distortion::invert(const Point2d& distorted, Point2d& u, Matx22d& J) const
{
    if (!(distorted.dot(distorted) < LARGEST_SQUARED_RADIUS))
        return false;
    if (none_) {
        u = distorted;
        J = Matx22d::eye();
        return true;
    }
    // The domain holds at most one solution, so any start that leads into it will do. The quickest start comes first.
    u = distorted;
    if (refine(distorted, u, J) && contains(u))
        return true;
    if (startRadially(distorted, u) && refine(distorted, u, J) && contains(u))
        return true;
    return !isRadial_ && follow(distorted, u, J);
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
