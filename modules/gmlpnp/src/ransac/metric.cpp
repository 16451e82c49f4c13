// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "metric.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

Metric pixelMetric(const Eigen::Matrix<double, 3, 2>& rayByPixel, double threshold)
{
    const Eigen::Matrix2d N = rayByPixel.transpose() * rayByPixel;
    const double trace = N.trace(), det = N.determinant();
    constexpr double POLE = 1e-20;  // at a panorama's pole all pixels of a row are one ray
    if (det > POLE * trace * trace)
        return N.inverse() * rayByPixel.transpose() / threshold;
    return N * rayByPixel.transpose() / (trace * trace * threshold);
}

Metric angularMetric(const Vector3d& ray, double threshold)
{
    Metric B;
    B.row(0) = ray.unitOrthogonal().transpose();
    B.row(1) = ray.cross(B.row(0).transpose()).transpose();
    return B / std::tan(threshold);
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
