// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_ARRAYS_EIGEN_HPP
#define OPENCV_GMLPNP_ARRAYS_EIGEN_HPP

#include "../math/lie.hpp"

#include <opencv2/core/eigen.hpp>

namespace cv {
namespace gmlpnp {
namespace detail {

// OpenCV's conversions (opencv2/core/eigen.hpp), as functions that return their result.

inline Vector3d toEigen(const Vec3d& v)
{
    return {v[0], v[1], v[2]};
}

inline Vec3d toVec(const Vector3d& v)
{
    return {v.x(), v.y(), v.z()};
}

template <int ROWS, int COLS>
Mat toMat(const Eigen::Matrix<double, ROWS, COLS>& M)
{
    Mat out(ROWS, COLS, CV_64F);
    Eigen::Map<Eigen::Matrix<double, ROWS, COLS, Eigen::RowMajor>>(out.ptr<double>()) = M;  // without eigen2cv()'s copy
    return out;
}

/** Returns the 3x3 matrix of nine numbers by rows. */
inline Matrix3d matrix3(const double* rowMajor)
{
    Matrix3d M;
    cv2eigen(Matx33d(rowMajor), M);
    return M;
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_ARRAYS_EIGEN_HPP
