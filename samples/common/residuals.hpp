// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_SAMPLES_RESIDUALS_HPP
#define GMLPNP_SAMPLES_RESIDUALS_HPP

#include <string>
#include <vector>

#include <opencv2/gmlpnp.hpp>

#include "common/correspondences.hpp"

namespace samples {

/** What an estimate says about one correspondence, and how far the data are from it. */
struct Residual
{
    cv::Point2d observed;          //!< px
    cv::Vec2d pixels;              //!< observed minus predicted, px
    cv::Matx22d pixelCovariance;   //!< of the predicted pixel, px^2; with tails that of most points
    double depth;                  //!< along the ray, length
    cv::Vec3d object;              //!< camera frame, length: from the likeliest point on the ray to the object point
    cv::Matx33d objectCovariance;  //!< S = R Sigma R^T + depth^2 Gamma, camera frame, length^2
    double reach;                  //!< squared radius of the ellipse that should hold 95 %, in these covariances
    bool inside;                   //!< the observed pixel is inside the 95 % ellipse of the predicted one
};

/** Squared radius, in two dimensions, of the ellipse that holds 95 % where a share of the points has the wider noise of
cv::gmlpnp::Result::tailShare; of the normal distribution for none. */
double squaredRadiusOf95Percent(double tailShare);

/** The residuals of all points that the camera sees from the estimated pose. */
std::vector<Residual> residualsOf(const cv::gmlpnp::CameraModel& camera, const CorrespondenceSet& set,
                                  const cv::gmlpnp::Result& result);

//! With the camera of the set itself.
std::vector<Residual> residualsOf(const CorrespondenceSet& set, const cv::gmlpnp::Result& result);

/** One row a residual with its covariances, for samples/python/draw.py. Lengths are in the file's unit; the head tells
it, the size of the picture and the squared radius of the 95 % ellipses.
@throws std::runtime_error where the file cannot be written. */
void writeResiduals(const std::string& path, const CorrespondenceSet& set, const std::vector<Residual>& residuals,
                    const std::string& method);

/** A lens where the pixels are: how many pixels an angle covers differs over the picture. */
struct PixelScale
{
    cv::Matx22d bearingNoise;      //!< Gamma in the picture, px^2
    double pixelsPerRadian = 0.0;  //!< of area, so the geometric mean of both directions
};

/** The mean over the pixels that have a ray, by the derivative of the ray with respect to the pixel. */
PixelScale meanPixelScale(const cv::gmlpnp::CameraModel& camera, const std::vector<cv::Point2d>& pixels,
                          const cv::Matx33d& Gamma);

//! Of the points along their rays; zero without residuals.
double meanDepth(const std::vector<Residual>& residuals);

}  // namespace samples

#endif  // GMLPNP_SAMPLES_RESIDUALS_HPP
