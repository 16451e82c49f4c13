// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "../kernels/dispatch.hpp"
#include "../math/limits.hpp"
#include "correspondences.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

namespace {

// Rounding: the spread of the points across the best line through them, relative to the spread along it. Collinear
// points given in single precision come out near 1e-7, so nothing below this can be told from a line.
constexpr double COLLINEAR = 1e-6;

// Rounding: the root of the sum of the squared angles of the rays to the first [rad].
constexpr double PARALLEL = 1e-9;

// Rounding: the least known variance over the mean of the points. Sums of smaller ones with the others have no digits
// left.
constexpr double EXACT = 1e-10;

// Lifts smaller variances to the least. The rows have 6 entries (xx xy xz yy yz zz). In `along` directions a covariance
// has no variance and needs none.
template <class Rows>
void liftSingular(Rows rows, int along)
{
    const double least = EXACT / 3 * (rows.col(0) + rows.col(3) + rows.col(5)).mean();
    for (int i = 0; i < rows.rows(); ++i) {
        const Vector6d entries = rows.row(i);
        if (Eigen3d(symmetric(entries.data()), Eigen::EigenvaluesOnly).eigenvalues()(along) < least)
            for (const int diagonal : {0, 3, 5})
                rows(i, diagonal) += least;
    }
}

}  // namespace

Correspondences::Correspondences(const Observations& observations)
    : columns_(observations.points.rows, 6), scaled_(observations.scaled)
{
    using Rows = Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>>;
    columns_ << Rows(observations.points[0], size(), 3), Rows(observations.rays[0], size(), 3);
    normalise();
    if (!std::isnormal(scale))  // not finite() or degenerate()
        return;
    if (scaled_)
        columns_.rightCols<3>() = Rows(observations.rays[0], size(), 3);
    setKnown(observations.objectCovariances, observations.rayCovariances);
}

// Centres and scales the points, and looks at all columns once.
void Correspondences::normalise()
{
    centre = columns_.leftCols<3>().colwise().mean();
    prepare(centre);
    scale = std::sqrt((sums_.scatter[0] + sums_.scatter[3] + sums_.scatter[5]) / size());
    if (!std::isnormal(scale))
        return;
    columns_.leftCols<3>() *= 1 / scale;
    for (double& entry : sums_.scatter)
        entry /= scale * scale;
}

void Correspondences::setKnown(const Mat_<double>& objectCovariances, const Mat_<double>& rayCovariances)
{
    if (objectCovariances.empty() && rayCovariances.empty())
        return;
    known_.setZero(size(), 12);
    constexpr int UPPER[6] = {0, 1, 2, 4, 5, 8};  // of a row-major 3x3
    for (int i = 0; i < size(); ++i)
        for (int k = 0; k < 6; ++k) {
            if (!objectCovariances.empty())
                known_(i, k) = objectCovariances(i, UPPER[k]) / (scale * scale);
            if (!rayCovariances.empty())
                known_(i, 6 + k) = rayCovariances(i, UPPER[k]);
        }
    if (!objectCovariances.empty())
        liftSingular(known_.leftCols<6>(), 0);
    if (!rayCovariances.empty())
        liftSingular(known_.rightCols<6>(), 1);
    if (scaled_)
        known_.rightCols<6>().array().colwise() /= columns_.rightCols<3>().rowwise().squaredNorm().array();
}

// The kernel makes the rays unit, to judge them. Those with an angular scale must get their length back, from where
// they came: a copy of them would be memory for every point.
void Correspondences::prepare(const Vector3d& origin)
{
    double *point[3], *ray[3];
    for (int axis = 0; axis < 3; ++axis) {
        point[axis] = columns_.col(axis).data();
        ray[axis] = columns_.col(3 + axis).data();
    }
    rayKernels(size()).prepare(point, ray, size(), origin.data(), sums_);
}

void Correspondences::takeScaledRays(const Correspondences& from, const std::vector<int>& rows)
{
    for (int k = 0; scaled_ && k < size(); ++k)
        columns_.row(k).tail<3>() = from.columns_.row(rows[k]).tail<3>();
}

double Correspondences::logAngularScales() const
{
    return scaled_ ? 0.5 * columns_.rightCols<3>().rowwise().squaredNorm().array().log().sum() : 0;
}

Correspondences Correspondences::gathered(const std::vector<int>& rows) const
{
    Correspondences out;
    const int count = static_cast<int>(rows.size());
    out.scaled_ = scaled_;
    out.columns_.resize(count, 6);
    out.known_.resize(hasKnown() ? count : 0, 12);
    for (int k = 0; k < count; ++k) {
        out.columns_.row(k) = columns_.row(rows[k]);
        if (hasKnown())
            out.known_.row(k) = known_.row(rows[k]);
    }
    return out;
}

Correspondences Correspondences::part(int count) const
{
    RNG rng(0x9e3779b9);  // not every k-th: points often come in rows of a grid
    std::vector<int> rows(count);
    for (int k = 0; k < count; ++k) {
        const int64 first = static_cast<int64>(k) * size() / count, end = static_cast<int64>(k + 1) * size() / count;
        rows[k] = rng.uniform(static_cast<int>(first), static_cast<int>(end));
    }
    Correspondences out = gathered(rows);
    out.centre = centre;
    out.scale = scale;
    out.prepare(Vector3d::Zero());
    out.takeScaledRays(*this, rows);
    return out;
}

Correspondences Correspondences::subset(const std::vector<int>& rows) const
{
    Correspondences out = gathered(rows);
    out.normalise();
    out.takeScaledRays(*this, rows);
    if (hasKnown())
        out.known_.leftCols<6>() /= out.scale * out.scale;
    out.centre = centre + scale * out.centre;
    out.scale *= scale;
    return out;
}

PointArrays Correspondences::arrays() const
{
    PointArrays out{};
    for (int axis = 0; axis < 3; ++axis) {
        out.point[axis] = columns_.col(axis).data();
        out.ray[axis] = columns_.col(3 + axis).data();
    }
    for (int entry = 0; entry < 12 && hasKnown(); ++entry)
        out.known[entry] = known_.col(entry).data();
    out.size = size();
    return out;
}

Matrix3d Correspondences::knownAt(int i, int first) const
{
    const Eigen::Matrix<double, 1, 6> entries = known_.row(i).segment<6>(first);
    return symmetric(entries.data());
}

bool Correspondences::finite() const
{
    return scale < LARGEST_LENGTH && std::isfinite(sums_.ray2) && std::isfinite(sums_.inverse2);
}

bool Correspondences::degenerate() const
{
    if (!(scale > SMALLEST_LENGTH))
        return true;
    const Vector3d spread = Eigen3d(symmetric(sums_.scatter), Eigen::EigenvaluesOnly).eigenvalues();
    // The rounding of coordinates far from the origin looks like spread, too.
    const double rounding = 16 * std::numeric_limits<double>::epsilon() * centre.norm() / scale;
    const double line = std::max(COLLINEAR, rounding);
    return spread(1) <= line * line * spread(2) || sums_.apart2 <= PARALLEL * PARALLEL;
}

// In most data the first few points are at distinct places already, so that a few comparisons end the search.
bool Correspondences::hasPlaces(int wanted) const
{
    std::array<int, 4> places;
    CV_Assert(wanted <= static_cast<int>(places.size()));
    int count = 0;
    for (int i = 0; i < size() && count < wanted; ++i) {
        const auto same = [&](int place) { return (pointAt(i) - pointAt(place)).norm() <= COLLINEAR; };
        if (std::none_of(places.begin(), places.begin() + count, same))
            places[count++] = i;
    }
    return count >= wanted;
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
