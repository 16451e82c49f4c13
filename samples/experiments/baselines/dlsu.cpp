// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "polynomial_system.hpp"
#include "reprojection.hpp"

// J. A. Hesch, S. I. Roumeliotis: A Direct Least-Squares (DLS) Method for PnP, ICCV 2011, and its weighted form DLSU of
// A. Vakhitov, L. Ferraz, A. Agudo, F. Moreno-Noguer: Uncertainty-Aware Camera Pose Estimation from Points and Lines,
// CVPR 2021. The algebraic errors  (X, Y) - Z (x, y)  are linear in rotation and translation. Without the translation
// the cost is a quadratic form in the nine entries of R; with the Cayley parameters s of R, times (1 + s^T s)^2, a
// polynomial of degree four. Its stationary points are the roots of three cubics, by a Macaulay resultant. DLSU weighs
// with depth and rotation of a hypothesis, here of DLS, and refines by bundle adjustment with both noises.

namespace baselines {

namespace {

using Vector9d = Eigen::Matrix<double, 9, 1>;
using Matrix9d = Eigen::Matrix<double, 9, 9>;

// cost = r^T M r with r the columns of R, one below the other; t = T r.
struct QuadraticForm
{
    Matrix9d M;
    Eigen::Matrix<double, 3, 9> T;
};

QuadraticForm quadraticForm(const Data& data, const std::vector<Matrix2d>& weights)
{
    Matrix9d rr = Matrix9d::Zero();
    Eigen::Matrix<double, 3, 9> tr = Eigen::Matrix<double, 3, 9>::Zero();
    Matrix3d tt = Matrix3d::Zero();
    for (int i = 0; i < data.size(); ++i) {
        Eigen::Matrix<double, 2, 3> B;
        B << 1, 0, -data.image(0, i), 0, 1, -data.image(1, i);
        const Matrix3d W = weights.empty() ? Matrix3d(B.transpose() * B) : Matrix3d(B.transpose() * weights[i] * B);
        Eigen::Matrix<double, 3, 9> P;
        P << data.points(0, i) * Matrix3d::Identity(), data.points(1, i) * Matrix3d::Identity(),
            data.points(2, i) * Matrix3d::Identity();
        rr += P.transpose() * W * P;
        tr += W * P;
        tt += W;
    }
    QuadraticForm form;
    form.T = -tt.ldlt().solve(tr);
    form.M = rr + tr.transpose() * form.T;
    form.M = cv::gmlpnp::detail::symmetrised(form.M);
    return form;
}

Vector9d columns(const Matrix3d& R)
{
    return Eigen::Map<const Vector9d>(R.data());
}

// The entries of (1 + s^T s) R(s) as polynomials of s.
std::array<Polynomial, 9> cayley()
{
    std::array<Polynomial, 9> entries;
    const auto entry = [&](int row, int column) -> Polynomial& { return entries[row + 3 * column]; };
    for (int a = 0; a < 3; ++a) {
        const int b = (a + 1) % 3, c = (a + 2) % 3;
        entry(a, a) = Polynomial::constant(1) + Polynomial::square(a) - Polynomial::square(b) - Polynomial::square(c);
        entry(b, a) = 2 * (Polynomial::variable(a) * Polynomial::variable(b) + Polynomial::variable(c));
        entry(a, b) = 2 * (Polynomial::variable(a) * Polynomial::variable(b) - Polynomial::variable(c));
    }
    return entries;
}

std::array<Polynomial, 3> gradient(const Matrix9d& M)
{
    static const std::array<Polynomial, 9> entries = cayley();
    Polynomial cost;
    for (int a = 0; a < 9; ++a)
        for (int b = 0; b < 9; ++b)
            cost = cost + M(a, b) * (entries[a] * entries[b]);
    return {cost.derivative(0), cost.derivative(1), cost.derivative(2)};
}

Matrix3d rotation(const Vector3d& s)
{
    return Eigen::Quaterniond(1, s.x(), s.y(), s.z()).normalized().toRotationMatrix();
}

// Gauss-Newton on r^T M r over rotations: the resultant loses digits, and the factor (1 + s^T s)^2 moves the minimum.
Matrix3d polished(const Matrix9d& M, Matrix3d R)
{
    constexpr int STEPS = 10;
    for (int step = 0; step < STEPS; ++step) {
        Eigen::Matrix<double, 9, 3> J;
        for (Eigen::Index k = 0; k < 3; ++k)
            J.middleRows<3>(3 * k) = -cv::gmlpnp::detail::hat(R.col(k));
        R = cv::gmlpnp::detail::expSO3(-(J.transpose() * M * J).ldlt().solve(J.transpose() * (M * columns(R)))) * R;
    }
    return R;
}

// `turns`: rotations of the object at which the Cayley parameters are zero.
std::optional<Pose> bestPose(const Data& data, const std::vector<Matrix2d>& weights, const std::vector<Matrix3d>& turns)
{
    const QuadraticForm form = quadraticForm(data, weights);
    std::optional<Pose> best;
    double least = std::numeric_limits<double>::infinity();
    for (const Matrix3d& turn : turns) {
        Matrix9d K = Matrix9d::Zero();  // columns(R turn) = K columns(R)
        for (Eigen::Index a = 0; a < 3; ++a)
            for (Eigen::Index b = 0; b < 3; ++b)
                K.block<3, 3>(3 * a, 3 * b) = turn(b, a) * Matrix3d::Identity();
        const Matrix9d M = K.transpose() * form.M * K / form.M.trace();
        for (const Vector3d& s : realRoots(gradient(M))) {
            const Matrix3d R = polished(form.M, rotation(s) * turn);
            const Pose pose{R, form.T * columns(R)};
            const double cost = columns(R).dot(form.M * columns(R));
            if (cost < least && plausible(data, pose)) {
                least = cost;
                best = pose;
            }
        }
    }
    return best;
}

}  // namespace

std::optional<Pose> dls(const Data& data)
{
    // Cayley parameters cannot express half a turn: every rotation is within 120 degrees of one of these.
    std::vector<Matrix3d> turns(4, Matrix3d::Identity());
    for (int k = 0; k < 3; ++k) {
        turns[k] *= -1;
        turns[k](k, k) = 1;
    }
    return bestPose(data, {}, turns);
}

std::optional<Pose> dlsu(const Data& data, const Uncertainty& uncertainty)
{
    constexpr int REFINEMENTS = 20;
    const std::optional<Pose> hypothesis = dls(data);
    if (!hypothesis)
        return std::nullopt;
    const std::optional<Pose> pose = bestPose(data, algebraicWeights(data, *hypothesis, uncertainty), {hypothesis->R});
    if (!pose)
        return std::nullopt;
    return refined(data, *pose, REFINEMENTS, &uncertainty);
}

}  // namespace baselines
