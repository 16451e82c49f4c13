// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "../arrays/inputs.hpp"
#include "draw.hpp"
#include "opencv2/gmlpnp/draw.hpp"

#include <opencv2/imgproc.hpp>

namespace cv {
namespace gmlpnp {
namespace detail {

bool pixelUncertainty(const CameraModel& camera, const Result& result, const Vec3d& point, Point2d& pixel,
                      Matx22d& covariance)
{
    Matx33d R;
    Rodrigues(result.rvec, R);
    const Vec3d X = R * point + result.tvec;
    Vec3d ray;
    Matx32d rayByPixel;
    if (!camera.projectPoint(X, pixel) || !camera.unprojectPoint(pixel, ray, &rayByPixel))
        return false;
    covariance = Matx22d::zeros();
    if (result.poseCovariance.empty())
        return true;
    // The point moves by dX = [ -[X]_x , I ] xi. Its ray turns by the part of dX across it, over the distance; the
    // inverse of the lens turns that into a change of the pixel.
    const double byXi[] = {0,     X[2],  -X[1], 1, 0, 0,  //
                           -X[2], 0,     X[0],  0, 1, 0,  //
                           X[1],  -X[0], 0,     0, 0, 1};
    bool regular = false;
    const Matx22d N = (rayByPixel.t() * rayByPixel).inv(DECOMP_LU, &regular);
    if (!regular)
        return false;
    const Matx<double, 2, 6> J = (1 / cv::norm(X)) * (N * rayByPixel.t() * Matx<double, 3, 6>(byXi));
    covariance = J * Matx66d(result.poseCovariance) * J.t();
    return true;
}

namespace {

constexpr int SHIFT = 4;  // OpenCV draws positions with so many fractional bits

const Scalar AXES[] = {{0, 0, 255, 255}, {0, 255, 0, 255}, {255, 0, 0, 255}};
const Scalar ELLIPSE(0, 255, 255, 255);

// Pixels further away than this many pictures are not drawn, because fixed-point positions have an end.
constexpr double FARTHEST = 10;

bool drawable(const Point2d& p, const Size& size)
{
    const double reach = FARTHEST * std::max(size.width, size.height);
    return std::abs(p.x) < reach && std::abs(p.y) < reach;
}

void drawCurve(Mat& image, const std::vector<Point2d>& curve, const Scalar& colour, int thickness)
{
    const Scalar shown = image.channels() == 1 ? Scalar(255) : colour;
    for (size_t i = 1; i < curve.size(); ++i)
        line(image, Point(Point2d(curve[i - 1] * (1 << SHIFT))), Point(Point2d(curve[i] * (1 << SHIFT))), shown,
             thickness, LINE_AA, SHIFT);
}

void drawAxis(Mat& image, const CameraModel& camera, const Result& result, const Vec3d& tip, const Scalar& colour,
              int thickness)
{
    constexpr int STEPS = 32;
    Matx33d R;
    Rodrigues(result.rvec, R);
    std::vector<Point2d> curve;
    for (int i = 0; i <= STEPS; ++i) {
        Point2d pixel;
        const bool seen =
            camera.projectPoint(R * tip * (double(i) / STEPS) + result.tvec, pixel) && drawable(pixel, image.size());
        // Neighbours on both sides of the seam of a panorama are more than half a picture apart: the curve breaks
        // there.
        if (!seen || (!curve.empty() && std::abs(pixel.x - curve.back().x) > image.cols / 2.)) {
            drawCurve(image, curve, colour, thickness);
            curve.clear();
        }
        if (seen)
            curve.push_back(pixel);
    }
    drawCurve(image, curve, colour, thickness);
}

void drawEllipse(Mat& image, const Point2d& centre, const Matx22d& covariance, int thickness)
{
    constexpr int STEPS = 72;
    constexpr double RADIUS2 = 5.991464547107979;  // statistics: 95 % of chi-squared with 2 degrees, -2 log .05
    // The Cholesky factor of the covariance turns the unit circle into the ellipse.
    const double a = std::sqrt(RADIUS2 * covariance(0, 0));
    const double b = a > 0 ? RADIUS2 * covariance(0, 1) / a : 0;
    const double c = std::sqrt(std::max(RADIUS2 * covariance(1, 1) - b * b, 0.));
    std::vector<Point2d> curve;
    for (int i = 0; i <= STEPS; ++i) {
        const double turn = 2 * CV_PI * i / STEPS, u = std::cos(turn), v = std::sin(turn);
        curve.push_back(centre + Point2d(a * u, b * u + c * v));
        if (!drawable(curve.back(), image.size()))
            return;
    }
    drawCurve(image, curve, ELLIPSE, thickness);
}

}  // namespace
}  // namespace detail

using namespace detail;

void drawPoseUncertainty(InputOutputArray image, const Ptr<CameraModel>& camera, const Result& result, double length,
                         InputArray points, int thickness)
{
    const Mat shown = image.getMat();
    if (shown.empty() || shown.depth() != CV_8U || shown.channels() == 2 || shown.channels() > 4)
        CV_Error(Error::StsAssert, "image must be a picture of 8 bits with 1, 3 or 4 channels");
    if (!camera)
        CV_Error(Error::StsBadArg, "camera is null");
    if (!(length > 0) || !std::isfinite(length))
        CV_Error(Error::StsBadArg, format("length: %g is not positive", length));
    if (thickness < 1)
        CV_Error(Error::StsBadArg, format("thickness: %d is not positive", thickness));
    Mat picture = shown.clone();  // a call that throws leaves no half of a drawing
    for (int axis = 2; axis >= 0; --axis) {
        Vec3d tip;
        tip[axis] = length;
        drawAxis(picture, *camera, result, tip, AXES[axis], thickness);
    }
    Mat_<double> all(1, 3, 0.0);
    if (!points.empty())
        all.push_back(pointsFrom(points, 3, "points"));
    for (int i = 0; i < all.rows; ++i) {
        Point2d pixel;
        Matx22d covariance;
        if (pixelUncertainty(*camera, result, Vec3d(all[i]), pixel, covariance) && cv::trace(covariance) > 0)
            drawEllipse(picture, pixel, covariance, std::max(1, thickness / 2));
    }
    picture.copyTo(shown);
}

}  // namespace gmlpnp
}  // namespace cv
