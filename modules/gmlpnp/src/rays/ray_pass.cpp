// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "ray_pass.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

TailTerms tailTerms(const Tails& tails, double c)
{
    if (tails.share == 0)
        return {std::exp(-c / 2), 1};
    const double nu = tails.dof, u = 1 / (1 + c / (nu * tails.spread2));
    const double gaussian = (1 - tails.share) * std::exp(-c / 2);
    double student = tails.share / tails.spread2 * u * (tails.dof % 2 ? std::sqrt(u) : 1);
    for (int k = tails.dof; k > 1; k -= 2)
        student *= u;
    const double g = gaussian + student + LEAST_DENSITY;
    return {g, (gaussian + student * (nu + 2) / (nu * tails.spread2) * u) / g};
}

PointTerms pointTerms(const Vector3d& p, const Vector3d& m, const Pose& pose, const Matrix3d& S_o,
                      const Matrix3d& Gamma, const Tails& tails)
{
    PointTerms at;
    at.X = pose * p;
    at.s = m.dot(at.X);
    const Matrix3d S = S_o + at.s * at.s * Gamma;
    const Matrix3d A = hat(m);
    const Vector3d v = m.cross(at.X), Sv = S * v;
    at.D = m.dot(adjugate(S) * m);
    at.c = v.dot(Sv) / at.D;
    at.w = tailTerms(tails, at.c).w;
    at.z = Sv.cross(m) / at.D;
    at.Q = A.transpose() * S * A / at.D;
    at.zTilde = at.z - at.s * at.z.dot(Gamma * at.z) * m;
    at.Xhat = at.X - S_o * at.z;
    return at;
}

PointTerms pointTerms(const Correspondences& data, int i, const Pose& pose, const Noise& noise)
{
    Matrix3d Sigma = noise.Sigma, Gamma = noise.Gamma;
    if (data.hasKnown()) {
        Sigma += data.knownObject(i);
        Gamma += data.knownRay(i);
    }
    return pointTerms(data.pointAt(i), data.scaledRayAt(i), pose, pose.R * Sigma * pose.R.transpose(), Gamma,
                      noise.tails);
}

namespace {

void writeSymmetric(const Matrix3d& S, double (&out)[6])
{
    Eigen::Map<Vector6d>{out} = entriesOf(S);
}

RaySums assembled(const PassSums& sums, const PassInput& input, int n)
{
    RaySums out;
    out.Zo = symmetric(sums.Zo);
    out.Go = symmetric(sums.Go);
    out.Zb = symmetric(sums.Zb);
    out.Gb = symmetric(sums.Gb);
    out.H.topLeftCorner<3, 3>() = symmetric(sums.Hpp);
    out.H.bottomRightCorner<3, 3>() = symmetric(sums.Hdd);
    out.H.topRightCorner<3, 3>() = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(sums.Hpd);
    out.H.bottomLeftCorner<3, 3>() = out.H.topRightCorner<3, 3>().transpose();
    out.g.head<3>() = Eigen::Map<const Vector3d>(sums.gp);
    out.g.tail<3>() = Eigen::Map<const Vector3d>(sums.gd);
    out.QQ = n / static_cast<double>(sums.inProducts) * symmetric6(sums.QQ);
    out.c = sums.c;
    out.c2 = sums.c2;
    out.misfit = input.tails.share > 0 ? -logarithm(sums.tailed) : 0.5 * sums.c;
    // A residual that is not a number hides from the product of bit patterns, not from the sum.
    out.L = 0.5 * logarithm(sums.D) + (std::isfinite(sums.c) ? out.misfit : sums.c);
    out.inFront = n - static_cast<int>(sums.behind);
    return out;
}

}  // namespace

Matrix6d symmetric6(const double (&entries)[21])
{
    Matrix6d S;
    for (int a = 0, k = 0; a < 6; ++a)
        for (int b = a; b < 6; ++b, ++k)
            S(a, b) = S(b, a) = entries[k];
    return S;
}

std::array<double, 12> entriesOf(const Pose& pose)
{
    std::array<double, 12> out{};
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>{out.data()} = pose.R;
    Eigen::Map<Vector3d>{out.data() + 9} = pose.t;
    return out;
}

namespace {

PassInput passInput(const Pose& pose, const Noise& noise)
{
    PassInput input{};
    const std::array<double, 12> at = entriesOf(pose);
    std::copy(at.begin(), at.end(), input.pose);
    writeSymmetric(pose.R * noise.Sigma * pose.R.transpose(), input.S_o);
    writeSymmetric(noise.Gamma, input.Gamma);
    input.tails = noise.tails;
    return input;
}

}  // namespace

RaySums rayPass(const Correspondences& data, const Pose& pose, const Noise& noise, const PassOptions& options,
                const RayKernels& kernels)
{
    PassInput input = passInput(pose, noise);
    input.lever = options.lever == LeverArm::CORRECTED ? 1 : 0;
    input.products = options.products;
    input.sampled = options.sampled;
    input.c = options.c;
    PassSums sums;
    kernels.pass(data.arrays(), input, sums);
    return assembled(sums, input, data.size());
}

RayProducts rayProducts(const Correspondences& data, const Pose& pose, const Noise& noise, const RayKernels& kernels)
{
    InformationSums sums;
    kernels.information(data.arrays(), passInput(pose, noise), sums);
    return {symmetric6(sums.object), symmetric6(sums.bearing), symmetric6(sums.both)};
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
