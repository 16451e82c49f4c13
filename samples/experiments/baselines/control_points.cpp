// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "control_points.hpp"

#include "principal_axes.hpp"

namespace baselines {

ControlPoints::ControlPoints(const Matrix3Xd& points)
{
    const PrincipalAxes principal(points);
    const int axes = principal.flatness() < SURELY_FLAT ? 2 : 3;
    object.resize(3, axes + 1);
    object.col(0) = principal.centroid;
    alphas.resize(axes + 1, points.cols());
    alphas.row(0).setOnes();
    for (int k = 0; k < axes; ++k) {
        object.col(k + 1) = principal.centroid + principal.deviations(k) * principal.axes.col(k);
        alphas.row(k + 1) =
            principal.axes.col(k).transpose() * (points.colwise() - principal.centroid) / principal.deviations(k);
        alphas.row(0) -= alphas.row(k + 1);
    }
}

Rows rowsOf(const ControlPoints& control, const Data& data, int i)
{
    Rows rows(2, 3 * control.count());
    for (Eigen::Index j = 0; j < control.count(); ++j)
        rows.middleCols<3>(3 * j) << control.alphas(j, i), 0, -control.alphas(j, i) * data.image(0, i),  //
            0, control.alphas(j, i), -control.alphas(j, i) * data.image(1, i);
    return rows;
}

Eigen::MatrixXd kernel(const ControlPoints& control, const Data& data, const std::vector<Matrix2d>& weights)
{
    const Eigen::Index unknowns = 3 * control.object.cols();
    Eigen::MatrixXd N = Eigen::MatrixXd::Zero(unknowns, unknowns);
    for (int i = 0; i < data.size(); ++i) {
        const Rows rows = rowsOf(control, data, i);
        if (weights.empty())
            N.noalias() += rows.transpose() * rows;
        else
            N.noalias() += rows.transpose() * weights[i] * rows;
    }
    return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(N).eigenvectors().leftCols(control.count());
}

namespace {

Eigen::Map<const Matrix3Xd> asPoints(const Eigen::VectorXd& x)
{
    return {x.data(), 3, x.size() / 3};
}

// The rigid motion that takes `from` to `to` with the least squares error.
Pose alignment(const Matrix3Xd& from, const Matrix3Xd& to)
{
    const Vector3d meanFrom = from.rowwise().mean(), meanTo = to.rowwise().mean();
    Pose pose;
    pose.R = cv::gmlpnp::detail::nearestRotation((to.colwise() - meanTo) * (from.colwise() - meanFrom).transpose());
    pose.t = meanTo - pose.R * meanFrom;
    return pose;
}

// Mean depth of the points of a control vector, by which its sign is known.
double meanDepth(const ControlPoints& control, const Eigen::VectorXd& x)
{
    return (asPoints(x).row(2) * control.alphas).mean();
}

// Squared distances between control points as quadratic forms of the betas: one matrix (K^T D^T D K) for each pair.
struct Distances
{
    std::vector<Eigen::MatrixXd> forms;
    std::vector<double> squared;
};

Distances distances(const ControlPoints& control, const Eigen::MatrixXd& kernel)
{
    Distances pairs;
    for (Eigen::Index a = 0; a < control.count(); ++a)
        for (Eigen::Index b = a + 1; b < control.count(); ++b) {
            const Eigen::MatrixXd D = kernel.middleRows<3>(3 * a) - kernel.middleRows<3>(3 * b);
            pairs.forms.emplace_back(D.transpose() * D);
            pairs.squared.push_back((control.object.col(a) - control.object.col(b)).squaredNorm());
        }
    return pairs;
}

// Betas of the first `count` kernel vectors by linearisation: the products beta_k beta_l are the unknowns.
Eigen::VectorXd linearised(const Distances& pairs, int count, int all)
{
    const int unknowns = count * (count + 1) / 2, equations = static_cast<int>(pairs.squared.size());
    Eigen::MatrixXd L(equations, unknowns);
    for (int e = 0; e < equations; ++e)
        for (int k = 0, column = 0; k < count; ++k)
            for (int l = k; l < count; ++l, ++column)
                L(e, column) = (k == l ? 1 : 2) * pairs.forms[e](k, l);
    const Eigen::VectorXd products =
        L.colPivHouseholderQr().solve(Eigen::Map<const Eigen::VectorXd>(pairs.squared.data(), equations));
    Eigen::VectorXd betas = Eigen::VectorXd::Zero(all);
    betas(0) = std::sqrt(std::abs(products(0)));  // the first row of products is beta_0 (beta_0, beta_1, ...)
    for (int k = 1; k < count; ++k)
        betas(k) = products(k) / (products(0) < 0 ? -betas(0) : betas(0));
    return betas;
}

// Gauss-Newton on the differences of the squared distances (Eq. (15)); more betas than equations: shortest step.
void improve(const Distances& pairs, Eigen::VectorXd& betas)
{
    constexpr int STEPS = 10;
    const int equations = static_cast<int>(pairs.squared.size());
    for (int step = 0; step < STEPS; ++step) {
        Eigen::MatrixXd J(equations, betas.size());
        Eigen::VectorXd r(equations);
        for (int e = 0; e < equations; ++e) {
            J.row(e) = 2 * betas.transpose() * pairs.forms[e];
            r(e) = pairs.squared[e] - betas.dot(pairs.forms[e] * betas);
        }
        betas += J.completeOrthogonalDecomposition().solve(r);
    }
}

Pose poseOf(const ControlPoints& control, const Eigen::VectorXd& x, const Data& data)
{
    const double sign = meanDepth(control, x) < 0 ? -1 : 1;
    return alignment(data.points, sign * asPoints(x) * control.alphas);
}

}  // namespace

std::vector<Pose> posesByDistances(const ControlPoints& control, const Eigen::MatrixXd& kernel, const Data& data)
{
    const Distances pairs = distances(control, kernel);
    std::vector<Pose> poses;
    for (int count = 1; count < control.count(); ++count) {
        Eigen::VectorXd betas = linearised(pairs, count, control.count());
        poses.push_back(poseOf(control, kernel * betas, data));
        improve(pairs, betas);
        poses.push_back(poseOf(control, kernel * betas, data));
    }
    return poses;
}

Pose poseByProcrustes(const ControlPoints& control, const Eigen::MatrixXd& kernel, const Data& data)
{
    constexpr int TURNS = 1000;
    constexpr double NEGLIGIBLE = 1e-9;
    Eigen::VectorXd x = kernel.col(0);
    x *= meanDepth(control, x) < 0 ? -1 : 1;
    const Matrix3Xd spread = control.object.colwise() - control.object.rowwise().mean();
    x *= spread.norm() / (asPoints(x).colwise() - asPoints(x).rowwise().mean()).norm();
    Pose pose;
    for (int turn = 0; turn < TURNS; ++turn) {
        const Pose next = alignment(control.object, asPoints(x));
        const Matrix3Xd moved = (next.R * control.object).colwise() + next.t;
        x = kernel * (kernel.transpose() * Eigen::Map<const Eigen::VectorXd>(moved.data(), moved.size()));
        const double change = (next.R - pose.R).norm() + (next.t - pose.t).norm() / next.t.norm();
        pose = next;
        if (change < NEGLIGIBLE)
            break;
    }
    return poseOf(control, x, data);
}

}  // namespace baselines
