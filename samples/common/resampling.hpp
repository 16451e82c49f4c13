// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_SAMPLES_RESAMPLING_HPP
#define GMLPNP_SAMPLES_RESAMPLING_HPP

#include <opencv2/gmlpnp/camera.hpp>

namespace samples {

/** What one camera sees through another at the same place: photographs as a lens would have taken them of which there
are none. */
class Resampling
{
public:
    //! `targetFromSource` turns directions of the source's frame into the target's.
    Resampling(const cv::gmlpnp::CameraModel& source, cv::Size sourceSize, const cv::gmlpnp::CameraModel& target,
               cv::Size targetSize, const cv::Matx33d& targetFromSource);

    //! A photograph of the source's size as the target sees it, black where the source does not see.
    cv::Mat operator()(const cv::Mat& photograph) const;

    //! 8 bits: 255 where all of the pixel is seen by the source.
    const cv::Mat& mask() const { return mask_; }

private:
    cv::Mat map_;  //!< for each pixel of the enlarged picture its place in the photograph
    cv::Mat mask_;
};

}  // namespace samples

#endif  // GMLPNP_SAMPLES_RESAMPLING_HPP
