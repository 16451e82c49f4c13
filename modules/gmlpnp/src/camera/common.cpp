// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "common.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {
namespace {

constexpr int MAX_DEGREE = 8;

// The variable of the polynomials is the squared radius on the image plane. At this one a ray is within 1e-6 rad of a
// right angle to the axis, so a root beyond bounds nothing that a lens sees.
constexpr double LARGEST_ROOT = 1e12;

bool changesSign(const double* c, int degree)
{
    bool positive = false, negative = false;
    for (int i = 0; i <= degree; ++i) {
        positive = positive || c[i] > 0;
        negative = negative || c[i] < 0;
    }
    return positive && negative;
}

// Returns the last number on the side of `low` whose value has the sign of the value at `low`. The polynomial must
// change its sign once on [low, high].
double bisect(const double* c, int degree, double low, double high)
{
    const bool positive = polynomial(c, degree, low) > 0;
    for (;;) {
        const double middle = 0.5 * (low + high);
        if (!(middle > low && middle < high))
            return low;
        ((polynomial(c, degree, middle) > 0) == positive ? low : high) = middle;
    }
}

// Finds every sign change on (0, LARGEST_ROOT). Two neighbouring extrema have at most one between them, and the extrema
// are the roots of the derivative, which has one degree less.
int positiveRoots(const double* c, int degree, double* roots)
{
    if (degree == 0 || !changesSign(c, degree))
        return 0;
    if (c[0] == 0)
        return positiveRoots(c + 1, degree - 1, roots);
    double slope[MAX_DEGREE] = {}, stops[MAX_DEGREE + 1] = {};
    for (int i = 1; i <= degree; ++i)
        slope[i - 1] = i * c[i];
    int nStops = positiveRoots(slope, degree - 1, stops);
    stops[nStops++] = LARGEST_ROOT;

    int nRoots = 0;
    double low = 0;
    for (int i = 0; i < nStops; ++i) {
        if ((polynomial(c, degree, low) > 0) != (polynomial(c, degree, stops[i]) > 0))
            roots[nRoots++] = bisect(c, degree, low, stops[i]);
        low = stops[i];
    }
    return nRoots;
}

}  // namespace

double firstPositiveRoot(const double* c, int degree)
{
    CV_DbgAssert(degree <= MAX_DEGREE && c[0] > 0);
    double roots[MAX_DEGREE] = {};
    return positiveRoots(c, degree, roots) > 0 ? roots[0] : std::numeric_limits<double>::infinity();
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
