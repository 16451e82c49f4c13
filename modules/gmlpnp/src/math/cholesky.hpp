// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_MATH_CHOLESKY_HPP
#define OPENCV_GMLPNP_MATH_CHOLESKY_HPP

#include "../precomp.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

/** The factors A = L D L^T of a small matrix of fixed size. They need no square roots, and the units of the rows do not
matter. Eigen's LDLT has loops for matrices of any size, which take three times as long at 6 x 6. */
template <int N>
class CholeskyFactor
{
public:
    using Matrix = Eigen::Matrix<double, N, N>;
    using Vector = Eigen::Matrix<double, N, 1>;

    explicit CholeskyFactor(const Matrix& A)
    {
        double LD[N][N];
        for (int j = 0; j < N; ++j) {
            for (int i = j; i < N; ++i) {
                double rest = A(i, j);
                for (int k = 0; k < j; ++k)
                    rest -= LD[i][k] * L_[j][k];
                LD[i][j] = rest;
            }
            if (!(LD[j][j] > 0))
                return;
            inverse_[j] = 1 / LD[j][j];
            for (int i = j + 1; i < N; ++i)
                L_[i][j] = LD[i][j] * inverse_[j];
        }
        positive_ = true;
    }

    /** Says whether A is positive definite. Only then solve() may be called. */
    bool positiveDefinite() const { return positive_; }

    /** Returns the x with A x = b. */
    Vector solve(const Vector& b) const
    {
        Vector x;
        for (int i = 0; i < N; ++i) {
            double rest = b(i);
            for (int k = 0; k < i; ++k)
                rest -= L_[i][k] * x(k);
            x(i) = rest;
        }
        for (int i = N - 1; i >= 0; --i) {
            double rest = x(i) * inverse_[i];
            for (int k = i + 1; k < N; ++k)
                rest -= L_[k][i] * x(k);
            x(i) = rest;
        }
        return x;
    }

private:
    double L_[N][N];     // only the part below the diagonal; on it are ones
    double inverse_[N];  // of the diagonal of D
    bool positive_ = false;
};

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_MATH_CHOLESKY_HPP
