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

/** The matrix of its entries xx xy xz yy yz zz. */
inline Matrix3d symmetric(const double* entries)
{
    const double* k = entries;
    Matrix3d S;
    S << k[0], k[1], k[2], k[1], k[3], k[4], k[2], k[4], k[5];
    return S;
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

/** Eigenvalues below `relative` times the largest are raised to it; a negative matrix becomes zero. */
inline Matrix3d floored(const Matrix3d& S, double relative)
{
    const Eigen3d eigen(S);
    const double floor = relative * std::max(eigen.eigenvalues()(2), 0.0);
    const Vector3d lambda = eigen.eigenvalues().cwiseMax(floor);
    return symmetrised(eigen.eigenvectors() * lambda.asDiagonal() * eigen.eigenvectors().transpose());
}

/** S + relative tr(S) I: regular where S is positive semidefinite and not zero, without an eigenproblem. */
inline Matrix3d lifted(const Matrix3d& S, double relative)
{
    return S + relative * S.trace() * Matrix3d::Identity();
}

/** The geometric mean of A and B^-1, both SPD: the X with  X B X = A. It is the common limit of their arithmetic and
harmonic means, which converge quadratically and stay symmetric. */
inline Matrix3d geometricMean(Matrix3d A, Matrix3d B)
{
    constexpr int MOST = 60;         // each round takes a quarter off the logarithm of any ratio: never reached
    constexpr double EQUAL = 1e-11;  // of tr(A B) - 3, about the square of the relative difference
    // Both of determinant 1 saves rounds. By way of the trace, as determinants of very small or large entries would
    // leave the range of doubles; those of nearly singular matrices are rounding.
    const auto makeUnit = [](Matrix3d& S) {
        constexpr double REGULAR = 1e-9;
        const double trace = S.trace(), determinant = (S / trace).determinant();
        const double size = determinant > REGULAR ? trace * std::cbrt(determinant) : trace;
        S /= size;
        return size;
    };
    const double sizeA = makeUnit(A), sizeB = makeUnit(B);
    for (int k = 0; k < MOST; ++k) {
        const Matrix3d inverseA = A.inverse();
        A = 0.5 * (A + symmetrised(B.inverse()));
        B = 0.5 * (B + symmetrised(inverseA));
        if ((A * B).trace() - 3 < EQUAL)
            break;
    }
    return std::sqrt(sizeA / sizeB) * A;
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
