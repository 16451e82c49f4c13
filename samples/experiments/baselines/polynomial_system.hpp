// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_BASELINES_POLYNOMIAL_SYSTEM_HPP
#define GMLPNP_BASELINES_POLYNOMIAL_SYSTEM_HPP

#include "baselines.hpp"

namespace baselines {

/** A polynomial of degree at most four in three variables. */
class Polynomial
{
public:
    static constexpr int DEGREE = 4;

    static Polynomial constant(double value);
    static Polynomial variable(int k);
    static Polynomial square(int k) { return variable(k) * variable(k); }

    double& at(int i, int j, int k) { return coefficients[(i * (DEGREE + 1) + j) * (DEGREE + 1) + k]; }
    double at(int i, int j, int k) const { return coefficients[(i * (DEGREE + 1) + j) * (DEGREE + 1) + k]; }

    Polynomial derivative(int variable) const;

    friend Polynomial operator+(Polynomial a, const Polynomial& b);
    friend Polynomial operator-(const Polynomial& a, const Polynomial& b) { return a + -1 * b; }
    friend Polynomial operator*(double factor, Polynomial a);
    friend Polynomial operator*(const Polynomial& a, const Polynomial& b);

private:
    static constexpr size_t POWERS = DEGREE + 1;
    std::array<double, POWERS * POWERS * POWERS> coefficients{};
};

/** The real common roots of three cubics: at most 27, by the Macaulay resultant with a linear form that tells them
apart. Roots that lost digits come out too; roots at infinity do not. */
std::vector<Vector3d> realRoots(const std::array<Polynomial, 3>& cubics);

}  // namespace baselines

#endif  // GMLPNP_BASELINES_POLYNOMIAL_SYSTEM_HPP
