// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "../arrays/inputs.hpp"
#include "../arrays/outputs.hpp"

namespace cv {
namespace gmlpnp {

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

void CameraModel::angularScales(const Vec3d*, int count, double* scales) const
{
    std::fill_n(scales, count, 1.);
}

void CameraModel::unproject(InputArray imagePoints, OutputArray rays, OutputArray valid, OutputArray jacobian) const
{
    const Mat_<double> pixels = detail::pointsFrom(imagePoints, 2, "imagePoints");
    const int n = pixels.rows;
    Mat rayRows(n, 3, CV_64F), validRows(n, 1, CV_8U), jacobianRows;
    const Point2d* pixel = pixels.ptr<Point2d>();
    Vec3d* ray = rayRows.ptr<Vec3d>();
    if (jacobian.needed()) {
        jacobianRows.create(n, 6, CV_64F);
        Matx32d* J = jacobianRows.ptr<Matx32d>();
        for (int i = 0; i < n; ++i) {
            const bool seen = unprojectPoint(pixel[i], ray[i], &J[i]);
            *validRows.ptr(i) = seen ? 255 : 0;
            if (!seen)
                ray[i] = Vec3d(), J[i] = Matx32d::zeros();
        }
    } else {
        unprojectPoints(pixel, n, ray, validRows.ptr());
    }
    detail::Outputs outputs;
    outputs.add(rayRows, rays, "rays");
    outputs.add(validRows, valid, "valid");
    outputs.add(jacobianRows, jacobian, "jacobian");
    outputs.write();
}

void CameraModel::project(InputArray points, OutputArray imagePoints, OutputArray valid) const
{
    const Mat_<double> given = detail::pointsFrom(points, 3, "points");
    const int n = given.rows;
    Mat pixelRows(n, 2, CV_64F), validRows(n, 1, CV_8U);
    const Vec3d* point = given.ptr<Vec3d>();
    Point2d* pixel = pixelRows.ptr<Point2d>();
    for (int i = 0; i < n; ++i) {
        pixel[i] = Point2d();
        *validRows.ptr(i) = projectPoint(point[i], pixel[i]) ? 255 : 0;
    }
    detail::Outputs outputs;
    outputs.add(pixelRows, imagePoints, "imagePoints");
    outputs.add(validRows, valid, "valid");
    outputs.write();
}

}  // namespace gmlpnp
}  // namespace cv
