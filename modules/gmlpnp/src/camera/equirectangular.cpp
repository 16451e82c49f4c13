// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "common.hpp"

// An equirectangular panorama of W x H pixels with the optical axis in its middle and y down:
//
//     longitude = atan2(X, Z)  in [-pi, pi],   latitude = atan2(Y, sqrt(X^2 + Z^2))  in [-pi/2, pi/2]
//     u = (1/2 + longitude / (2 pi)) W - 1/2,   v = (1/2 + latitude / pi) H - 1/2
//
// The centres of pixels lie at integers, so that the W columns span 2 pi: u goes from -1/2 to W - 1/2, v from -1/2 to
// H - 1/2.
//
// The valid domain is every direction. Every u has a ray, because the picture continues around; v must lie in
// [-1/2, H - 1/2]. The edges in v are the poles, (0, -1, 0) and (0, 1, 0). There all u have the same ray, the Jacobian
// has rank 1, and projectPoint() returns the middle u.

namespace cv {
namespace gmlpnp {
namespace detail {
namespace {

class Equirectangular final : public CameraModel
{
public:
    explicit Equirectangular(const Size& size)
        : size_(size), perColumn_(2 * CV_PI / size.width), perRow_(CV_PI / size.height)
    {}

    bool unprojectPoint(const Point2d& pixel, Vec3d& ray, Matx32d* jacobian) const override
    {
        const double longitude = (pixel.x + 0.5) * perColumn_ - CV_PI, latitude = (pixel.y + 0.5) * perRow_ - CV_PI / 2;
        if (!(std::isfinite(longitude) && pixel.y >= -0.5 && pixel.y <= size_.height - 0.5))
            return false;
        const double cl = std::cos(longitude), sl = std::sin(longitude);
        const double cb = std::cos(latitude), sb = std::sin(latitude);
        ray = Vec3d(cb * sl, sb, cb * cl);
        if (jacobian)
            *jacobian = Matx32d(cb * cl * perColumn_, -sb * sl * perRow_, 0, cb * perRow_, -cb * sl * perColumn_,
                                -sb * cl * perRow_);
        return true;
    }

    bool projectPoint(const Vec3d& point, Point2d& pixel) const override
    {
        Vec3d m;
        if (!unitVector(point, m))
            return false;
        const double longitude = std::atan2(m[0], m[2]);
        const double latitude = std::atan2(m[1], std::sqrt(m[0] * m[0] + m[2] * m[2]));
        pixel = {(longitude + CV_PI) / perColumn_ - 0.5, (latitude + CV_PI / 2) / perRow_ - 0.5};
        return true;
    }

    void write(FileStorage& fs) const override
    {
        fs.write("model", "equirectangular");
        fs.write("width", size_.width);
        fs.write("height", size_.height);
    }

private:
    Size size_;
    double perColumn_, perRow_;  // rad / px
};

}  // namespace
}  // namespace detail

Ptr<CameraModel> CameraModel::equirectangular(const Size& size)
{
    if (size.width <= 0 || size.height <= 0)
        CV_Error(Error::StsBadArg, format("'size' is %dx%d; it must be positive", size.width, size.height));
    return makePtr<detail::Equirectangular>(size);
}

}  // namespace gmlpnp
}  // namespace cv
