// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_SAMPLES_CORRESPONDENCES_HPP
#define GMLPNP_SAMPLES_CORRESPONDENCES_HPP

#include <stdexcept>
#include <string>
#include <vector>

#include <opencv2/gmlpnp/camera.hpp>

#include "common/pose.hpp"

namespace samples {

/** Object points, their pixels, and what is known about the camera that saw them.

The file, one format for all tools, is text: first words after `#` that mean something, then a row per point.

    # fx fy cx cy 517.3 516.5 318.6 255.3        required, where the camera is not given otherwise
    # dist 0.2624 -0.9531 -0.0054 0.0026 1.1633  0, 4, 5, 8, 12 or 14 coefficients, as in cv::projectPoints
    # image_size 640 480                         px
    # unit m                                     of the object points
    # true_rvec 0.1 0.2 0.3                      truth, object to camera: X = R p + t
    # true_tvec 1 2 3
    # true_camera_centre 1 2 3                   or the camera in the object frame
    # true_R_world_from_camera 1 0 0 0 1 0 0 0 1 (9 numbers, row-major)
    # source where the data come from            any number of lines
    X Y Z u v

Every other line that starts with `#` is a comment. */
struct CorrespondenceSet
{
    std::string path;
    cv::Matx33d cameraMatrix = cv::Matx33d::eye();
    std::vector<double> distCoeffs;
    cv::Ptr<cv::gmlpnp::CameraModel> lens;  //!< null: the pinhole of the two above. No file carries it
    cv::Size imageSize;                     //!< empty where the file does not say
    std::string unit;                       //!< empty where the file does not say
    bool hasTruth = false;
    Pose truth;
    std::vector<std::string> source;
    std::vector<cv::Point3d> objectPoints;
    std::vector<cv::Point2d> imagePoints;

    //! The file's name without folder and extension.
    std::string name() const;

    //! `lens`, or the pinhole.
    cv::Ptr<cv::gmlpnp::CameraModel> camera() const;
};

/** The points relative to their centroid: with map coordinates of 1e6 m OpenCV's ITERATIVE is off by kilometres, and
its RANSAC computes in single precision. */
std::vector<cv::Point3d> centred(std::vector<cv::Point3d> points, cv::Point3d& centroid);

//! The fewest rows that a pose can be computed from.
constexpr size_t kMinCorrespondences = 4;

//! Where the camera of a set stands.
enum class CameraIn
{
    kFile,      //!< in the correspondence file
    kElsewhere  //!< in a calibration file: what the correspondence file says of it is ignored
};

/** Two pictures that give too few correspondences for a pose: no fault of a file. */
struct TooFewMatches : std::runtime_error
{
    using std::runtime_error::runtime_error;
};

/** @throws TooFewMatches naming the two pictures where fewer than kMinCorrespondences are left. */
void requireMatches(const CorrespondenceSet& set, const std::string& first, const std::string& second);

/** Reads a file. @throws std::runtime_error with "file:line: what is wrong" for anything malformed. */
CorrespondenceSet readCorrespondences(const std::string& path, CameraIn camera = CameraIn::kFile);

/** Writes a file that readCorrespondences() reads back. @throws std::runtime_error where it cannot be written. */
void writeCorrespondences(const std::string& path, const CorrespondenceSet& set);

}  // namespace samples

#endif  // GMLPNP_SAMPLES_CORRESPONDENCES_HPP
