// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "../arrays/eigen.hpp"
#include "../arrays/inputs.hpp"
#include "../math/spd3.hpp"
#include "options.hpp"
#include "problem.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

namespace {

// N rows of `columns` numbers. The shape is checked here, the matrices by their users.
Mat_<double> covarianceRows(const Mat& given, int rows, std::initializer_list<int> columns, const char* name)
{
    // One row per point, or a vector with one element per point: 1xN or Nx1 with channels.
    const bool vector = given.dims == 2 && given.rows == 1 && given.cols == rows;
    const Mat dense = given.isContinuous() ? given : given.clone();
    const Mat flat = dense.dims == 2 ? dense.reshape(1, vector ? rows : given.rows) : dense;
    const bool fits = std::find(columns.begin(), columns.end(), flat.cols) != columns.end();
    if (flat.rows != rows || !fits)
        CV_Error(Error::StsAssert, format("%s must have one row per point, with %s numbers; there are %d points", name,
                                          columns.size() > 1 ? "1 or 4" : "9", rows));
    return matrixFrom(flat, rows, flat.cols, name);
}

void checkCovariance(const Matrix3d& C, const char* name, int point)
{
    if (!isCovariance(C))
        CV_Error(Error::StsBadArg,
                 format("%s: point %d is not symmetric positive semidefinite and at most 1e60", name, point));
}

Mat_<double> knownObject(const Params& params, int rows)
{
    if (params.objectCovariances.empty())
        return {};
    Mat_<double> given = covarianceRows(params.objectCovariances, rows, {9}, "objectCovariances");
    for (int i = 0; i < rows; ++i)
        checkCovariance(matrix3(given[i]), "objectCovariances", i);
    return given;
}

// The covariance of a pixel as that of its ray: J C J^T with the derivative J of the ray by the pixel.
Mat_<double> knownRays(const Params& params, const Mat_<double>& jacobian, const Mat_<uchar>& valid)
{
    if (params.pixelCovariances.empty())
        return {};
    const int rows = jacobian.rows;
    const Mat_<double> given = covarianceRows(params.pixelCovariances, rows, {1, 4}, "pixelCovariances");
    Mat_<double> out(rows, 9, 0.0);
    for (int i = 0; i < rows; ++i) {
        Matrix3d padded = Matrix3d::Zero();
        padded(0, 0) = given(i, 0);
        padded(1, 1) = given(i, given.cols - 1);
        if (given.cols == 4)
            padded(0, 1) = given(i, 1), padded(1, 0) = given(i, 2);
        checkCovariance(padded, "pixelCovariances", i);
        if (!valid(i))
            continue;
        const Eigen::Map<const Eigen::Matrix<double, 3, 2, Eigen::RowMajor>> J(jacobian[i]);
        Eigen::Map<Matrix3d> covariance(out[i]);  // symmetric: row-major and column-major are one
        covariance = symmetrised(J * padded.topLeftCorner<2, 2>() * J.transpose());
    }
    return out;
}

// Makes rays as long as their angular scales.
void scaleRays(const CameraModel& camera, Mat_<double>& rays)
{
    constexpr double SMALLEST = 0.01, LARGEST = 100;  // nobody calibrates a lens to the very edge of its field
    std::vector<double> scales(rays.rows);
    Vec3d* const ray = rays.ptr<Vec3d>();
    camera.angularScales(ray, rays.rows, scales.data());
    for (int i = 0; i < rays.rows; ++i) {
        const double length = std::sqrt(ray[i].dot(ray[i]));  // of a caller's own lens it may be any
        ray[i] *= std::min(std::max(SMALLEST, scales[i]), LARGEST) / length;
    }
}

void checkSameCount(const Mat& points, const Mat& images, const char* name)
{
    if (points.rows != images.rows)
        CV_Error(Error::StsAssert,
                 format("objectPoints and %s differ in number: %d and %d", name, points.rows, images.rows));
}

}  // namespace

Problem problemFromRays(InputArray objectPoints, InputArray rays, const Params& params)
{
    if (!params.pixelCovariances.empty())
        CV_Error(Error::StsBadArg, "pixelCovariances need a camera: solve() takes one, solveRays() does not");
    Problem problem;
    problem.observations.points = pointsFrom(objectPoints, 3, "objectPoints");
    problem.observations.rays = pointsFrom(rays, 3, "rays");
    checkSameCount(problem.observations.points, problem.observations.rays, "rays");
    problem.total = problem.observations.points.rows;
    problem.observations.objectCovariances = knownObject(params, problem.total);
    problem.used.resize(problem.total);
    for (int i = 0; i < problem.total; ++i)
        problem.used[i] = i;
    problem.finite = finiteGuess(params);
    return problem;
}

Problem problemFromPixels(InputArray objectPoints, InputArray imagePoints, const Ptr<CameraModel>& camera,
                          const Params& params, bool wantRayByPixel)
{
    if (!camera)
        CV_Error(Error::StsBadArg, "camera is null");
    const Mat_<double> points = pointsFrom(objectPoints, 3, "objectPoints");
    const Mat_<double> pixels = pointsFrom(imagePoints, 2, "imagePoints");
    checkSameCount(points, pixels, "imagePoints");
    const bool weighed = !params.pixelCovariances.empty();
    Mat rays, jacobian;
    Mat_<uchar> valid;
    camera->unproject(pixels, rays, valid, weighed || wantRayByPixel ? OutputArray(jacobian) : OutputArray(noArray()));

    Problem problem;
    problem.total = points.rows;
    problem.used.reserve(problem.total);
    for (int i = 0; i < problem.total; ++i)
        if (valid(i))
            problem.used.push_back(i);
    const bool allUsed = static_cast<int>(problem.used.size()) == problem.total;
    problem.observations = {chosenRows(points, problem.used), chosenRows(rays, problem.used),
                            chosenRows(knownObject(params, problem.total), problem.used),
                            chosenRows(weighed ? knownRays(params, jacobian, valid) : Mat_<double>(), problem.used),
                            true};
    scaleRays(*camera, problem.observations.rays);
    if (wantRayByPixel)
        problem.rayByPixel = chosenRows(jacobian, problem.used);
    // A pixel that is not a number is bad data, not a pixel without a ray. So is such a point, even without a ray.
    // Where all pixels have a ray they are finite, and the solver looks at the points.
    const auto allFinite = [](const Mat& m) { return checkRange(m, true, nullptr, -DBL_MAX, DBL_MAX); };
    problem.finite = finiteGuess(params) && (allUsed || (allFinite(pixels) && allFinite(points)));
    return problem;
}

void requireEnough(const Problem& problem, int fewest)
{
    if (problem.total < fewest)
        CV_Error(Error::StsAssert, format("objectPoints: fewer than %d points", fewest));
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
