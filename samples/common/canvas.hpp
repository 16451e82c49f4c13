// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_SAMPLES_CANVAS_HPP
#define GMLPNP_SAMPLES_CANVAS_HPP

#include <array>
#include <string>

#include <opencv2/core.hpp>

namespace samples {

/** Colours that readers with any colour vision tell apart (Okabe and Ito) and tints of them, in OpenCV's order blue,
green, red. */
namespace colour {
const cv::Scalar kBlue(178, 114, 0), kOrange(0, 94, 213), kBlack(30, 30, 30), kGrey(130, 130, 130);
const cv::Scalar kLightBlue(226, 195, 148), kLightOrange(148, 184, 240), kLightGrey(232, 232, 232);
const cv::Scalar kWhite(255, 255, 255);
//! For the curves of one graph.
const std::array<cv::Scalar, 8> kPalette = {kGrey,           {0, 159, 230}, {115, 158, 0}, {233, 180, 86},
                                            {167, 121, 204}, kBlack,        kBlue,         kOrange};
inline const cv::Scalar& ofCurve(size_t index)
{
    return kPalette[index % kPalette.size()];
}
}  // namespace colour

enum class Align
{
    kLeft,
    kCentre,
    kRight
};

/** A white picture drawn at twice its size and shrunk at the end: smooth lines and text. All positions, lengths and
widths are in pixels of the final picture, and need not be whole numbers. */
class Canvas
{
public:
    explicit Canvas(cv::Size size);

    void line(cv::Point2d a, cv::Point2d b, const cv::Scalar& colour, double width = 1.0);
    void arrow(cv::Point2d from, cv::Point2d to, const cv::Scalar& colour, double width = 1.0);
    void disc(cv::Point2d centre, double radius, const cv::Scalar& colour);
    void rectangle(const cv::Rect2d& rectangle, const cv::Scalar& colour, double width = 1.0);
    void fill(const cv::Rect2d& rectangle, const cv::Scalar& colour);
    //! A picture of three channels, stretched into the rectangle.
    void image(const cv::Rect2d& rectangle, const cv::Mat& picture);
    //! The points at squared Mahalanobis distance 1 from the centre.
    void ellipse(cv::Point2d centre, const cv::Matx22d& covariance, const cv::Scalar& colour, double width = 1.0);
    //! Text on a line whose middle height is at `anchor`.
    void text(const std::string& text, cv::Point2d anchor, const cv::Scalar& colour, Align align = Align::kLeft,
              double size = 0.42);
    //! What is drawn from here on stays inside the rectangle; an empty one lifts the limit.
    void clip(const cv::Rect2d& rectangle = cv::Rect2d());

    cv::Mat picture() const;

private:
    cv::Mat drawing_;  //!< twice the size
    cv::Mat target_;   //!< the part of it that is drawn on
    cv::Point2d origin_;

    cv::Point fixedPoint(cv::Point2d point) const;
};

}  // namespace samples

#endif  // GMLPNP_SAMPLES_CANVAS_HPP
