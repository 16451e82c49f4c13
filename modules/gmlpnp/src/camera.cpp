// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "precomp.hpp"

#include "arrays.hpp"

namespace cv {
namespace gmlpnp {
namespace {

// Where n rows of an output are computed: in the caller's array, or beside it where its type is fixed.
Mat rowsFor(OutputArray out, int n, int cols, int depth)
{
    if (!out.needed())
        return Mat();
    if (out.fixedType())
        return Mat(n, cols, depth);
    out.create(n, cols, depth);
    return out.getMat();
}

// Hands the rows to a caller's array of fixed type, such as vector<Point2f>.
void deliver(const Mat& rows, OutputArray out, const char* name)
{
    if (!out.needed() || !out.fixedType())
        return;
    if (out.channels() != 1 && out.channels() != rows.cols)
        CV_Error(Error::StsAssert, format("'%s' needs %d numbers per point", name, rows.cols));
    rows.reshape(out.channels()).convertTo(out, out.depth());
}

}  // namespace

CameraModel::~CameraModel() = default;

void CameraModel::write(FileStorage&) const
{
    CV_Error(Error::StsNotImplemented, "this camera model does not write itself");
}

void CameraModel::unproject(InputArray imagePoints, OutputArray rays, OutputArray valid, OutputArray jacobian) const
{
    const Mat_<double> pixels = detail::pointsFrom(imagePoints, 2, "imagePoints");
    const int n = pixels.rows;
    Mat rayRows = rowsFor(rays, n, 3, CV_64F);
    Mat validRows = rowsFor(valid, n, 1, CV_8U);
    Mat jacobianRows = rowsFor(jacobian, n, 6, CV_64F);
    const bool wantRays = rays.needed(), wantValid = valid.needed(), wantJacobian = jacobian.needed();
    for (int i = 0; i < n; ++i) {
        Vec3d ray;
        Matx32d J;
        const double* pixel = pixels[i];
        const bool seen = unprojectPoint({pixel[0], pixel[1]}, ray, wantJacobian ? &J : nullptr);
        if (wantRays)
            *rayRows.ptr<Vec3d>(i) = seen ? ray : Vec3d();
        if (wantValid)
            *validRows.ptr(i) = seen ? 255 : 0;
        if (wantJacobian)
            *jacobianRows.ptr<Matx32d>(i) = seen ? J : Matx32d::zeros();
    }
    deliver(rayRows, rays, "rays");
    deliver(validRows, valid, "valid");
    deliver(jacobianRows, jacobian, "jacobian");
}

void CameraModel::project(InputArray points, OutputArray imagePoints, OutputArray valid) const
{
    const Mat_<double> given = detail::pointsFrom(points, 3, "points");
    const int n = given.rows;
    Mat pixelRows = rowsFor(imagePoints, n, 2, CV_64F);
    Mat validRows = rowsFor(valid, n, 1, CV_8U);
    const bool wantPixels = imagePoints.needed(), wantValid = valid.needed();
    for (int i = 0; i < n; ++i) {
        Point2d pixel;
        const double* point = given[i];
        const bool seen = projectPoint({point[0], point[1], point[2]}, pixel);
        if (wantPixels)
            *pixelRows.ptr<Point2d>(i) = seen ? pixel : Point2d();
        if (wantValid)
            *validRows.ptr(i) = seen ? 255 : 0;
    }
    deliver(pixelRows, imagePoints, "imagePoints");
    deliver(validRows, valid, "valid");
}

}  // namespace gmlpnp
}  // namespace cv
