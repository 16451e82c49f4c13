// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_SPD3_HPP
#define OPENCV_GMLPNP_SPD3_HPP

#include "lie.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

using Eigen3d = Eigen::SelfAdjointEigenSolver<Matrix3d>;

template <class Derived>
typename Derived::PlainObject symmetrised(const Eigen::MatrixBase<Derived>& M)
{
    const typename Derived::PlainObject S = M;
    return 0.5 * (S + S.transpose());
}

/** An information matrix scaled to a unit diagonal, because rotations and translations have different units:
matrix = diag(scale) H diag(scale). */
struct UnitDiagonal
{
    explicit UnitDiagonal(const Matrix6d& H)
        : scale(H.diagonal().cwiseMax(std::numeric_limits<double>::min()).cwiseSqrt().cwiseInverse()),
          matrix(scale.asDiagonal() * H * scale.asDiagonal())
    {}

    Vector6d scale;
    Matrix6d matrix;
};

/** Adjugate of a symmetric matrix: S adj(S) = det(S) I, also where S is singular. */
inline Matrix3d adjugate(const Matrix3d& S)
{
    Matrix3d A;
    A.col(0) = S.col(1).cross(S.col(2));
    A.col(1) = S.col(2).cross(S.col(0));
    A.col(2) = S.col(0).cross(S.col(1));
    return symmetrised(A);
}

/** V f(lambda) V^T of a symmetric matrix. */
template <class Function>
Matrix3d spectral(const Matrix3d& S, Function f)
{
    const Eigen3d eigen(S);
    const Vector3d lambda = eigen.eigenvalues().unaryExpr(f);
    return symmetrised(eigen.eigenvectors() * lambda.asDiagonal() * eigen.eigenvectors().transpose());
}

/** Eigenvalues below `relative` times the largest are raised to it; a negative matrix becomes zero. */
inline Matrix3d floored(const Matrix3d& S, double relative)
{
    const Eigen3d eigen(S);
    const double floor = relative * std::max(eigen.eigenvalues()(2), 0.0);
    const Vector3d lambda = eigen.eigenvalues().cwiseMax(floor);
    return symmetrised(eigen.eigenvectors() * lambda.asDiagonal() * eigen.eigenvectors().transpose());
}

/** Square root of a positive semidefinite matrix; what rounding made negative counts as zero. */
inline Matrix3d squareRoot(const Matrix3d& S)
{
    return spectral(S, [](double x) { return std::sqrt(std::max(x, 0.0)); });
}

/** Eigenvalues above `relative` times the largest. */
inline int rank(const Matrix3d& S, double relative)
{
    const Vector3d lambda = Eigen3d(S, Eigen::EigenvaluesOnly).eigenvalues();
    int r = 0;
    for (int k = 0; k < 3; ++k)
        r += lambda(k) > relative * lambda(2);
    return r;
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_SPD3_HPP
