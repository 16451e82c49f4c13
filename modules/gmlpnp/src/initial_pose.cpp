// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "precomp.hpp"

#include "initial_pose.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

namespace {

using Matrix9d = Eigen::Matrix<double, 9, 9>;
using Vector9d = Eigen::Matrix<double, 9, 1>;
using Matrix93d = Eigen::Matrix<double, 9, 3>;
using Matrix39d = Eigen::Matrix<double, 3, 9>;

// The cost as a quadratic form of r = vec(R) (columns stacked) with the translation eliminated; it is the form of
// SQPnP (Terzakis and Lourakis, ECCV 2020), which holds for unit rays of any direction with Q_i = I - m_i m_i^T.
struct RotationCost
{
    Matrix9d Omega;  // cost = r^T Omega r
    Matrix39d P;     // optimal t = P r

    double operator()(const Matrix3d& R) const
    {
        const Eigen::Map<const Vector9d> r(R.data());
        return r.dot(Omega * r);
    }
    Pose pose(const Matrix3d& R) const { return {R, P * Eigen::Map<const Vector9d>(R.data())}; }
};

RotationCost rotationCost(const Correspondences& data)
{
    // Moments of Q with 1, p_a and p_a p_b; products are symmetric, so a <= b is enough.
    Matrix3d Q0 = Matrix3d::Zero(), Q1[3], Q2[3][3];
    for (int a = 0; a < 3; ++a) {
        Q1[a].setZero();
        for (int b = a; b < 3; ++b)
            Q2[a][b].setZero();
    }
    for (int i = 0; i < data.size(); ++i) {
        const Vector3d p = data.pointAt(i), m = data.rayAt(i);
        const Matrix3d Q = Matrix3d::Identity() - m * m.transpose();
        Q0 += Q;
        for (int a = 0; a < 3; ++a) {
            const Matrix3d pQ = p(a) * Q;
            Q1[a] += pQ;
            for (int b = a; b < 3; ++b)
                Q2[a][b] += p(b) * pQ;
        }
    }
    RotationCost cost;
    Matrix39d B;
    B << Q1[0], Q1[1], Q1[2];
    cost.P = -Q0.ldlt().solve(B);
    for (int a = 0; a < 3; ++a)
        for (int b = a; b < 3; ++b) {
            cost.Omega.block<3, 3>(3 * a, 3 * b) = Q2[a][b];
            cost.Omega.block<3, 3>(3 * b, 3 * a) = Q2[a][b];
        }
    cost.Omega += B.transpose() * cost.P;
    cost.Omega = symmetrised(cost.Omega);
    return cost;
}

constexpr int NEWTON_ROUNDS = 30;
constexpr int NEWTON_HALVINGS = 8;
constexpr double NEWTON_STEP = 1e-10;  // rad: convergence is quadratic, one more step would be below rounding

// Newton direction on SO(3) for R <- Exp(phi) R; where the Hessian is indefinite, its positive Gauss-Newton part.
Vector3d newtonDirection(const RotationCost& cost, const Matrix3d& R)
{
    const Eigen::Map<const Vector9d> r(R.data());
    const Vector9d Or = cost.Omega * r;
    const Eigen::Map<const Matrix3d> G(Or.data());
    Matrix93d J;
    J << -hat(R.col(0)), -hat(R.col(1)), -hat(R.col(2));
    const Vector3d gradient = J.transpose() * Or;
    const Matrix3d gaussNewton = J.transpose() * cost.Omega * J;
    const Matrix3d RG = R * G.transpose();
    const Matrix3d hessian = gaussNewton + symmetrised(RG) - RG.trace() * Matrix3d::Identity();
    const double ridge = 1e-6 * gaussNewton.trace();
    Eigen::LLT<Matrix3d> llt(hessian);
    if (llt.info() != Eigen::Success)
        llt.compute(gaussNewton + ridge * Matrix3d::Identity());
    return -llt.solve(gradient);
}

PoseCandidate descend(const RotationCost& cost, Matrix3d R)
{
    double f = cost(R);
    for (int round = 0; round < NEWTON_ROUNDS; ++round) {
        Vector3d phi = newtonDirection(cost, R);
        const double angle = phi.norm();
        if (!(angle < CV_PI))  // also NaN
            phi = angle > 0 && std::isfinite(angle) ? Vector3d(phi / angle) : Vector3d::Zero();
        Matrix3d next = expSO3(phi) * R;
        double fNext = cost(next);
        for (int k = 0; k < NEWTON_HALVINGS && fNext > f; ++k) {
            phi *= 0.5;
            next = expSO3(phi) * R;
            fNext = cost(next);
        }
        if (!(fNext <= f))
            break;
        R = next;
        f = fNext;
        if (phi.norm() < NEWTON_STEP)
            break;
    }
    R = nearestRotation(R);
    return {cost.pose(R), cost(R)};
}

int pointsInFront(const Correspondences& data, const Pose& pose)
{
    int inFront = 0;
    for (int i = 0; i < data.size(); ++i)
        inFront += data.rayAt(i).dot(pose * data.pointAt(i)) > 0;
    return inFront;
}

// Two rotations are one minimum when closer than this [rad].
constexpr double SAME_MINIMUM = 1e-4;

bool same(const Pose& a, const Pose& b)
{
    return (a.R - b.R).squaredNorm() < 2 * SAME_MINIMUM * SAME_MINIMUM;
}

void keep(const PoseCandidate& found, const Correspondences& data, std::vector<PoseCandidate>& minima)
{
    for (const PoseCandidate& known : minima)
        if (same(known.pose, found.pose))
            return;
    if (2 * pointsInFront(data, found.pose) > data.size())
        minima.push_back(found);
}

// The 24 rotations of the cube: a start within 63 degrees of any rotation.
std::array<Matrix3d, 24> cubeRotations()
{
    std::array<Matrix3d, 24> rotations;
    int k = 0;
    for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b)
            for (int signs = 0; signs < 4 && a != b; ++signs) {
                Matrix3d& R = rotations[k++];
                R.col(0) = (signs & 1 ? -1 : 1) * Vector3d::Unit(a);
                R.col(1) = (signs & 2 ? -1 : 1) * Vector3d::Unit(b);
                R.col(2) = R.col(0).cross(R.col(1));
            }
    return rotations;
}

