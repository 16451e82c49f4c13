// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "principal_axes.hpp"
#include "reprojection.hpp"

// G. Zeng, S. Chen, B. Mu, G. Shi, J. Wu: CPnP: Consistent Pose Estimator for Perspective-n-Point Problem with Bias
// Elimination, ICRA 2023. The projection equations times the depth are linear once the mean depth is the unit of
// length:  x (a r3^T q + 1) = a r1^T q + tau1,  q = p - mean, 11 unknowns. The pixels' noise of variance s^2 stands
// also in the coefficients; what it adds to the normal matrix, 2 s^2 sum q q^T, is taken away again, with s^2 the
// smallest generalised eigenvalue of the bordered normal matrix. Then Gauss-Newton on the pixels.

namespace baselines {

namespace {

using Matrix11d = Eigen::Matrix<double, 11, 11>;
using Vector11d = Eigen::Matrix<double, 11, 1>;
using Matrix12d = Eigen::Matrix<double, 12, 12>;
using Vector12d = Eigen::Matrix<double, 12, 1>;

// [A b]^T [A b] with unknowns (a r3, a r1, tau1, a r2, tau2), and what unit noise adds to it.
struct Bordered
{
    Matrix12d normal = Matrix12d::Zero(), perNoise = Matrix12d::Zero();
};

Bordered bordered(const Data& data, const Vector3d& centroid, double scale)
{
    Bordered sums;
    for (int i = 0; i < data.size(); ++i) {
        const Vector3d q = (data.points.col(i) - centroid) / scale;
        for (int axis = 0; axis < 2; ++axis) {
            const double x = data.image(axis, i);
            Vector12d row = Vector12d::Zero(), noise = Vector12d::Zero();
            row.head<3>() = -x * q;
            row.segment<3>(3 + 4 * axis) = q;
            row(6 + 4 * axis) = 1;
            row(11) = x;
            noise.head<3>() = -q;
            noise(11) = 1;
            sums.normal += row * row.transpose();
            sums.perNoise += noise * noise.transpose();
        }
    }
    return sums;
}

// The largest variance that leaves the normal matrix positive semidefinite: it has a null vector without noise.
double noiseVariance(const Bordered& sums)
{
    const Eigen::LLT<Matrix12d> root(sums.normal);
    if (root.info() != Eigen::Success)
        return 0;  // exact data: singular to rounding
    const Matrix12d half = root.matrixL().solve(sums.perNoise);
    const Matrix12d ratio = root.matrixL().solve(half.transpose());
    return 1 / Eigen::SelfAdjointEigenSolver<Matrix12d>(ratio, Eigen::EigenvaluesOnly).eigenvalues()(11);
}

}  // namespace

std::optional<Pose> cpnp(const Data& data, const CpnpOptions& options)
{
    const PrincipalAxes principal(data.points);
    if (data.size() < 6 || principal.flatness() < SURELY_FLAT)
        return std::nullopt;  // 11 unknowns; a plane leaves three of them free
    const Vector3d& centroid = principal.centroid;
    const double scale = principal.deviations.norm();
    Bordered sums = bordered(data, centroid, scale);
    if (options.eliminateBias)
        sums.normal -= noiseVariance(sums) * sums.perNoise;
    const Vector11d x =
        Matrix11d(sums.normal.topLeftCorner<11, 11>()).ldlt().solve(Vector11d(sums.normal.topRightCorner<11, 1>()));
    Matrix3d M;
    M << x.segment<3>(3).transpose(), x.segment<3>(7).transpose(), x.head<3>().transpose();
    const double a = std::cbrt(M.determinant());
    if (!(a > 0))
        return std::nullopt;
    Pose pose;
    pose.R = cv::gmlpnp::detail::nearestRotation(M);
    pose.t = scale / a * Vector3d(x(6), x(10), 1) - pose.R * centroid;
    if (!plausible(data, pose))
        return std::nullopt;
    return refined(data, pose, options.refinements);
}

}  // namespace baselines
