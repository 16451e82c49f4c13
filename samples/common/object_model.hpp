// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_SAMPLES_OBJECT_MODEL_HPP
#define GMLPNP_SAMPLES_OBJECT_MODEL_HPP

#include <string>
#include <vector>

#include <opencv2/core.hpp>

namespace samples {

/** The object of OpenCV's real_time_pose_estimation. */
struct ObjectModel
{
    std::vector<cv::Point3d> points;   //!< cm
    cv::Mat descriptors;               //!< of ORB, one row a point
    std::vector<cv::Point3d> corners;  //!< of the mesh, cm
};

/** Reads `folder`/cookies_ORB.yml and the vertices of `folder`/box.ply, which is text.
@throws std::runtime_error naming the file that cannot be used. */
ObjectModel readObjectModel(const std::string& folder);

}  // namespace samples

#endif  // GMLPNP_SAMPLES_OBJECT_MODEL_HPP
