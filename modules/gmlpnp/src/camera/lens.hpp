// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_CAMERA_LENS_HPP
#define OPENCV_GMLPNP_CAMERA_LENS_HPP

#include "common.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

/** The affine end of a lens: u = fx x + skew y + cx, v = fy y + cy. It maps the image plane of focal length 1 to pixels
and back. */
class Intrinsics
{
public:
    Intrinsics(double fx, double fy, double skew, double cx, double cy)
        : fx_(fx), fy_(fy), skew_(skew), cx_(cx), cy_(cy), wx_(1 / fx), wy_(1 / fy)
    {}

    /** Sets the pixel of a point of the plane. Returns false, and writes nothing, where the pixel leaves the range of a
    double. */
    bool pixelOf(const Point2d& p, Point2d& pixel) const
    {
        const Point2d found(fx_ * p.x + skew_ * p.y + cx_, fy_ * p.y + cy_);
        if (!isFinite(found))
            return false;
        pixel = found;
        return true;
    }

    /** Returns the point of the plane behind a pixel. */
    Point2d planeOf(const Point2d& pixel) const
    {
        const double y = (pixel.y - cy_) * wy_;
        return {(pixel.x - cx_ - skew_ * y) * wx_, y};
    }

    /** Turns a derivative by the point of the plane into the derivative by the pixel: J d(plane)/d(pixel). */
    Matx32d byPixel(const Matx32d& J) const
    {
        const double xy = -skew_ * wx_ * wy_;
        return {J(0, 0) * wx_, J(0, 0) * xy + J(0, 1) * wy_, J(1, 0) * wx_, J(1, 0) * xy + J(1, 1) * wy_,
                J(2, 0) * wx_, J(2, 0) * xy + J(2, 1) * wy_};
    }

    Intrinsics withoutSkew() const { return {fx_, fy_, 0, cx_, cy_}; }

    /** Returns the 3x3 camera matrix. */
    Matx33d matrix() const { return {fx_, skew_, cx_, 0, fy_, cy_, 0, 0, 1}; }

private:
    double fx_, fy_, skew_, cx_, cy_;  // px
    double wx_, wy_;                   // 1 / fx and 1 / fy, 1 / px
};

/** Returns the intrinsics of a camera matrix "K", 3x3 of any numeric depth.
@throws cv::Exception StsAssert for another shape; StsBadArg for a focal length of zero (less than 1e-30) or a value
that is not finite (more than 1e30), because the derivatives of a lens need room. */
Intrinsics intrinsicsFrom(InputArray cameraMatrix);

/** Returns the distortion coefficients "D" with zeros behind the last, `size` numbers in all.
@param coefficients a row or column of any numeric depth, or an empty array.
@param counts the numbers of coefficients that the lens accepts besides none.
@param size length of the returned vector.
@throws cv::Exception StsAssert for another shape or count; StsBadArg for a value that is not finite (more than 1e30).
*/
std::vector<double> coefficientsFrom(InputArray coefficients, std::initializer_list<int> counts, size_t size);

/** Throws StsBadArg, with the parameter's name in the message, unless low <= value <= high. A NaN throws too. */
void requireRange(double value, double low, double high, const char* name);

/** The base of the lenses that end in a camera matrix: it holds the matrix and writes the fields that they have
in common. */
class Lens : public CameraModel
{
public:
    void write(FileStorage& fs) const final;

protected:
    /** @param model the name that CameraModel::read() knows the lens by.
    @param k the camera matrix. */
    Lens(const char* model, const Intrinsics& k) : k_(k), model_(model) {}

    const Intrinsics k_;

private:
    /** Writes the fields that follow "model" and "K". */
    virtual void writeParameters(FileStorage& fs) const = 0;

    const char* const model_;
};

/** The base of a lens that has  double angularScale(const Vec3d& ray) const,  the angular scale of one unit ray as
CameraModel::angularScales() defines it. The compiler knows the lens here: a virtual call per ray would be several per
cent of a solve of many points. */
template <class ThisLens>
class LensOf : public Lens
{
public:
    void angularScales(const Vec3d* rays, int count, double* scales) const final
    {
        const ThisLens& lens = static_cast<const ThisLens&>(*this);
        for (int i = 0; i < count; ++i)
            scales[i] = lens.angularScale(rays[i]);
    }

protected:
    using Lens::Lens;
};

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_CAMERA_LENS_HPP
