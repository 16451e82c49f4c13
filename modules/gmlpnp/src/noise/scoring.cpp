// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "../math/cholesky.hpp"
#include "model.hpp"
#include "scoring.hpp"
#include "tails.hpp"

// Fisher scoring of Sigma or of Gamma (doc/theory.md, section 3). The gradient is  dL/dC = (G - Z) / 2,  the expected
// curvature  1/2 sum tr(Q E Q E').  It converges in 3 or 4 rounds even in directions that the data hardly observe,
// where MM crawls. These directions are held by the prior whose fixed point is the shrinkage:
//
//     kappa / 2 (log det C + tr(C_0 C^-1)),   C_0 = tr(C) / 3 I

namespace cv {
namespace gmlpnp {
namespace detail {

Products productsFor(NoiseKind kind)
{
    return kind == NoiseKind::OBJECT ? OF_OBJECT : kind == NoiseKind::BEARING ? OF_BEARING : NO_PRODUCTS;
}

namespace {

constexpr int FIRST[6] = {0, 0, 0, 1, 1, 2}, SECOND[6] = {0, 1, 2, 1, 2, 2};  // xx xy xz yy yz zz
constexpr int ENTRY[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};

}  // namespace

Vector6d againstUnits(const Matrix3d& A)
{
    Vector6d out;
    for (int k = 0; k < 6; ++k)
        out(k) = (FIRST[k] == SECOND[k] ? 1 : 2) * A(FIRST[k], SECOND[k]);
    return out;
}

Matrix6d curvature(const Matrix6d& QQ)
{
    Matrix6d F;
    for (int a = 0; a < 6; ++a)
        for (int b = 0; b < 6; ++b) {
            const int i = FIRST[a], j = SECOND[a], k = FIRST[b], l = SECOND[b];
            const double both = QQ(ENTRY[j][k], ENTRY[i][l]) + QQ(ENTRY[j][l], ENTRY[i][k]);
            F(a, b) = both / ((i == j ? 2 : 1) * (k == l ? 2 : 1));
        }
    return F;
}

namespace {

struct Prior
{
    Vector6d score;  // of -L
    Matrix6d curvature;
};

Prior prior(const Matrix3d& C, double kappa)
{
    const Matrix3d W = inverse(C);
    const Matrix3d pull = W - C.trace() / 3 * W * W;
    const Vector6d q = entriesOf(W);
    return {-0.5 * kappa * againstUnits(pull), kappa * curvature(q * q.transpose())};
}

// C moved along the geodesic that starts in the direction of `step`. So it stays positive definite.
Matrix3d moved(const Matrix3d& C, const Matrix3d& step)
{
    constexpr double SHRINK = -2.5, GROW = 1.5;  // bounds of the logarithm: the curvature is known nearby only
    const Matrix3d L = C.llt().matrixL();
    const Matrix3d inverseL = L.inverse();
    Eigen3d eigen;
    eigen.computeDirect(symmetrised(inverseL * step *
                                    inverseL.transpose()));  // less exact than the iteration, which a step need not be
    const Vector3d factors = eigen.eigenvalues().cwiseMax(SHRINK).cwiseMin(GROW).array().exp();
    const Matrix3d root = L * eigen.eigenvectors();
    return regular(symmetrised(root * factors.asDiagonal() * root.transpose()), TINY_FLOOR);
}

Matrix3d scored(const Matrix3d& C, const Matrix3d& Z, const Matrix3d& G, const Matrix6d& QQ, double information)
{
    const Prior pull = prior(C, SHRINKAGE);
    const Matrix6d F = information * curvature(QQ) + pull.curvature;
    const Vector6d score = 0.5 * againstUnits(Z - G) + pull.score;
    const CholeskyFactor<6> cholesky(F);
    const Vector6d step = cholesky.positiveDefinite() ? cholesky.solve(score) : Vector6d(F.ldlt().solve(score));
    return moved(C, symmetric(step.data()));
}

}  // namespace

Noise scoredNoise(NoiseKind kind, const Noise& noise, const RaySums& sums, const Matrix3d& R)
{
    Noise next = noise;
    const double information = tailInformation(noise.tails).noise;
    if (kind == NoiseKind::BEARING)
        next.Gamma = scored(noise.Gamma, sums.Zb, sums.Gb, sums.QQ, information);
    else
        next.Sigma = symmetrised(R.transpose() *
                                 scored(R * noise.Sigma * R.transpose(), sums.Zo, sums.Go, sums.QQ, information) * R);
    return next;
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
