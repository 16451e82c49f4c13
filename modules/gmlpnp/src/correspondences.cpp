// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "precomp.hpp"

#include "correspondences.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

namespace {

using RowPoints = Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>>;

RowPoints asEigen(const Mat_<double>& points)
{
    return RowPoints(points[0], points.rows, 3);
}

// Spread of the points across the best line through them, relative to the spread along it. Collinear points given in
// single precision come out near 1e-7, so nothing below this can be told from a line.
constexpr double COLLINEAR = 1e-6;

// The same for rays: all within this angle [rad] of each other.
constexpr double PARALLEL = 1e-9;

}  // namespace

bool finite(const Mat_<double>& objectPoints, const Mat_<double>& rays)
{
    const RowPoints p = asEigen(objectPoints), m = asEigen(rays);
    // The sum of squares is finite for anything below 1e150 and not for NaN and infinity.
    return std::isfinite(p.squaredNorm()) && std::isfinite(m.squaredNorm()) && m.rowwise().squaredNorm().minCoeff() > 0;
}

Correspondences::Correspondences(const Mat_<double>& objectPoints, const Mat_<double>& rays,
                                 const Mat_<double>& objectCovariances, const Mat_<double>& rayCovariances)
    : columns(objectPoints.rows, 6)
{
    const int n = objectPoints.rows;
    const double *p = objectPoints[0], *m = rays[0];
    Vector3d sum = Vector3d::Zero();
    for (int i = 0; i < n; ++i)
        sum += Vector3d(p[3 * i], p[3 * i + 1], p[3 * i + 2]);
    centre = sum / n;
    double square = 0;
    for (int i = 0; i < n; ++i) {
        const double length =
            std::sqrt(m[3 * i] * m[3 * i] + m[3 * i + 1] * m[3 * i + 1] + m[3 * i + 2] * m[3 * i + 2]);
        for (int k = 0; k < 3; ++k) {
            columns(i, k) = p[3 * i + k] - centre(k);
            columns(i, 3 + k) = m[3 * i + k] / length;
            square += columns(i, k) * columns(i, k);
        }
    }
    scale = std::sqrt(square / n);
    if (scale > 0)
        columns.leftCols<3>() *= 1 / scale;

    if (objectCovariances.empty() && rayCovariances.empty())
        return;
    known.setZero(size(), 12);
    constexpr int UPPER[6] = {0, 1, 2, 4, 5, 8};  // of a row-major 3x3
    for (int i = 0; i < size(); ++i)
        for (int k = 0; k < 6; ++k) {
            if (!objectCovariances.empty())
                known(i, k) = objectCovariances(i, UPPER[k]) / (scale * scale);
            if (!rayCovariances.empty())
                known(i, 6 + k) = rayCovariances(i, UPPER[k]);
        }
}

PointArrays Correspondences::arrays() const
{
    PointArrays out{};
    for (int axis = 0; axis < 3; ++axis) {
        out.point[axis] = columns.col(axis).data();
        out.ray[axis] = columns.col(3 + axis).data();
    }
    for (int entry = 0; entry < 12 && hasKnown(); ++entry)
        out.known[entry] = known.col(entry).data();
    out.size = size();
    return out;
}

Matrix3d Correspondences::knownAt(int i, int first) const
{
    const Eigen::Matrix<double, 1, 6> entries = known.row(i).segment<6>(first);
    return symmetric(entries.data());
}

bool Correspondences::degenerate() const
{
    if (!(scale > 0) || !std::isfinite(scale))
        return true;
    const auto points = columns.leftCols<3>();
    const Vector3d spread = Eigen3d(Matrix3d(points.transpose() * points), Eigen::EigenvaluesOnly).eigenvalues();
    // Rounding of coordinates far from the origin looks like spread too.
    const double rounding = 16 * std::numeric_limits<double>::epsilon() * centre.norm() / scale;
    const double line = std::max(COLLINEAR, rounding);
    const double widest =
        (columns.rightCols<3>().rowwise() - columns.row(0).tail<3>()).rowwise().squaredNorm().maxCoeff();
    return spread(1) <= line * line * spread(2) || widest <= PARALLEL * PARALLEL;
}

Pose Correspondences::toObject(const Pose& normalised) const
{
    return {normalised.R, scale * normalised.t - normalised.R * centre};
}

Pose Correspondences::fromObject(const Pose& pose) const
{
    return {pose.R, (pose.t + pose.R * centre) / scale};
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
