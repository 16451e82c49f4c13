// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "../math/cholesky.hpp"
#include "initial_pose.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

namespace {

using Matrix9d = Eigen::Matrix<double, 9, 9>;
using Vector9d = Eigen::Matrix<double, 9, 1>;
using Matrix93d = Eigen::Matrix<double, 9, 3>;
using Matrix39d = Eigen::Matrix<double, 3, 9>;
// Products of this size are written lazyProduct(), because Eigen's blocked kernels are made for larger ones.

// The cost as a quadratic form of r = vec(R) (columns stacked). The translation is eliminated. It is the form of SQPnP
// (Terzakis and Lourakis, ECCV 2020), which holds for unit rays of any direction with Q_i = I - m_i m_i^T.
struct RotationCost
{
    Matrix9d Omega;  // cost = r^T Omega r
    Matrix39d P;     // optimal t = P r

    double operator()(const Matrix3d& R) const
    {
        const Eigen::Map<const Vector9d> r(R.data());
        return r.dot(Omega.lazyProduct(r));
    }
    Pose pose(const Matrix3d& R) const { return {R, P * Eigen::Map<const Vector9d>(R.data())}; }
};

RotationCost rotationCost(const Correspondences& data)
{
    MomentSums moments;
    rayKernels(data.size()).moments(data.arrays(), moments);
    Matrix39d B;
    B << symmetric(moments.pQ[0]), symmetric(moments.pQ[1]), symmetric(moments.pQ[2]);
    RotationCost cost;
    cost.P = -symmetric(moments.Q).ldlt().solve(B);
    constexpr int PRODUCT[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
    for (Eigen::Index a = 0; a < 3; ++a)
        for (Eigen::Index b = 0; b < 3; ++b)
            cost.Omega.block<3, 3>(3 * a, 3 * b) = symmetric(moments.ppQ[PRODUCT[a][b]]);
    cost.Omega += B.transpose().lazyProduct(cost.P);
    cost.Omega = symmetrised(cost.Omega);
    return cost;
}

constexpr int NEWTON_ROUNDS = 30;
constexpr int NEWTON_HALVINGS = 8;
constexpr double NEWTON_STEP = 1e-10;  // rad; convergence is quadratic, so one more step would be below rounding

// Omega times r = vec(R), and the cost r^T Omega r.
struct CostAt
{
    CostAt(const RotationCost& cost, const Matrix3d& R)
    {
        const Eigen::Map<const Vector9d> r(R.data());
        Eigen::Map<Vector9d> g(G.data());
        g = cost.Omega.lazyProduct(r);
        f = r.dot(g);
    }

    Matrix3d G;
    double f;
};

// Omega J, J = dr/dphi: the rows of the three 9 x 3 blocks of Omega crossed with the columns of R.
Matrix93d timesJacobian(const Matrix9d& Omega, const Matrix3d& R)
{
    Matrix93d out = Matrix93d::Zero();
    for (Eigen::Index b = 0; b < 3; ++b) {
        const auto x = Omega.col(3 * b), y = Omega.col(3 * b + 1), z = Omega.col(3 * b + 2);
        const Vector3d r = R.col(b);
        out.col(0) += r.y() * z - r.z() * y;
        out.col(1) += r.z() * x - r.x() * z;
        out.col(2) += r.x() * y - r.y() * x;
    }
    return out;
}

// The Newton direction on SO(3) for R <- Exp(phi) R. Where the Hessian is indefinite, its Gauss-Newton part is taken.
Vector3d newtonDirection(const RotationCost& cost, const Matrix3d& R, const Matrix3d& G)
{
    const Vector3d gradient = R.col(0).cross(G.col(0)) + R.col(1).cross(G.col(1)) + R.col(2).cross(G.col(2));  // J^T Or
    const Matrix93d OmegaJ = timesJacobian(cost.Omega, R);
    Matrix3d gaussNewton = Matrix3d::Zero();  // J^T Omega J
    for (Eigen::Index b = 0; b < 3; ++b)
        gaussNewton += hat(R.col(b)) * OmegaJ.middleRows<3>(3 * b);
    const Matrix3d RG = R * G.transpose();
    const Matrix3d hessian = symmetrised(gaussNewton + RG) - RG.trace() * Matrix3d::Identity();
    CholeskyFactor<3> cholesky(hessian);
    if (!cholesky.positiveDefinite())
        cholesky = CholeskyFactor<3>(gaussNewton + 1e-6 * gaussNewton.trace() * Matrix3d::Identity());
    return cholesky.positiveDefinite() ? cholesky.solve(-gradient) : Vector3d::Zero();
}

PoseCandidate descend(const RotationCost& cost, Matrix3d R)
{
    // A rise within the rounding of the cost is none: where the cost is flat, the gradient still tells a step.
    const double rounding = 16 * std::numeric_limits<double>::epsilon() * cost.Omega.trace();
    CostAt at(cost, R);
    for (int round = 0; round < NEWTON_ROUNDS; ++round) {
        Vector3d phi = newtonDirection(cost, R, at.G);
        const double angle = phi.norm();
        if (!(angle < CV_PI))  // also NaN
            phi = angle > 0 && std::isfinite(angle) ? Vector3d(phi / angle) : Vector3d::Zero();
        Matrix3d next = expSO3(phi) * R;
        CostAt atNext(cost, next);
        for (int k = 0; k < NEWTON_HALVINGS && atNext.f > at.f + rounding; ++k) {
            phi *= 0.5;
            next = expSO3(phi) * R;
            atNext = CostAt(cost, next);
        }
        if (!(atNext.f <= at.f + rounding))
            break;
        R = next;
        at = atNext;
        if (phi.norm() < NEWTON_STEP)
            break;
    }
    R = 0.5 * R * (3 * Matrix3d::Identity() - R.transpose() * R);  // what rounding took from orthogonality
    return {cost.pose(R), cost(R)};
}

bool inFront(const Correspondences& data, const Pose& pose)
{
    return 2 * rayKernels(data.size()).behind(data.arrays(), entriesOf(pose).data()) < data.size();
}

// Two rotations are one minimum when they are closer than this [rad]: descents to it end within rounding.
constexpr double SAME_MINIMUM = 1e-4;

bool same(const Pose& a, const Pose& b)
{
    return (a.R - b.R).squaredNorm() < 2 * SAME_MINIMUM * SAME_MINIMUM;
}

void keep(const PoseCandidate& found, const Correspondences& data, std::vector<PoseCandidate>& minima)
{
    for (PoseCandidate& known : minima)
        if (same(known.pose, found.pose)) {
            if (found.cost < known.cost)  // the other descent ran out of rounds
                known = found;
            return;
        }
    if (inFront(data, found.pose))
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

// The pose that a flat object can be mistaken for. Its normal is mirrored at the line of sight to its centre.
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

constexpr int CUBE_STARTS = 4;  // descents start from the best of the 24

void searchMinima(const Correspondences& data, const RotationCost& cost, std::vector<PoseCandidate>& minima)
{
    const Eigen::SelfAdjointEigenSolver<Matrix9d> eigen(cost.Omega);
    for (int k = 0; k < 4; ++k)  // four points leave a null space of four dimensions, a plane one of three
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

namespace {

// The smallest eigenvalue of Omega and its unit eigenvector by inverse iteration; none where rounding has ruined Omega.
struct LeastEigen
{
    Vector9d vector;
    double value;
};

std::optional<LeastEigen> leastEigen(const Matrix9d& Omega)
{
    constexpr double REGULAR = 1e-13;  // of the trace: exact data leave an eigenvalue of zero
    constexpr int ITERATIONS = 3;
    const CholeskyFactor<9> cholesky(Omega + REGULAR * Omega.trace() * Matrix9d::Identity());
    if (!cholesky.positiveDefinite())
        return std::nullopt;
    LeastEigen least{Vector9d::LinSpaced(0.5, 1.5), 0};  // any vector will do
    for (int k = 0; k < ITERATIONS; ++k)
        least.vector = cholesky.solve(least.vector).normalized();
    least.value = least.vector.dot(Omega.lazyProduct(least.vector));
    return least;
}

// The rotation nearest to an eigenvector of either sign; none where it is too unlike a rotation.
std::optional<Matrix3d> rotationFrom(const Vector9d& e)
{
    constexpr double LIKE_A_ROTATION = 0.2;  // determinant; 1 for a rotation
    constexpr int POLAR_ITERATIONS = 6;
    Matrix3d M = std::sqrt(3.) * Eigen::Map<const Matrix3d>(e.data());
    if (M.determinant() < 0)
        M = -M;
    if (!(M.determinant() > LIKE_A_ROTATION))
        return std::nullopt;
    for (int k = 0; k < POLAR_ITERATIONS; ++k)
        M = 0.5 * (M + M.inverse().transpose());
    return M;
}

// Whether all rotations that cost no more than `most` lie within a small angle of each other, so that no other minimum
// needs to be looked for. Where  Omega + (tau - lambda) e e^T - tau I  has a Cholesky factor, any r with r^T r = 3 and
// r^T Omega r <= most  has  3 - (r^T e)^2 <= (most - 3 lambda) / (tau - lambda): a cap around +-sqrt(3) e, of which one
// sign only holds rotations.
bool oneCapHoldsAll(const Matrix9d& Omega, const LeastEigen& least, double most)
{
    constexpr double CAP = 0.174;   // 3 sin^2(psi / 2) with 3 cos psi = 1 + 2 cos(0.6 rad)
    constexpr double BELOW = 0.98;  // inverse iteration ends a little above the smallest eigenvalue
    const double lambda = BELOW * least.value, tau = lambda + (most - 3 * lambda) / CAP;
    const Matrix9d bounded =
        Omega + (tau - lambda) * least.vector * least.vector.transpose() - tau * Matrix9d::Identity();
    return CholeskyFactor<9>(bounded).positiveDefinite();
}

// The minimum where it is the only one of its cost: most scenes that are not flat.
std::optional<PoseCandidate> certifiedMinimum(const Correspondences& data, const RotationCost& cost, double costRatio)
{
    const std::optional<LeastEigen> least = leastEigen(cost.Omega);
    const std::optional<Matrix3d> start = least ? rotationFrom(least->vector) : std::nullopt;
    if (!start)
        return std::nullopt;
    const PoseCandidate found = descend(cost, *start);
    // Eigenvalues below the rounding of Omega cannot be told from zero.
    const double rounding = 1e-12 * cost.Omega.trace();
    if (!oneCapHoldsAll(cost.Omega, *least, costRatio * found.cost + rounding) || !inFront(data, found.pose))
        return std::nullopt;
    return found;
}

}  // namespace

std::vector<PoseCandidate> initialPoses(const Correspondences& data, double costRatio, double certified)
{
    const RotationCost cost = rotationCost(data);
    if (std::isfinite(costRatio) && std::isfinite(certified))
        if (const std::optional<PoseCandidate> only = certifiedMinimum(data, cost, certified))
            return {*only};
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
