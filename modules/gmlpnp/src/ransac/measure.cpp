// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "../math/spd3.hpp"
#include "measure.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

namespace {

// The share of a rectangle with these variances along its sides that a disc covers. As large a share of wrong
// correspondences anywhere in the rectangle are inliers.
double chanceOf(double radius, double variance1, double variance2)
{
    constexpr double LEAST = 1e-9, MOST = 0.9;
    const double area = 12 * std::sqrt(std::max(variance1 * variance2, 0.));
    return std::min(std::max(CV_PI * radius * radius / area, LEAST), MOST);  // MOST also where the area is zero
}

Vector3d spread(const Mat_<double>& rows)
{
    if (rows.empty())
        return Vector3d::Zero();
    const Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> M(rows[0], rows.rows,
                                                                                                     rows.cols);
    const Eigen::RowVectorXd mean = M.colwise().mean();
    Matrix3d C = Matrix3d::Zero();
    C.topLeftCorner(rows.cols, rows.cols) = (M.rowwise() - mean).transpose() * (M.rowwise() - mean) / rows.rows;
    return Eigen3d(C, Eigen::EigenvaluesOnly).eigenvalues();
}

}  // namespace

Measure angularMeasure(const Mat_<double>& rays, double threshold)
{
    Measure measure;
    Mat_<double> unit(rays.rows, 3);
    for (int i = 0; i < rays.rows; ++i) {
        const Vector3d m = Vector3d(rays(i, 0), rays(i, 1), rays(i, 2)).normalized();
        measure.metrics.push_back(angularMetric(m, threshold));
        std::copy(m.data(), m.data() + 3, unit[i]);
    }
    const Vector3d variances = spread(unit);
    measure.chance = chanceOf(threshold, variances(1), variances(2));
    measure.exact = [](int, const Vector3d&, double e2) { return e2; };
    return measure;
}

namespace {

// The error in the picture, where the lens sees the point. Across the seam of a panorama neighbouring rays are far
// apart in the picture, so that the first order is taken there.
double pixelError2(const CameraModel& camera, const Vector3d& X, const double* pixel, double threshold, double e2)
{
    constexpr double SEAM = 16;  // ratio of squares; elsewhere the two agree
    Point2d seen;
    if (!camera.projectPoint({X.x(), X.y(), X.z()}, seen))
        return e2;
    const double du = seen.x - pixel[0], dv = seen.y - pixel[1], exact = (du * du + dv * dv) / (threshold * threshold);
    return exact > SEAM * std::max(e2, 1 / SEAM) ? e2 : exact;
}

}  // namespace

Measure pixelMeasure(const Ptr<CameraModel>& camera, const Mat_<double>& pixels, const Mat_<double>& rayByPixel,
                     double threshold)
{
    using RowMajor32 = Eigen::Matrix<double, 3, 2, Eigen::RowMajor>;
    Measure measure;
    for (int i = 0; i < pixels.rows; ++i)
        measure.metrics.push_back(pixelMetric(Eigen::Map<const RowMajor32>(rayByPixel[i]), threshold));
    const Vector3d variances = spread(pixels);
    measure.chance = chanceOf(threshold, variances(1), variances(2));
    measure.exact = [=](int i, const Vector3d& X, double e2) {
        return pixelError2(*camera, X, pixels[i], threshold, e2);
    };
    return measure;
}

Inliers inliersOf(const Correspondences& data, const Measure& measure, const Pose& pose)
{
    Inliers inliers{{}, 0};
    for (int i = 0; i < data.size(); ++i) {
        const Vector3d X = pose * data.pointAt(i);
        const double s = data.unitRayAt(i).dot(X);
        if (!(s > 0))
            continue;
        const double e2 = measure.exact(i, X, (measure.metrics[i] * X).squaredNorm() / (s * s));
        if (!(e2 <= 1))
            continue;
        inliers.rows.push_back(i);
        inliers.sumOfSquares += e2;
    }
    return inliers;
}

double varianceLeft(double meanSquare)
{
    constexpr double LEAST = 0.2;                    // at a threshold of 0.9 sigma
    constexpr double NARROW = 0.1, X_LARGEST = 100;  // of the mean square, where less than 1e-3 is cut off; of x
    constexpr int HALVINGS = 50;
    if (meanSquare < NARROW)
        return 1;
    double low = 0, high = X_LARGEST;
    for (int k = 0; k < HALVINGS; ++k) {
        const double x = (low + high) / 2;
        (1 / x - 1 / std::expm1(x) > meanSquare ? low : high) = x;
    }
    return std::max(1 - high / std::expm1(high), LEAST);
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
