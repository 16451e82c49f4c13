// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_SAMPLES_TUM_RGBD_HPP
#define GMLPNP_SAMPLES_TUM_RGBD_HPP

#include <string>
#include <vector>

#include "common/pose.hpp"

namespace samples {

/** A colour image with its registered depth image. */
struct RgbdFrame
{
    double time = 0.0;  //!< of the colour image, s
    std::string colourFile, depthFile;
};

/** The camera in the world at one moment. */
struct TimedPose
{
    double time = 0.0;     //!< s
    cv::Vec3d centre;      //!< m
    cv::Vec4d quaternion;  //!< x y z w, world from camera, unit length
};

/** A sequence of the TUM RGB-D benchmark in its own layout: rgb.txt and depth.txt name the images by time stamp,
groundtruth.txt holds `timestamp tx ty tz qx qy qz qw`, the pose of the colour camera in the world. */
struct TumSequence
{
    std::string name;  //!< of the folder
    std::vector<RgbdFrame> frames;
    std::vector<TimedPose> groundTruth;
};

/** Two frames, by index, the second one interval after the first, and the motion between them. */
struct FramePair
{
    size_t first = 0, second = 0;
    Pose secondFromFirst;
};

//! Colour and depth images of one frame are at most this far apart in time, s; so are partners of a pair from their
//! interval.
constexpr double kAssociationTolerance = 0.02;

//! The depth images' unit: 5000 is one metre.
constexpr double kDepthUnitsPerMetre = 5000.0;

/** The benchmark's calibration of the colour camera. */
struct TumCalibration
{
    cv::Matx33d cameraMatrix;
    std::vector<double> distCoeffs;
};

/** The calibration of the camera that a sequence's name tells: its first "freiburg" or "fr" followed by 1, 2 or 3.
@return false where it tells none. */
bool tumCalibration(const std::string& sequence, TumCalibration& calibration);

/** Reads the lists of a sequence. @throws std::runtime_error naming the file and line that cannot be used. */
TumSequence readTumSequence(const std::string& folder);

/** The pose of the camera at a time between two ground-truth samples: the centre linearly, the rotation on the great
arc. @return false outside of the recorded time and in gaps longer than 0.1 s. */
bool interpolate(const std::vector<TimedPose>& groundTruth, double time, Pose& cameraFromWorld);

/** Pairs of frames `interval` seconds apart that have ground truth, in the order of time. */
std::vector<FramePair> pairsOf(const TumSequence& sequence, double interval);

/** Reads a depth image, CV_16UC1. @throws std::runtime_error naming the file that is none. */
cv::Mat readDepthImage(const std::string& path);

/** The depth image's value at a pixel in metres; zero where nothing was measured or outside of the image. */
double depthAt(const cv::Mat& depth, const cv::Point2f& pixel);

}  // namespace samples

#endif  // GMLPNP_SAMPLES_TUM_RGBD_HPP
