// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "polynomial_system.hpp"

#include <Eigen/Dense>

namespace baselines {

Polynomial Polynomial::constant(double value)
{
    Polynomial p;
    p.at(0, 0, 0) = value;
    return p;
}

Polynomial Polynomial::variable(int k)
{
    Polynomial p;
    p.at(k == 0, k == 1, k == 2) = 1;
    return p;
}

namespace {

using Exponents = std::array<int, 3>;

// Calls f(exponents) for all monomials up to a degree.
template <class Function>
void forMonomials(int degree, Function f)
{
    for (int i = 0; i <= degree; ++i)
        for (int j = 0; i + j <= degree; ++j)
            for (int k = 0; i + j + k <= degree; ++k)
                f(Exponents{i, j, k});
}

}  // namespace

Polynomial Polynomial::derivative(int variable) const
{
    Polynomial p;
    forMonomials(DEGREE, [&](Exponents e) {
        const double value = at(e[0], e[1], e[2]);
        const int power = e[variable]--;
        if (power > 0)
            p.at(e[0], e[1], e[2]) = power * value;
    });
    return p;
}

Polynomial operator+(Polynomial a, const Polynomial& b)
{
    for (size_t k = 0; k < a.coefficients.size(); ++k)
        a.coefficients[k] += b.coefficients[k];
    return a;
}

Polynomial operator*(double factor, Polynomial a)
{
    for (double& coefficient : a.coefficients)
        coefficient *= factor;
    return a;
}

Polynomial operator*(const Polynomial& a, const Polynomial& b)
{
    Polynomial p;
    forMonomials(Polynomial::DEGREE, [&](const Exponents& e) {
        const double factor = a.at(e[0], e[1], e[2]);
        if (factor == 0)
            return;
        forMonomials(Polynomial::DEGREE - e[0] - e[1] - e[2], [&](const Exponents& f) {
            p.at(e[0] + f[0], e[1] + f[1], e[2] + f[2]) += factor * b.at(f[0], f[1], f[2]);
        });
    });
    return p;
}

namespace {

// Monomials up to degree seven: first the 27 without a cube, then those with one.
constexpr int MACAULAY_DEGREE = 7, REDUCED = 27, ALL = 120, CUBIC = 3;
constexpr size_t EXPONENTS = MACAULAY_DEGREE + 1;

struct Layout
{
    std::vector<Exponents> monomials;
    std::array<int, EXPONENTS * EXPONENTS * EXPONENTS> indices{};

    Layout()
    {
        for (const bool reduced : {true, false})
            forMonomials(MACAULAY_DEGREE, [&](const Exponents& e) {
                if ((*std::max_element(e.begin(), e.end()) < CUBIC) != reduced)
                    return;
                indices[64 * e[0] + 8 * e[1] + e[2]] = static_cast<int>(monomials.size());
                monomials.push_back(e);
            });
    }

    int index(int i, int j, int k) const { return indices[64 * i + 8 * j + k]; }
};

// A row is a polynomial times a monomial.
void setRow(Eigen::MatrixXd& macaulay, int row, const Layout& layout, const Polynomial& p, int degree,
            const Exponents& shift)
{
    forMonomials(degree, [&](const Exponents& e) {
        macaulay(row, layout.index(e[0] + shift[0], e[1] + shift[1], e[2] + shift[2])) = p.at(e[0], e[1], e[2]);
    });
}

}  // namespace

std::vector<Vector3d> realRoots(const std::array<Polynomial, 3>& cubics)
{
    static const Layout layout;
    // Any linear form with different values at different roots will do.
    const Polynomial form = Polynomial::constant(0.7531) + 0.5172 * Polynomial::variable(0) +
                            -0.8339 * Polynomial::variable(1) + 0.3617 * Polynomial::variable(2);
    Eigen::MatrixXd macaulay = Eigen::MatrixXd::Zero(ALL, ALL);
    for (int row = 0; row < ALL; ++row) {
        Exponents shift = layout.monomials[row];
        int k = 0;
        while (k < 3 && shift[k] < CUBIC)
            ++k;
        if (k == 3) {
            setRow(macaulay, row, layout, form, 1, shift);
        } else {
            shift[k] -= CUBIC;
            setRow(macaulay, row, layout, cubics[k], CUBIC, shift);
        }
    }
    const int rest = ALL - REDUCED;
    const Eigen::MatrixXd multiplication =
        macaulay.topLeftCorner(REDUCED, REDUCED) -
        macaulay.topRightCorner(REDUCED, rest) *
            macaulay.bottomRightCorner(rest, rest).partialPivLu().solve(macaulay.bottomLeftCorner(rest, REDUCED));
    std::vector<Vector3d> roots;
    if (!multiplication.allFinite())
        return roots;
    // At a root the monomials without a cube are an eigenvector; the value of the form is its eigenvalue.
    const Eigen::EigenSolver<Eigen::MatrixXd> eigen(multiplication);
    constexpr double REAL = 1e-4;  // imaginary part, relative: two roots that meet come out as a complex pair
    for (int r = 0; r < REDUCED; ++r) {
        const Eigen::VectorXcd v = eigen.eigenvectors().col(r);
        const Eigen::Vector3cd s =
            Eigen::Vector3cd(v(layout.index(1, 0, 0)), v(layout.index(0, 1, 0)), v(layout.index(0, 0, 1))) /
            v(layout.index(0, 0, 0));
        if (s.allFinite() && s.imag().norm() < REAL * (1 + s.real().norm()))
            roots.emplace_back(s.real());
    }
    return roots;
}

}  // namespace baselines
