// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "common/canvas.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace samples {

namespace {

constexpr int kScale = 2;         // of the drawing against the picture
constexpr int kFractionBits = 4;  // of OpenCV's sub-pixel coordinates
constexpr int kEllipseCorners = 72;
//! OpenCV's sub-pixel coordinates overflow far outside; nothing there is visible anyway, px.
constexpr double kFarthest = 1e5;

int widthOf(double width)
{
    return std::max(1, cvRound(kScale * width));
}

}  // namespace

Canvas::Canvas(cv::Size size) : drawing_(size * kScale, CV_8UC3, colour::kWhite), target_(drawing_) {}

cv::Point Canvas::fixedPoint(cv::Point2d point) const
{
    const double factor = kScale * (1 << kFractionBits);
    const auto coordinate = [&](double value) { return cvRound(std::clamp(value, -kFarthest, kFarthest) * factor); };
    return {coordinate(point.x - origin_.x), coordinate(point.y - origin_.y)};
}

void Canvas::line(cv::Point2d a, cv::Point2d b, const cv::Scalar& colour, double width)
{
    cv::line(target_, fixedPoint(a), fixedPoint(b), colour, widthOf(width), cv::LINE_AA, kFractionBits);
}

void Canvas::arrow(cv::Point2d from, cv::Point2d to, const cv::Scalar& colour, double width)
{
    line(from, to, colour, width);
    const cv::Point2d direction = to - from;
    const double length = std::hypot(direction.x, direction.y);
    if (length < 1.0)
        return;
    // A head of at most 5 px, for short arrows in proportion.
    const cv::Point2d back = -std::min(5.0, 0.4 * length) / length * direction, side(-back.y, back.x);
    line(to, to + back + 0.5 * side, colour, width);
    line(to, to + back - 0.5 * side, colour, width);
}

void Canvas::disc(cv::Point2d centre, double radius, const cv::Scalar& colour)
{
    cv::circle(target_, fixedPoint(centre), cvRound(kScale * radius * (1 << kFractionBits)), colour, cv::FILLED,
               cv::LINE_AA, kFractionBits);
}

void Canvas::rectangle(const cv::Rect2d& rectangle, const cv::Scalar& colour, double width)
{
    const cv::Point2d a = rectangle.tl(), c = rectangle.br(), b(c.x, a.y), d(a.x, c.y);
    line(a, b, colour, width);
    line(b, c, colour, width);
    line(c, d, colour, width);
    line(d, a, colour, width);
}

void Canvas::fill(const cv::Rect2d& rectangle, const cv::Scalar& colour)
{
    const cv::Point2d a = kScale * (rectangle.tl() - origin_), b = kScale * (rectangle.br() - origin_);
    cv::rectangle(target_, cv::Rect(cv::Point(a), cv::Point(b)), colour, cv::FILLED);
}

void Canvas::image(const cv::Rect2d& rectangle, const cv::Mat& picture)
{
    const cv::Rect area(cv::Point(kScale * rectangle.tl()), cv::Point(kScale * rectangle.br()));
    cv::resize(picture, drawing_(area), area.size(), 0.0, 0.0, cv::INTER_LINEAR);
}

void Canvas::ellipse(cv::Point2d centre, const cv::Matx22d& covariance, const cv::Scalar& colour, double width)
{
    cv::Mat values, vectors;
    cv::eigen(covariance, values, vectors);
    const double a = std::sqrt(std::max(0.0, values.at<double>(0))), b = std::sqrt(std::max(0.0, values.at<double>(1)));
    std::vector<cv::Point> corners;
    for (int i = 0; i < kEllipseCorners; ++i) {
        const double angle = 2.0 * CV_PI * i / kEllipseCorners;
        const double u = a * std::cos(angle), v = b * std::sin(angle);
        corners.push_back(
            fixedPoint(centre + cv::Point2d(u * vectors.at<double>(0, 0) + v * vectors.at<double>(1, 0),
                                            u * vectors.at<double>(0, 1) + v * vectors.at<double>(1, 1))));
    }
    cv::polylines(target_, std::vector<std::vector<cv::Point>>{corners}, true, colour, widthOf(width), cv::LINE_AA,
                  kFractionBits);
}

void Canvas::text(const std::string& text, cv::Point2d anchor, const cv::Scalar& colour, Align align, double size)
{
    const double scale = kScale * size;
    const int thickness = size > 0.5 ? 2 * kScale - 1 : kScale - 1 + (size > 0.4 ? 1 : 0);
    int baseline = 0;
    const cv::Size extent = cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, scale, thickness, &baseline);
    const double shift = align == Align::kLeft ? 0.0 : align == Align::kCentre ? 0.5 : 1.0;
    const cv::Point2d corner = kScale * (anchor - origin_) + cv::Point2d(-shift * extent.width, 0.5 * extent.height);
    cv::putText(target_, text, corner, cv::FONT_HERSHEY_SIMPLEX, scale, colour, thickness, cv::LINE_AA);
}

void Canvas::clip(const cv::Rect2d& rectangle)
{
    const cv::Rect whole(cv::Point(), drawing_.size());
    if (rectangle.empty()) {
        origin_ = cv::Point2d();
        target_ = drawing_;
        return;
    }
    const cv::Rect part = cv::Rect(cv::Point(kScale * rectangle.tl()), cv::Point(kScale * rectangle.br())) & whole;
    origin_ = cv::Point2d(part.tl()) / kScale;
    target_ = drawing_(part);
}

cv::Mat Canvas::picture() const
{
    cv::Mat picture;
    cv::resize(drawing_, picture, cv::Size(), 1.0 / kScale, 1.0 / kScale, cv::INTER_AREA);
    return picture;
}

}  // namespace samples
