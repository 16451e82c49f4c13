// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "common/residuals.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/output_file.hpp"

namespace samples {

namespace {

//! Step of the numeric derivative, relative to the point's distance: the cube root of the machine precision.
constexpr double kRelativeStep = 6e-6;

//! The derivative of the pixel with respect to the point, px per length; false where the lens does not see it.
bool projectionJacobian(const cv::gmlpnp::CameraModel& camera, const cv::Vec3d& X, cv::Matx23d& J)
{
    const double h = kRelativeStep * cv::norm(X);
    for (int c = 0; c < 3; ++c) {
        cv::Vec3d step;
        step[c] = h;
        cv::Point2d plus, minus;
        if (!camera.projectPoint(X + step, plus) || !camera.projectPoint(X - step, minus))
            return false;
        J(0, c) = (plus.x - minus.x) / (2.0 * h);
        J(1, c) = (plus.y - minus.y) / (2.0 * h);
    }
    return true;
}

double squaredMahalanobis(const cv::Vec2d& residual, const cv::Matx22d& covariance)
{
    const double determinant = cv::determinant(covariance);
    if (!(determinant > 0.0))
        return std::numeric_limits<double>::infinity();
    const cv::Matx22d adjugate(covariance(1, 1), -covariance(0, 1), -covariance(1, 0), covariance(0, 0));
    return residual.dot(adjugate * residual) / determinant;
}

//! From the point of the ray that S makes likeliest to X. Written with the tangent part of S alone, it holds for a
//! singular S too.
cv::Vec3d objectResidual(const cv::Vec3d& X, const cv::Vec3d& ray, const cv::Matx33d& S)
{
    // Two directions that span the plane across the ray.
    const cv::Vec3d a = cv::normalize(ray.cross(std::abs(ray[0]) < 0.5 ? cv::Vec3d(1, 0, 0) : cv::Vec3d(0, 1, 0)));
    const cv::Vec3d b = ray.cross(a);
    const cv::Vec3d Sa = S * a, Sb = S * b;
    const cv::Matx22d C(a.dot(Sa), a.dot(Sb), a.dot(Sb), b.dot(Sb));
    const cv::Vec2d across(a.dot(X), b.dot(X));
    cv::Vec2d weights;
    if (!cv::solve(C, across, weights, cv::DECOMP_CHOLESKY))
        return across[0] * a + across[1] * b;
    return weights[0] * Sa + weights[1] * Sb;
}

}  // namespace

double squaredRadiusOf95Percent(double tailShare)
{
    // Outside: e^(-r2/2) of the normal points, 1 / (1 + r2 / (2 * 6.25)) of the others (Result::tailShare).
    const auto outside = [&](double r2) {
        return (1.0 - tailShare) * std::exp(-r2 / 2.0) + tailShare / (1.0 + r2 / 12.5);
    };
    double low = -2.0 * std::log(0.05), high = 12.5 / 0.05;
    if (outside(low) <= 0.05)
        return low;
    for (int k = 0; k < 60; ++k) {
        const double middle = (low + high) / 2.0;
        (outside(middle) > 0.05 ? low : high) = middle;
    }
    return high;
}

std::vector<Residual> residualsOf(const cv::gmlpnp::CameraModel& camera, const CorrespondenceSet& set,
                                  const cv::gmlpnp::Result& result)
{
    const Pose pose = poseFromRotationVector(result.rvec, result.tvec);
    const cv::Matx33d Sigma(result.objectNoise), Gamma(result.bearingNoise);
    const double reach = squaredRadiusOf95Percent(result.tailShare);
    std::vector<Residual> residuals;
    for (size_t i = 0; i < set.objectPoints.size(); ++i) {
        const cv::Vec3d X = pose * cv::Vec3d(set.objectPoints[i]);
        Residual r;
        cv::Point2d predicted;
        cv::Vec3d ray;
        cv::Matx23d J;
        r.observed = set.imagePoints[i];
        if (!camera.projectPoint(X, predicted) || !camera.unprojectPoint(r.observed, ray) ||
            !projectionJacobian(camera, X, J))
            continue;
        r.depth = ray.dot(X);
        r.objectCovariance = pose.R * Sigma * pose.R.t() + r.depth * r.depth * Gamma;
        r.object = objectResidual(X, ray, r.objectCovariance);
        r.pixels = cv::Vec2d(r.observed.x - predicted.x, r.observed.y - predicted.y);
        r.pixelCovariance = J * r.objectCovariance * J.t();
        r.reach = reach;
        r.inside = squaredMahalanobis(r.pixels, r.pixelCovariance) <= reach;
        residuals.push_back(r);
    }
    return residuals;
}

std::vector<Residual> residualsOf(const CorrespondenceSet& set, const cv::gmlpnp::Result& result)
{
    return residualsOf(*set.camera(), set, result);
}

void writeResiduals(const std::string& path, const CorrespondenceSet& set, const std::vector<Residual>& residuals,
                    const std::string& method)
{
    files::writeFile(path, [&](std::ostream& out) {
        out << "# kind residuals\n# title " << set.name() << ": " << set.objectPoints.size() << " points, " << method
            << "\n";
        if (!set.unit.empty())
            out << "# unit " << set.unit << "\n";
        if (!set.imageSize.empty())
            out << "# image_size " << set.imageSize.width << " " << set.imageSize.height << "\n";
        if (!residuals.empty())
            out << cv::format("# squared_radius_95 %.9g\n", residuals[0].reach);
        out << "u,v,residual_u,residual_v,cov_uu,cov_uv,cov_vv,x,y,z,cov_xx,cov_xy,cov_xz,cov_yy,cov_yz,cov_zz,"
               "inside\n";
        for (const Residual& r : residuals) {
            const cv::Matx22d& P = r.pixelCovariance;
            const cv::Matx33d& S = r.objectCovariance;
            out << cv::format("%.10g,%.10g,%.9g,%.9g", r.observed.x, r.observed.y, r.pixels[0], r.pixels[1]);
            for (const double value : {P(0, 0), P(0, 1), P(1, 1), r.object[0], r.object[1], r.object[2], S(0, 0),
                                       S(0, 1), S(0, 2), S(1, 1), S(1, 2), S(2, 2)})
                out << cv::format(",%.9g", value);
            out << "," << r.inside << "\n";
        }
    });
}

PixelScale meanPixelScale(const cv::gmlpnp::CameraModel& camera, const std::vector<cv::Point2d>& pixels,
                          const cv::Matx33d& Gamma)
{
    PixelScale mean;
    int count = 0;
    for (const cv::Point2d& pixel : pixels) {
        cv::Vec3d ray;
        cv::Matx32d J;
        if (!camera.unprojectPoint(pixel, ray, &J))
            continue;
        const cv::Matx22d JtJ = J.t() * J;
        const cv::Matx23d inverse = JtJ.inv() * J.t();  // px per rad, from the plane across the ray
        mean.bearingNoise += inverse * Gamma * inverse.t();
        mean.pixelsPerRadian += 1.0 / std::sqrt(std::sqrt(cv::determinant(JtJ)));
        ++count;
    }
    const double share = 1.0 / std::max(count, 1);
    return {mean.bearingNoise * share, mean.pixelsPerRadian * share};
}

double meanDepth(const std::vector<Residual>& residuals)
{
    double sum = 0.0;
    for (const Residual& r : residuals)
        sum += r.depth;
    return residuals.empty() ? 0.0 : sum / static_cast<double>(residuals.size());
}

}  // namespace samples
