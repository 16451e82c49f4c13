// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "../arrays/inputs.hpp"
#include "common.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {
namespace {

const int kMaxDegree = 8;
const double kLargestParameter = 1e30;
const double kLargestRoot = 1e12;  // squared radius on the image plane: within 1e-6 rad of a right angle

bool changesSign(const double* c, int degree)
{
    bool positive = false, negative = false;
    for (int i = 0; i <= degree; ++i) {
        positive = positive || c[i] > 0;
        negative = negative || c[i] < 0;
    }
    return positive && negative;
}

// The end of [low, high] next to `low` where the sign at `low` ends; the polynomial changes its sign once in between.
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

// Every sign change on (0, kLargestRoot): between two neighbouring extrema there is one at most.
int positiveRoots(const double* c, int degree, double* roots)
{
    if (degree == 0 || !changesSign(c, degree))
        return 0;
    if (c[0] == 0)
        return positiveRoots(c + 1, degree - 1, roots);
    double slope[kMaxDegree] = {}, stops[kMaxDegree + 1] = {};
    for (int i = 1; i <= degree; ++i)
        slope[i - 1] = i * c[i];
    int nStops = positiveRoots(slope, degree - 1, stops);
    stops[nStops++] = kLargestRoot;

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
    CV_DbgAssert(degree <= kMaxDegree && c[0] > 0);
    double roots[kMaxDegree] = {};
    return positiveRoots(c, degree, roots) > 0 ? roots[0] : std::numeric_limits<double>::infinity();
}

Intrinsics intrinsicsFrom(InputArray cameraMatrix)
{
    const Mat_<double> K = matrixFrom(cameraMatrix, 3, 3, "K (cameraMatrix)");
    if (!checkRange(K, true, nullptr, -kLargestParameter, kLargestParameter))
        CV_Error(Error::StsBadArg, "'K' (cameraMatrix) must be finite and at most 1e30");
    if (!(std::abs(K(0, 0)) * kLargestParameter > 1 && std::abs(K(1, 1)) * kLargestParameter > 1))
        CV_Error(Error::StsBadArg, "'K' (cameraMatrix) has a focal length of zero");
    return {K(0, 0), K(1, 1), K(0, 1), K(0, 2), K(1, 2)};
}

std::vector<double> coefficientsFrom(InputArray coefficients, std::initializer_list<int> counts, size_t size)
{
    std::vector<double> D(size, 0.0);
    if (coefficients.empty())
        return D;
    if (coefficients.isMatVector() || coefficients.isUMatVector() ||
        coefficients.kind() == _InputArray::STD_VECTOR_VECTOR)
        CV_Error(Error::StsAssert, "'D' (distCoeffs) must be one array, not a list of arrays");
    const Mat given = coefficients.getMat();
    const int n = static_cast<int>(given.total()) * given.channels();
    const bool isVector = given.dims <= 2 && (given.rows == 1 || given.cols == 1);
    if (!isVector || std::find(counts.begin(), counts.end(), n) == counts.end()) {
        String allowed = "0";
        for (const int count : counts)
            allowed += ", " + std::to_string(count);
        CV_Error(Error::StsAssert,
                 format("'D' (distCoeffs) must be a row or column of %s coefficients; it has %d", allowed.c_str(), n));
    }
    Mat dense;
    given.convertTo(dense, CV_64F);
    std::copy(dense.ptr<double>(), dense.ptr<double>() + n, D.begin());
    for (const double d : D)
        if (!(std::abs(d) < kLargestParameter))
            CV_Error(Error::StsBadArg, "'D' (distCoeffs) must be finite and at most 1e30");
    return D;
}

void requireRange(double value, double low, double high, const char* name)
{
    if (!(value >= low && value <= high))
        CV_Error(Error::StsBadArg, format("'%s' is %g; it must be between %g and %g", name, value, low, high));
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
