// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "precomp.hpp"

#include "arrays.hpp"

namespace cv {
namespace gmlpnp {
namespace {

// Where n rows of an output are computed: in the caller's array, or beside it where it is none, of fixed type or part
// of a wider one.
Mat rowsFor(OutputArray out, int n, int cols, int depth)
{
    if (out.needed() && !out.fixedType()) {
        out.create(n, cols, depth);
        const Mat rows = out.getMat();
        if (rows.isContinuous())
            return rows;
    }
    return Mat(n, cols, depth);
}

// Hands the rows to a caller's array that is not theirs, such as a vector<Point2f>.
void deliver(const Mat& rows, OutputArray out, const char* name)
{
    if (!out.needed() || (!out.fixedType() && out.getMat().data == rows.data))
        return;
    if (out.fixedType() && out.channels() != 1 && out.channels() != rows.cols)
        CV_Error(Error::StsAssert, format("'%s' needs %d numbers per point", name, rows.cols));
    rows.reshape(out.fixedType() ? out.channels() : 1).convertTo(out, out.depth());
}

}  // namespace

CameraModel::~CameraModel() = default;

void CameraModel::write(FileStorage&) const
{
    CV_Error(Error::StsNotImplemented, "this camera model does not write itself");
}

void CameraModel::unprojectPoints(const Point2d* pixels, int count, Vec3d* rays, uchar* valid) const
{
    for (int i = 0; i < count; ++i) {
        const bool seen = unprojectPoint(pixels[i], rays[i]);
        valid[i] = seen ? 255 : 0;
        if (!seen)
            rays[i] = Vec3d();
    }
}

void CameraModel::unproject(InputArray imagePoints, OutputArray rays, OutputArray valid, OutputArray jacobian) const
{
    const Mat_<double> pixels = detail::pointsFrom(imagePoints, 2, "imagePoints");
    const int n = pixels.rows;
    Mat rayRows = rowsFor(rays, n, 3, CV_64F), validRows = rowsFor(valid, n, 1, CV_8U);
    const Point2d* pixel = pixels.ptr<Point2d>();
    Vec3d* ray = rayRows.ptr<Vec3d>();
    if (jacobian.needed()) {
        Mat jacobianRows = rowsFor(jacobian, n, 6, CV_64F);
        Matx32d* J = jacobianRows.ptr<Matx32d>();
        for (int i = 0; i < n; ++i) {
            const bool seen = unprojectPoint(pixel[i], ray[i], &J[i]);
            *validRows.ptr(i) = seen ? 255 : 0;
            if (!seen)
                ray[i] = Vec3d(), J[i] = Matx32d::zeros();
        }
        deliver(jacobianRows, jacobian, "jacobian");
    } else {
        unprojectPoints(pixel, n, ray, validRows.ptr());
    }
    deliver(rayRows, rays, "rays");
    deliver(validRows, valid, "valid");
}

void CameraModel::project(InputArray points, OutputArray imagePoints, OutputArray valid) const
{
    const Mat_<double> given = detail::pointsFrom(points, 3, "points");
    const int n = given.rows;
    Mat pixelRows = rowsFor(imagePoints, n, 2, CV_64F), validRows = rowsFor(valid, n, 1, CV_8U);
    const Vec3d* point = given.ptr<Vec3d>();
    Point2d* pixel = pixelRows.ptr<Point2d>();
    for (int i = 0; i < n; ++i) {
        pixel[i] = Point2d();
        *validRows.ptr(i) = projectPoint(point[i], pixel[i]) ? 255 : 0;
    }
    deliver(pixelRows, imagePoints, "imagePoints");
    deliver(validRows, valid, "valid");
}

}  // namespace gmlpnp
}  // namespace cv
