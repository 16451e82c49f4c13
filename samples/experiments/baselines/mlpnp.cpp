// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "principal_axes.hpp"
#include "reprojection.hpp"

// S. Urban, J. Leitloff, S. Hinz: MLPnP - A Real-Time Maximum Likelihood Solution to the Perspective-n-Point Problem,
// ISPRS Annals III-3, 2016. The ray v_i is orthogonal to its null space [r s]: two equations  [r s]^T (R p + t) = 0  a
// point, weighted with the covariance of the ray in that plane. Linear in 12 unknowns, or in 9 where the points are
// coplanar; then Gauss-Newton on [r s]^T X/|X|.

namespace baselines {

namespace {

using Basis = Eigen::Matrix<double, 3, 2>;
using Design = Eigen::Matrix<double, 2, 12>;

struct Tangents
{
    std::vector<Basis> bases;
    std::vector<Matrix2d> weights;
};

Tangents tangentsOf(const Data& data, const std::vector<Matrix3d>& covariances)
{
    Tangents tangents;
    for (int i = 0; i < data.size(); ++i) {
        const Vector3d v = data.rays.col(i), r = v.unitOrthogonal();
        Basis basis;
        basis << r, v.cross(r);
        tangents.bases.push_back(basis);
        tangents.weights.push_back(
            covariances.empty() ? Matrix2d(Matrix2d::Identity())
                                : Matrix2d((basis.transpose() * covariances[i] * basis).inverse()));  // Eq. (11), (14)
    }
    return tangents;
}

// Object frame of the linear solution: origin in the centroid, principal axes, a length of one.
struct Frame
{
    explicit Frame(const Matrix3Xd& points) : principal(points), scale(principal.deviations.norm()) {}

    PrincipalAxes principal;
    double scale;
};

Pose toObject(const Frame& frame, const Matrix3d& R, const Vector3d& t)
{
    const Matrix3d Ro = R * frame.principal.axes.transpose();
    return {Ro, frame.scale * t - Ro * frame.principal.centroid};
}

// The rows are the unknowns' coefficients: the columns of R, each with [r s]^T in front, then t (Eq. (10)).
Eigen::MatrixXd normalMatrix(const Data& data, const Tangents& tangents, const Frame& frame, int columns)
{
    Eigen::MatrixXd N = Eigen::MatrixXd::Zero(3 * columns + 3, 3 * columns + 3);
    Eigen::Matrix<double, 2, Eigen::Dynamic> A(2, 3 * columns + 3);
    for (int i = 0; i < data.size(); ++i) {
        const Vector3d q =
            frame.principal.axes.transpose() * (data.points.col(i) - frame.principal.centroid) / frame.scale;
        const Eigen::Matrix<double, 2, 3> B = tangents.bases[i].transpose();
        for (Eigen::Index k = 0; k < columns; ++k)
            A.middleCols<3>(3 * k) = q(k) * B;
        A.rightCols<3>() = B;
        N += A.transpose() * tangents.weights[i] * A;
    }
    return N;
}

Eigen::VectorXd smallestEigenvector(const Eigen::MatrixXd& N)
{
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(N).eigenvectors().col(0);
}

void linearGeneral(const Data& data, const Tangents& tangents, const Frame& frame, std::vector<Pose>& poses)
{
    const Eigen::VectorXd x = smallestEigenvector(normalMatrix(data, tangents, frame, 3));
    for (const double sign : {1., -1.}) {
        const Matrix3d M = sign * Eigen::Map<const Matrix3d>(x.data());
        const double scale = std::cbrt(M.col(0).norm() * M.col(1).norm() * M.col(2).norm());  // Eq. (17)
        poses.push_back(toObject(frame, cv::gmlpnp::detail::nearestRotation(M), sign * x.tail<3>() / scale));
    }
}

void linearPlanar(const Data& data, const Tangents& tangents, const Frame& frame, std::vector<Pose>& poses)
{
    const Eigen::VectorXd x = smallestEigenvector(normalMatrix(data, tangents, frame, 2));
    for (const double sign : {1., -1.}) {
        const Vector3d a = sign * x.head<3>(), b = sign * x.segment<3>(3);
        Matrix3d M;
        M << a, b, a.cross(b) / std::sqrt(a.norm() * b.norm());
        poses.push_back(toObject(frame, cv::gmlpnp::detail::nearestRotation(M),
                                 sign * x.tail<3>() / std::sqrt(a.norm() * b.norm())));
    }
}

struct Normal
{
    Matrix6d H = Matrix6d::Zero();
    Vector6d g = Vector6d::Zero();
    double cost = 0;
};

Normal normalEquations(const Data& data, const Tangents& tangents, const Pose& pose)
{
    Normal normal;
    for (int i = 0; i < data.size(); ++i) {
        const Vector3d X = pose * data.points.col(i), x = X.normalized();
        const Eigen::Matrix<double, 2, 3> B = tangents.bases[i].transpose();
        const Vector2d r = B * x;
        const Eigen::Matrix<double, 2, 3> D = B * (Matrix3d::Identity() - x * x.transpose()) / X.norm();
        Eigen::Matrix<double, 2, 6> J;
        J << -D * cv::gmlpnp::detail::hat(X), D;
        normal.H += J.transpose() * tangents.weights[i] * J;
        normal.g += J.transpose() * tangents.weights[i] * r;
        // A point behind the camera has the same residual as its mirror image: it must cost more.
        normal.cost += data.rays.col(i).dot(X) > 0 ? r.dot(tangents.weights[i] * r) : 2 * tangents.weights[i].trace();
    }
    return normal;
}

Pose gaussNewton(const Data& data, const Tangents& tangents, Pose pose)
{
    constexpr int STEPS = 30, HALVINGS = 8;
    constexpr double NEGLIGIBLE = 1e-11;
    Normal now = normalEquations(data, tangents, pose);
    for (int step = 0; step < STEPS; ++step) {
        Vector6d xi = -now.H.ldlt().solve(now.g);
        Pose next = perturbed(pose, xi);
        Normal after = normalEquations(data, tangents, next);
        for (int k = 0; k < HALVINGS && !(after.cost <= now.cost); ++k) {
            xi *= 0.5;
            next = perturbed(pose, xi);
            after = normalEquations(data, tangents, next);
        }
        if (!(after.cost <= now.cost))
            break;
        pose = next;
        now = after;
        if (xi.head<3>().norm() < NEGLIGIBLE && xi.tail<3>().norm() < NEGLIGIBLE * pose.t.norm())
            break;
    }
    return pose;
}

}  // namespace

std::optional<Pose> mlpnp(const Data& data, const std::vector<Matrix3d>& rayCovariances)
{
    // Between these the data decide: noise thickens a plane, and nearly flat points leave 12 unknowns undetermined.
    constexpr double SURELY_SOLID = 0.2;
    const Tangents tangents = tangentsOf(data, rayCovariances);
    const Frame frame(data.points);
    const double flatness = frame.principal.flatness();
    std::vector<Pose> poses;
    if (flatness > SURELY_FLAT && data.size() >= 6)
        linearGeneral(data, tangents, frame, poses);
    if (flatness < SURELY_SOLID)
        linearPlanar(data, tangents, frame, poses);
    std::optional<Pose> best;
    double least = std::numeric_limits<double>::infinity();
    for (const Pose& start : poses) {
        if (!plausible(data, start))
            continue;
        const Pose pose = gaussNewton(data, tangents, start);
        const double cost = normalEquations(data, tangents, pose).cost;
        if (cost < least && plausible(data, pose)) {
            least = cost;
            best = pose;
        }
    }
    return best;
}

}  // namespace baselines
