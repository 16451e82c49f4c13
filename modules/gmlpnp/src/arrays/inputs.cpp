// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "inputs.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {
namespace {

// Describes for the message what the caller passed: "2x5x3 of CV_32S, 1 channel".
String describe(const Mat& m)
{
    static const char* const DEPTHS[] = {"CV_8U", "CV_8S", "CV_16U", "CV_16S", "CV_32S", "CV_32F", "CV_64F"};
    String text = m.dims == 0 ? "0x0" : "";
    for (int i = 0; i < m.dims; ++i)
        text += (i > 0 ? "x" : "") + std::to_string(m.size[i]);
    const bool named = m.depth() < static_cast<int>(sizeof(DEPTHS) / sizeof(DEPTHS[0]));
    return text + " of " + (named ? DEPTHS[m.depth()] : "another depth") + ", " + std::to_string(m.channels()) +
           (m.channels() == 1 ? " channel" : " channels");
}

// Returns the one matrix behind an argument. A list of arrays is refused.
Mat singleMat(InputArray array, const char* name)
{
    if (array.isMatVector() || array.isUMatVector() || array.kind() == _InputArray::STD_VECTOR_VECTOR)
        CV_Error(Error::StsAssert, format("'%s' must be one array, not a list of arrays", name));
    return array.getMat();
}

bool holdsPoints(const Mat& m, int dim)
{
    if (m.empty() || (m.depth() != CV_32F && m.depth() != CV_64F))
        return false;
    if (m.dims == 3)
        return m.channels() == 1 && m.size[2] == dim && (m.size[0] == 1 || m.size[1] == 1);
    if (m.dims > 2)  // vectors of points pass: OpenCV 5 gives them one dimension and one row
        return false;
    return (m.channels() == 1 && m.cols == dim) || (m.channels() == dim && (m.rows == 1 || m.cols == 1));
}

}  // namespace

// NOLINTNEXTLINE(readability-const-return-type): it may share the memory of the caller
const Mat_<double> pointsFrom(InputArray points, int dim, const char* name)
{
    const Mat given = singleMat(points, name);
    if (!holdsPoints(given, dim))
        CV_Error(Error::StsAssert, format("'%s' must be N points of %d coordinates (N > 0), float or double: Nx%d, or "
                                          "Nx1 or 1xN with %d channels, or a vector of points; it is %s",
                                          name, dim, dim, dim, describe(given).c_str()));
    Mat dense;
    if (given.depth() == CV_64F)
        dense = given.isContinuous() ? given : given.clone();
    else
        given.convertTo(dense, CV_64F);
    const int shape[] = {static_cast<int>(dense.total() * dense.channels()) / dim, dim};
    return dense.reshape(1, 2, shape);
}

// NOLINTNEXTLINE(readability-const-return-type): likewise
const Mat_<double> matrixFrom(InputArray matrix, int rows, int cols, const char* name)
{
    const Mat given = singleMat(matrix, name);
    if (given.dims != 2 || given.rows != rows || given.cols != cols || given.channels() != 1)
        CV_Error(Error::StsAssert, format("'%s' must be a %dx%d matrix with one channel; it is %s", name, rows, cols,
                                          describe(given).c_str()));
    if (given.depth() == CV_64F)
        return given.isContinuous() ? given : given.clone();
    Mat dense;
    given.convertTo(dense, CV_64F);
    return dense;
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
