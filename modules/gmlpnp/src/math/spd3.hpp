// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_MATH_SPD3_HPP
#define OPENCV_GMLPNP_MATH_SPD3_HPP

#include "lie.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

using Eigen3d = Eigen::SelfAdjointEigenSolver<Matrix3d>;

/** Returns the symmetric part of M. */
template <class Derived>
typename Derived::PlainObject symmetrised(const Eigen::MatrixBase<Derived>& M)
{
    const typename Derived::PlainObject S = M;
    return 0.5 * (S + S.transpose());
}

/** Returns the matrix of its entries xx xy xz yy yz zz. The functions below exchange entries because six numbers are
faster than nine. */
inline Matrix3d symmetric(const double* entries)
{
    const double* k = entries;
    Matrix3d S;
    S << k[0], k[1], k[2], k[1], k[3], k[4], k[2], k[4], k[5];
    return S;
}

/** An information matrix scaled to a unit diagonal: matrix = diag(scale) H diag(scale). Rotations and translations have
different units, so only the scaled matrix has a condition that means something. */
struct UnitDiagonal
{
    explicit UnitDiagonal(const Matrix6d& H)
        : scale(H.diagonal().cwiseMax(std::numeric_limits<double>::min()).cwiseSqrt().cwiseInverse()),
          matrix(scale.asDiagonal() * H * scale.asDiagonal())
    {}

    Vector6d scale;
    Matrix6d matrix;
};

/** Returns the entries xx xy xz yy yz zz. */
inline Vector6d entriesOf(const Matrix3d& S)
{
    Vector6d k;
    k << S(0, 0), S(0, 1), S(0, 2), S(1, 1), S(1, 2), S(2, 2);
    return k;
}

inline Vector6d adjugateEntries(const Vector6d& k)
{
    Vector6d out;
    out << k[3] * k[5] - k[4] * k[4], k[2] * k[4] - k[1] * k[5], k[1] * k[4] - k[2] * k[3], k[0] * k[5] - k[2] * k[2],
        k[1] * k[2] - k[0] * k[4], k[0] * k[3] - k[1] * k[1];
    return out;
}

inline double determinantOf(const Vector6d& entries, const Vector6d& adjugate)
{
    return entries.head<3>().dot(adjugate.head<3>());
}

inline Vector6d inverseEntries(const Vector6d& entries)
{
    const Vector6d adjugate = adjugateEntries(entries);
    return adjugate / determinantOf(entries, adjugate);
}

/** Returns the adjugate of a symmetric matrix: S adj(S) = det(S) I, also where S is singular. */
inline Matrix3d adjugate(const Matrix3d& S)
{
    const Vector6d entries = adjugateEntries(entriesOf(S));
    return symmetric(entries.data());
}

/** Returns the inverse of a symmetric matrix. */
inline Matrix3d inverse(const Matrix3d& S)
{
    const Vector6d entries = inverseEntries(entriesOf(S));
    return symmetric(entries.data());
}

/** Raises the eigenvalues below `relative` times the largest to that floor. A negative matrix becomes zero. */
inline Matrix3d floored(const Matrix3d& S, double relative)
{
    const Eigen3d eigen(S);
    const double floor = relative * std::max(eigen.eigenvalues()(2), 0.0);
    const Vector3d lambda = eigen.eigenvalues().cwiseMax(floor);
    return symmetrised(eigen.eigenvectors() * lambda.asDiagonal() * eigen.eigenvectors().transpose());
}

/** Returns S + relative tr(S) I. It is regular where S is positive semidefinite and not zero, and needs no
eigenproblem. */
inline Matrix3d lifted(const Matrix3d& S, double relative)
{
    return S + relative * S.trace() * Matrix3d::Identity();
}

/** Returns the geometric mean A # B^-1 of the SPD matrices A and B^-1: the X with  X B X = A (the MM update of
doc/theory.md, section 3). It is the common limit of their arithmetic and harmonic means, which converge quadratically
and stay symmetric. */
inline Matrix3d geometricMean(const Matrix3d& A, const Matrix3d& B)
{
    constexpr int MOST_ROUNDS = 60;        // never reached: a round takes a quarter off the logarithm of any ratio
    constexpr double EQUAL_MEANS = 1e-11;  // rounding, of tr(A B) - 3: about the square of the relative difference
    // Determinants of 1 save rounds. The matrix is divided by its trace first, because the determinant of very small or
    // large entries would leave the range of doubles. The determinant of a nearly singular matrix is rounding, so the
    // trace alone scales that one.
    const auto makeUnit = [](Vector6d& S) {
        constexpr double SMALLEST_DETERMINANT = 1e-9;  // rounding, at a trace of 1
        const double trace = S[0] + S[3] + S[5];
        const Vector6d T = S / trace;
        const double determinant = determinantOf(T, adjugateEntries(T));
        const double size = determinant > SMALLEST_DETERMINANT ? trace * std::cbrt(determinant) : trace;
        S /= size;
        return size;
    };
    Vector6d a = entriesOf(A), b = entriesOf(B);
    const double sizeA = makeUnit(a), sizeB = makeUnit(b);
    for (int k = 0; k < MOST_ROUNDS; ++k) {
        const Vector6d inverseA = inverseEntries(a);
        a = 0.5 * (a + inverseEntries(b));
        b = 0.5 * (b + inverseA);
        const Vector6d products = a.cwiseProduct(b);
        if (products[0] + products[3] + products[5] + 2 * (products[1] + products[2] + products[4]) - 3 < EQUAL_MEANS)
            break;
    }
    a *= std::sqrt(sizeA / sizeB);
    return symmetric(a.data());
}

/** Returns the number of eigenvalues above `relative` times the largest. */
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

#endif  // OPENCV_GMLPNP_MATH_SPD3_HPP
