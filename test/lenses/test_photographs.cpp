// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include <gtest/gtest.h>

#include <algorithm>
#include <cfloat>
#include <vector>

#include <opencv2/gmlpnp.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

#include "kitti360.hpp"
#include "test_data.hpp"

// One street through two lenses: a photograph as it is, and resampled into a fisheye camera that looks aside, so that
// a part of the picture lies more than 90 degrees off its axis. LiDAR points of one frame are tracked into the next;
// the motion must come out the same.

namespace {

using cv::gmlpnp::CameraModel;
using samples::Pose;

constexpr double kSidewards = 45 * CV_PI / 180;  // rad, of the fisheye camera: the picture ends at 96 degrees
const cv::Size kFisheyePicture(1400, 1400);
constexpr int kOversampling = 2;         // of the fisheye picture, against aliasing
constexpr int kMargin = 16;              // px from the border of the photograph
constexpr int kCell = 8;                 // px of the photograph: at most one point in each
constexpr double kHidden = 1.3;          // times the depth of the nearest point around: not seen by the camera
constexpr double kLeastContrast = 1e-3;  // smaller eigenvalue of the gradients, as cv::cornerMinEigenVal defines it
constexpr double kThereAndBack = 0.3;    // px, tracking forward and backward
constexpr int kFrameStep = 3;            // every third pair of photographs
constexpr double kOutlier = 4e-3;        // rad, 2 px in the middle of the photograph

//! 99.73 % (3 sigma) of chi-squared with 6 degrees of freedom.
constexpr double kChi2 = 20.06;
//! What the LiDAR's motion is good for; its points are not corrected for the motion during a turn either.
constexpr double kTruthDegrees = 0.3, kTruthMetres = 0.03;

//! A camera and how it is turned against that of the photographs.
struct View
{
    cv::Ptr<CameraModel> camera;
    cv::Matx33d R = cv::Matx33d::eye();  // X_view = R X_photograph
};

View photographView()
{
    return {CameraModel::pinhole(kitti360::cameraMatrix())};
}

View fisheyeView(const std::string& name)
{
    View view{CameraModel::load(kitti360::fisheyeFile(name))};
    cv::Rodrigues(cv::Vec3d(0, kSidewards, 0), view.R);
    return view;
}

cv::Mat turned(const cv::Mat& rows, const cv::Matx33d& R)
{
    return cv::Mat(rows * cv::Mat(R.t()));
}

//! For each pixel of the view's enlarged picture its place in the photograph.
cv::Mat mapOf(const View& view)
{
    const cv::Size size = kFisheyePicture * kOversampling;
    cv::Mat map(size, CV_32FC2);
    cv::Mat_<double> pixels(size.width, 2);
    for (int v = 0; v < size.height; ++v) {
        for (int u = 0; u < size.width; ++u) {
            pixels(u, 0) = (u + 0.5) / kOversampling - 0.5;
            pixels(u, 1) = (v + 0.5) / kOversampling - 0.5;
        }
        cv::Mat rays, hasRay, source, isSeen;
        view.camera->unproject(pixels, rays, hasRay);
        photographView().camera->project(turned(rays, view.R.t()), source, isSeen);
        source.setTo(-1e4, cv::repeat(~(hasRay & isSeen), 1, 2));
        source.reshape(2, 1).convertTo(map.row(v), CV_32F);
    }
    return map;
}

cv::Mat resampled(const cv::Mat& photograph, const cv::Mat& map)
{
    cv::Mat large, picture;
    cv::remap(photograph, large, map, cv::noArray(), cv::INTER_CUBIC);
    cv::resize(large, picture, cv::Size(), 1. / kOversampling, 1. / kOversampling, cv::INTER_AREA);
    return picture;
}

bool isInside(const cv::Point2d& pixel, const cv::Size& picture)
{
    return pixel.x > kMargin && pixel.y > kMargin && pixel.x < picture.width - kMargin &&
           pixel.y < picture.height - kMargin;
}

//! LiDAR points that can be tracked: on textured surfaces, seen by the camera, one a cell.
std::vector<cv::Point3d> chosenPoints(const std::vector<cv::Point3d>& points, const cv::Mat& photograph)
{
    const View view = photographView();
    cv::Mat contrast;
    cv::cornerMinEigenVal(photograph, contrast, 9);
    const cv::Size cells(photograph.cols / kCell + 1, photograph.rows / kCell + 1);
    cv::Mat_<float> nearest(cells, FLT_MAX), best(cells, 0.f);
    cv::Mat_<int> chosen(cells, -1);
    for (size_t i = 0; i < points.size(); ++i) {
        cv::Point2d pixel;
        if (!view.camera->projectPoint(points[i], pixel) || !isInside(pixel, photograph.size()))
            continue;
        const cv::Point cell(static_cast<int>(pixel.x) / kCell, static_cast<int>(pixel.y) / kCell);
        const float depth = static_cast<float>(points[i].z), here = contrast.at<float>(cv::Point(pixel));
        nearest(cell) = std::min(nearest(cell), depth);
        if (here > std::max(best(cell), static_cast<float>(kLeastContrast))) {
            best(cell) = here;
            chosen(cell) = static_cast<int>(i);
        }
    }
    cv::erode(nearest, nearest, cv::Mat::ones(3, 3, CV_8U));
    std::vector<cv::Point3d> result;
    for (int y = 0; y < cells.height; ++y)
        for (int x = 0; x < cells.width; ++x)
            if (chosen(y, x) >= 0) {
                const cv::Point3d& point = points[static_cast<size_t>(chosen(y, x))];
                if (point.z < kHidden * nearest(y, x))
                    result.push_back(point);
            }
    return result;
}

struct Tracks
{
    std::vector<cv::Point3d> points;  // frame of the first photograph
    std::vector<cv::Point2d> pixels;  // in the view's second picture
};

Tracks track(const View& view, const std::vector<cv::Point3d>& points, const cv::Mat& first, const cv::Mat& second,
             const cv::Size& photograph)
{
    const cv::Mat inView = turned(cv::Mat(points).reshape(1), view.R);
    cv::Mat projected;
    view.camera->project(inView, projected);
    std::vector<cv::Point2f> start, end, back;
    projected.reshape(2).convertTo(start, CV_32F);
    std::vector<uchar> forward, backward;
    const cv::Size window(21, 21);
    const int levels = 5;
    cv::calcOpticalFlowPyrLK(first, second, start, end, forward, cv::noArray(), window, levels);
    cv::calcOpticalFlowPyrLK(second, first, end, back, backward, cv::noArray(), window, levels);
    Tracks tracks;
    for (size_t i = 0; i < points.size(); ++i) {
        cv::Vec3d ray;
        cv::Point2d source;
        if (!forward[i] || !backward[i] || cv::norm(start[i] - back[i]) > kThereAndBack ||
            !view.camera->unprojectPoint(end[i], ray) ||
            !photographView().camera->projectPoint(view.R.t() * ray, source) || !isInside(source, photograph))
            continue;
        tracks.points.push_back(points[i]);
        tracks.pixels.push_back(end[i]);
    }
    return tracks;
}

//! Without the points whose ray is off by more than kOutlier from the pose: the noise of the rest can be estimated.
Tracks inliers(const View& view, const Tracks& tracks, const cv::gmlpnp::Result& result)
{
    const Pose pose = samples::poseFromRotationVector(result.rvec, result.tvec);
    Tracks kept;
    for (size_t i = 0; i < tracks.points.size(); ++i) {
        cv::Vec3d ray;
        const cv::Vec3d X = cv::normalize(pose * cv::Vec3d(tracks.points[i]));
        if (view.camera->unprojectPoint(tracks.pixels[i], ray) && cv::norm(X - ray) < kOutlier) {
            kept.points.push_back(tracks.points[i]);
            kept.pixels.push_back(tracks.pixels[i]);
        }
    }
    return kept;
}

struct Motion
{
    Pose pose;  // of the photograph's camera, whatever the view
    cv::Matx66d covariance;
    size_t points = 0;
};

Motion motionOf(const View& view, const Tracks& tracks)
{
    cv::gmlpnp::Result result;
    Tracks used = tracks;
    EXPECT_TRUE(cv::gmlpnp::solve(used.points, used.pixels, view.camera, result));
    for (int round = 0; round < 5; ++round) {
        used = inliers(view, tracks, result);
        EXPECT_TRUE(cv::gmlpnp::solve(used.points, used.pixels, view.camera, result));
    }
    const Pose pose = samples::poseFromRotationVector(result.rvec, result.tvec);
    Motion motion{{view.R.t() * pose.R, view.R.t() * pose.t}, cv::Matx66d(), used.points.size()};
    cv::Mat turn = cv::Mat::zeros(6, 6, CV_64F);
    cv::Mat(view.R.t()).copyTo(turn(cv::Rect(0, 0, 3, 3)));
    cv::Mat(view.R.t()).copyTo(turn(cv::Rect(3, 3, 3, 3)));
    motion.covariance = cv::Mat(turn * result.poseCovariance * turn.t());
    return motion;
}

//! Squared Mahalanobis length of the left perturbation from one pose to the other.
double squaredDistance(const Motion& a, const Motion& b)
{
    const cv::Matx33d R = a.pose.R * b.pose.R.t();
    const cv::Vec3d phi = samples::rotationVector(R), delta = a.pose.t - R * b.pose.t;
    const cv::Vec6d xi(phi[0], phi[1], phi[2], delta[0], delta[1], delta[2]);
    cv::Vec6d weighted;
    cv::solve(a.covariance + b.covariance, xi, weighted, cv::DECOMP_CHOLESKY);
    return xi.dot(weighted);
}

//! How many of the pixels lie more than 90 degrees off the axis.
int beyondRightAngle(const View& view, const Tracks& tracks)
{
    cv::Mat rays;
    view.camera->unproject(tracks.pixels, rays);
    return cv::countNonZero(rays.col(2) < 0);
}

class Photographs : public testing::TestWithParam<const char*>
{};

TEST_P(Photographs, GiveTheSameMotionThroughAFisheyeLens)
{
    if (!kitti360::isPresent())
        GTEST_SKIP() << opencv_test::kNoData;
    const View pinhole = photographView(), fisheye = fisheyeView(GetParam());
    const cv::Mat map = mapOf(fisheye);
    int beyond = 0;
    for (int frame = kitti360::kFirstFrame; frame < kitti360::kLastFrame; frame += kFrameStep) {
        SCOPED_TRACE(testing::Message() << "frame " << frame);
        const cv::Mat first = kitti360::photograph(frame), second = kitti360::photograph(frame + 1);
        const std::vector<cv::Point3d> points = chosenPoints(kitti360::lidarPoints(frame), first);
        const Tracks tracks = track(pinhole, points, first, second, first.size());
        const Tracks fisheyeTracks =
            track(fisheye, points, resampled(first, map), resampled(second, map), first.size());
        const Motion a = motionOf(pinhole, tracks), b = motionOf(fisheye, fisheyeTracks);
        EXPECT_GT(std::min(a.points, b.points), 200u);
        EXPECT_LT(squaredDistance(a, b), kChi2);
        for (const Motion& motion : {a, b}) {
            EXPECT_LT(samples::rotationErrorDegrees(motion.pose, kitti360::motion(frame)), kTruthDegrees);
            EXPECT_LT(samples::positionError(motion.pose, kitti360::motion(frame)), kTruthMetres);
        }
        beyond += beyondRightAngle(fisheye, fisheyeTracks);
    }
    EXPECT_GT(beyond, 0);
}

INSTANTIATE_TEST_SUITE_P(Cameras, Photographs, testing::Values("02", "03"));

}  // namespace
