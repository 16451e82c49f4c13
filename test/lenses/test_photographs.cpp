// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include <opencv2/gmlpnp.hpp>
#include <opencv2/imgcodecs.hpp>

#include "common/images.hpp"
#include "common/kitti360.hpp"
#include "common/lidar_tracking.hpp"
#include "common/resampling.hpp"
#include "test_data.hpp"

// One street through two lenses: a photograph as it is, and resampled into a fisheye camera that looks aside, so that
// a part of the picture lies more than 90 degrees off its axis. LiDAR points of one frame are tracked into the next;
// the motion must come out the same.

namespace {

using samples::Pose;

const std::string kRoot = "kitti360", kDrive = "2013_05_28_drive_0003_sync";
constexpr int kFirstFrame = 3000, kLastFrame = 3012;
constexpr double kSidewards = 45 * CV_PI / 180;  // rad, of the fisheye camera: the picture ends at 96 degrees
constexpr int kMargin = 16;                      // px from the border of the photograph
constexpr int kFrameStep = 3;                    // every third pair of photographs
constexpr double kOutlier = 4e-3;                // rad, 2 px in the middle of the photograph

//! 99.73 % (3 sigma) of chi-squared with 6 degrees of freedom.
constexpr double kChi2 = 20.06;
//! What the LiDAR's motion is good for; its points are not corrected for the motion during a turn either.
constexpr double kTruthDegrees = 0.3, kTruthMetres = 0.03;

//! A camera and what it sees of the photographs.
struct View
{
    samples::KittiCamera camera;
    cv::Matx33d R = cv::Matx33d::eye();  // X_view = R X_photograph
    std::shared_ptr<samples::Resampling> resampling;
    cv::Mat mask;

    cv::Mat operator()(const cv::Mat& photograph) const { return resampling ? (*resampling)(photograph) : photograph; }
};

View photographView(const std::string& root)
{
    View view;
    view.camera = samples::readKittiCamera(root, "00");
    view.mask = samples::seenPixels(*view.camera.lens, view.camera.size, 180, kMargin);
    return view;
}

View fisheyeView(const std::string& root, const std::string& name)
{
    const samples::KittiCamera photograph = samples::readKittiCamera(root, "00");
    View view;
    view.camera = samples::readKittiCamera(root, name);
    cv::Rodrigues(cv::Vec3d(0, kSidewards, 0), view.R);
    view.resampling = std::make_shared<samples::Resampling>(*photograph.lens, photograph.size, *view.camera.lens,
                                                            view.camera.size, view.R);
    view.mask = samples::shrunkMask(view.resampling->mask(), kMargin);
    return view;
}

//! Points of the photograph's camera, tracked in the view.
samples::Tracks track(const View& view, const std::vector<cv::Point3d>& points, const cv::Mat& first,
                      const cv::Mat& second)
{
    std::vector<cv::Point3d> turned;
    for (const cv::Point3d& point : points)
        turned.emplace_back(view.R * cv::Vec3d(point));
    samples::Tracks tracks =
        samples::trackPoints(turned, {view(first), view(second)}, *view.camera.lens, view.mask, {});
    for (cv::Point3d& point : tracks.points)
        point = view.R.t() * cv::Vec3d(point);
    return tracks;
}

//! Without the points whose ray is off by more than kOutlier from the pose: the noise of the rest can be estimated.
samples::Tracks inliers(const View& view, const samples::Tracks& tracks, const cv::gmlpnp::Result& result)
{
    const Pose pose = samples::poseFromRotationVector(result.rvec, result.tvec);
    samples::Tracks kept;
    for (size_t i = 0; i < tracks.points.size(); ++i) {
        cv::Vec3d ray;
        const cv::Vec3d X = cv::normalize(pose * cv::Vec3d(tracks.points[i]));
        if (view.camera.lens->unprojectPoint(tracks.pixels[i], ray) && cv::norm(X - ray) < kOutlier) {
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

Motion motionOf(const View& view, const samples::Tracks& tracks)
{
    cv::gmlpnp::Result result;
    samples::Tracks used = tracks;
    EXPECT_TRUE(cv::gmlpnp::solve(used.points, used.pixels, view.camera.lens, result));
    for (int round = 0; round < 5; ++round) {
        used = inliers(view, tracks, result);
        EXPECT_TRUE(cv::gmlpnp::solve(used.points, used.pixels, view.camera.lens, result));
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
int beyondRightAngle(const View& view, const samples::Tracks& tracks)
{
    cv::Mat rays;
    view.camera.lens->unproject(tracks.pixels, rays);
    return cv::countNonZero(rays.col(2) < 0);
}

class Photographs : public testing::TestWithParam<const char*>
{};

TEST_P(Photographs, giveTheSameMotionThroughAFisheyeLens)
{
    const std::string motionFile = opencv_test::dataFile(kRoot + "/pseudo_velo_motion.txt");
    if (motionFile.empty())
        GTEST_SKIP() << opencv_test::kNoData;
    const std::string root = motionFile.substr(0, motionFile.find_last_of('/'));
    const samples::KittiTruth truth{{}, samples::readKittiPoses(motionFile)};
    const View pinhole = photographView(root), fisheye = fisheyeView(root, GetParam());
    const auto photograph = [&](int frame) {
        return samples::readImage(samples::kittiPicture(root, kDrive, pinhole.camera, frame), cv::IMREAD_GRAYSCALE);
    };
    int beyond = 0;
    for (int frame = kFirstFrame; frame < kLastFrame; frame += kFrameStep) {
        SCOPED_TRACE(testing::Message() << "frame " << frame);
        const cv::Mat first = photograph(frame), second = photograph(frame + 1);
        const auto scan = samples::readScan(samples::kittiScan(root, kDrive, frame), pinhole.camera);
        const auto points = samples::trackablePoints(scan, first, *pinhole.camera.lens, pinhole.mask, {});
        const samples::Tracks tracks = track(pinhole, points, first, second);
        const samples::Tracks fisheyeTracks = track(fisheye, points, first, second);
        Pose trueMotion;
        ASSERT_TRUE(samples::trueMotion(truth, pinhole.camera, frame, frame + 1, trueMotion));
        const Motion a = motionOf(pinhole, tracks), b = motionOf(fisheye, fisheyeTracks);
        EXPECT_GT(std::min(a.points, b.points), 200u);
        EXPECT_LT(squaredDistance(a, b), kChi2);
        for (const Motion& motion : {a, b}) {
            EXPECT_LT(samples::rotationErrorDegrees(motion.pose, trueMotion), kTruthDegrees);
            EXPECT_LT(samples::positionError(motion.pose, trueMotion), kTruthMetres);
        }
        beyond += beyondRightAngle(fisheye, fisheyeTracks);
    }
    EXPECT_GT(beyond, 0);
}

INSTANTIATE_TEST_SUITE_P(Cameras, Photographs, testing::Values("02", "03"));

}  // namespace