// The pose that a flat object is taken for: its normal mirrored at the line of sight to its centre.
Matrix3d mirrored(const Pose& pose, const Vector3d& normal)
{
    const Vector3d sight = pose.t.normalized(), n = pose.R * normal;
    const Vector3d axis = n.cross(sight);
    const double sine = axis.norm(), angle = 2 * std::atan2(sine, n.dot(sight));
    return sine > 0 ? Matrix3d(expSO3(axis * (angle / sine)) * pose.R) : pose.R;
}

Vector3d flattestDirection(const Correspondences& data)
{
    Matrix3d M = Matrix3d::Zero();
    for (int i = 0; i < data.size(); ++i)
        M += data.pointAt(i) * data.pointAt(i).transpose();
    return Eigen3d(M).eigenvectors().col(0);
}

constexpr int CUBE_STARTS = 4;  // best of the 24 that are descended from

void searchMinima(const Correspondences& data, const RotationCost& cost, std::vector<PoseCandidate>& minima)
{
    const Eigen::SelfAdjointEigenSolver<Matrix9d> eigen(cost.Omega);
    for (int k = 0; k < 4; ++k)  // four points leave a null space of dimension four, a plane one of three
        for (double sign : {1.0, -1.0}) {
            const Vector9d e = sign * eigen.eigenvectors().col(k);
            keep(descend(cost, nearestRotation(Eigen::Map<const Matrix3d>(e.data()))), data, minima);
        }
    std::array<Matrix3d, 24> starts = cubeRotations();
    std::sort(starts.begin(), starts.end(), [&](const Matrix3d& a, const Matrix3d& b) { return cost(a) < cost(b); });
    for (int k = 0; k < CUBE_STARTS; ++k)
        keep(descend(cost, starts[k]), data, minima);
    const Vector3d normal = flattestDirection(data);
    for (size_t k = 0, known = minima.size(); k < known; ++k)
        keep(descend(cost, mirrored(minima[k].pose, normal)), data, minima);
}

}  // namespace

std::vector<PoseCandidate> initialPoses(const Correspondences& data, double costRatio)
{
    const RotationCost cost = rotationCost(data);
    std::vector<PoseCandidate> minima;
    searchMinima(data, cost, minima);
    std::sort(minima.begin(), minima.end(),
              [](const PoseCandidate& a, const PoseCandidate& b) { return a.cost < b.cost; });
    if (minima.empty())
        return minima;
    // On exact data the best cost is rounding; a minimum is as good when it is rounding too.
    const double rounding = 1e-13 * cost.Omega.trace();
    const double most = costRatio * std::max(minima.front().cost, rounding);
    minima.erase(std::remove_if(minima.begin(), minima.end(), [=](const PoseCandidate& c) { return c.cost > most; }),
                 minima.end());
    return minima;
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
