// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "../arrays/inputs.hpp"
#include "lens.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {
namespace {

// Largest parameter of a lens, in absolute value, and the inverse of the smallest focal length [px]. It is a limit of
// the range of doubles: products of several parameters stay finite.
constexpr double LARGEST_PARAMETER = 1e30;

}  // namespace

Intrinsics intrinsicsFrom(InputArray cameraMatrix)
{
    const Mat_<double> K = matrixFrom(cameraMatrix, 3, 3, "K (cameraMatrix)");
    if (!checkRange(K, true, nullptr, -LARGEST_PARAMETER, LARGEST_PARAMETER))
        CV_Error(Error::StsBadArg, "'K' (cameraMatrix) must be finite and at most 1e30");
    if (!(std::abs(K(0, 0)) * LARGEST_PARAMETER > 1 && std::abs(K(1, 1)) * LARGEST_PARAMETER > 1))
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
        if (!(std::abs(d) < LARGEST_PARAMETER))
            CV_Error(Error::StsBadArg, "'D' (distCoeffs) must be finite and at most 1e30");
    return D;
}

void requireRange(double value, double low, double high, const char* name)
{
    if (!(value >= low && value <= high))
        CV_Error(Error::StsBadArg, format("'%s' is %g; it must be between %g and %g", name, value, low, high));
}

void Lens::write(FileStorage& fs) const
{
    fs.write("model", model_);
    fs.write("K", Mat(k_.matrix()));
    writeParameters(fs);
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
