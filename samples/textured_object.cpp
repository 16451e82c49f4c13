// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

// A textured box found in every frame of a video: OpenCV's real_time_pose_estimation with our RANSAC, and with how sure
// each pose is. Its data, a video, a model of 5914 points with ORB descriptors and a mesh, come with OpenCV's sources.

#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <opencv2/features2d.hpp>
#include <opencv2/gmlpnp/draw.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#ifdef HAVE_OPENCV_HIGHGUI
#include <opencv2/highgui.hpp>
#endif

#include "common/command_line.hpp"
#include "common/images.hpp"
#include "common/object_model.hpp"
#include "common/output_file.hpp"
#include "common/statistics.hpp"
#include "common/table.hpp"

namespace {

using namespace samples;
using cv::gmlpnp::CameraModel;
using cv::gmlpnp::Result;

const cv::Scalar kBlue(178, 114, 0), kOrange(0, 94, 213), kWhite(255, 255, 255);  // blue, green, red

const char* const kKeys =
    "{help h usage ? |     | print this help}"
    "{@data          |     | folder Data of OpenCV's samples/cpp/tutorial_code/calib3d/real_time_pose_estimation}"
    "{camera         |     | calibration file (kinds: doc/cameras.md); none: that of OpenCV's program}"
    "{features       | 2000 | ORB features per frame}"
    "{ratio          | 0.8 | a match is kept where its distance is below this share of the next best}"
    "{threshold      | 6   | largest reprojection error of an inlier, px}"
    "{frames         | 0   | frames to read; 0: all}"
    "{csv            | textured_object.csv | write the poses to this file}"
    "{video          | textured_object.avi | write the drawn frames to this video}"
    "{picture        |     | write the last frame with a pose as this PNG}"
    "{show           |     | show the frames in a window; any key ends}";

//! 55 mm on a sensor of 22.3 x 14.9 mm, 640 x 480 px: what OpenCV's program takes.
cv::Ptr<CameraModel> cameraOf(const Arguments& arguments)
{
    const std::string path = arguments.get<std::string>("camera");
    if (!path.empty())
        return CameraModel::load(path);
    return CameraModel::pinhole(cv::Matx33d(640 * 55 / 22.3, 0, 320, 0, 480 * 55 / 14.9, 240, 0, 0, 1));
}

// --- One frame ---

struct Correspondences
{
    std::vector<cv::Point3d> objectPoints;
    std::vector<cv::Point2d> imagePoints;
};

class Matcher
{
public:
    Matcher(const ObjectModel& model, int features, float ratio)
        : model_(model), detector_(cv::ORB::create(features)), matcher_(cv::NORM_HAMMING), ratio_(ratio)
    {}

    //! Clearest first, which is where RANSAC then looks first.
    Correspondences match(const cv::Mat& frame)
    {
        std::vector<cv::KeyPoint> keypoints;
        cv::Mat descriptors;
        detector_->detectAndCompute(frame, cv::noArray(), keypoints, descriptors);
        std::vector<std::vector<cv::DMatch>> pairs;
        if (!descriptors.empty())
            matcher_.knnMatch(descriptors, model_.descriptors, pairs, 2);
        const auto ratio = [](const std::vector<cv::DMatch>& pair) { return pair[0].distance / pair[1].distance; };
        const auto unclear = [&](const std::vector<cv::DMatch>& pair) {
            return pair.size() < 2 || !(ratio(pair) < ratio_);
        };
        pairs.erase(std::remove_if(pairs.begin(), pairs.end(), unclear), pairs.end());
        std::stable_sort(pairs.begin(), pairs.end(), [&](const auto& a, const auto& b) { return ratio(a) < ratio(b); });
        Correspondences found;
        for (const auto& pair : pairs) {
            found.objectPoints.push_back(model_.points[static_cast<size_t>(pair[0].trainIdx)]);
            found.imagePoints.push_back(keypoints[static_cast<size_t>(pair[0].queryIdx)].pt);
        }
        return found;
    }

private:
    const ObjectModel& model_;
    cv::Ptr<cv::ORB> detector_;
    cv::BFMatcher matcher_;
    float ratio_;
};

struct FramePose
{
    bool found = false;
    size_t matches = 0;
    std::vector<int> inliers;
    Result result;
    double milliseconds = 0;
};

//! The last pose, where there was one, is the guess: it need not be good.
FramePose solveFrame(const Correspondences& matches, const cv::Ptr<CameraModel>& camera, double threshold,
                     const FramePose& last)
{
    FramePose pose;
    pose.matches = matches.objectPoints.size();
    if (pose.matches < 4)
        return pose;
    cv::gmlpnp::RansacParams ransac;
    ransac.threshold = threshold;
    ransac.ordered = true;
    cv::gmlpnp::Params params;
    params.useExtrinsicGuess = last.found;
    params.rvec = last.result.rvec;
    params.tvec = last.result.tvec;
    cv::TickMeter clock;
    clock.start();
    pose.found = cv::gmlpnp::solveRansac(matches.objectPoints, matches.imagePoints, camera, pose.result, pose.inliers,
                                         ransac, params);
    clock.stop();
    pose.milliseconds = clock.getTimeMilli();
    return pose;
}

//! Largest standard deviation of the camera's centre, the model's unit.
double uncertainty(const FramePose& pose)
{
    cv::Mat eigenvalues;
    if (pose.result.cameraCenterCovariance.empty())
        return 0;
    cv::eigen(pose.result.cameraCenterCovariance, eigenvalues);
    return std::sqrt(eigenvalues.at<double>(0));
}

void draw(cv::Mat& frame, const Correspondences& matches, const ObjectModel& model, const cv::Ptr<CameraModel>& camera,
          const FramePose& pose)
{
    for (const cv::Point2d& pixel : matches.imagePoints)
        cv::circle(frame, pixel, 2, kOrange, -1, cv::LINE_AA);
    if (!pose.found) {
        cv::putText(frame, "no pose", {10, 24}, cv::FONT_HERSHEY_SIMPLEX, 0.6, kOrange, 2, cv::LINE_AA);
        return;
    }
    for (const int i : pose.inliers)
        cv::circle(frame, matches.imagePoints[static_cast<size_t>(i)], 2, kBlue, -1, cv::LINE_AA);
    cv::gmlpnp::drawPoseUncertainty(frame, camera, pose.result, 10, model.corners, 2);
    const std::string text = std::to_string(pose.inliers.size()) + " of " + std::to_string(pose.matches) +
                             " matches; camera +-" + fixed(uncertainty(pose), 2) + " cm";
    cv::putText(frame, text, {10, 24}, cv::FONT_HERSHEY_SIMPLEX, 0.6, kWhite, 2, cv::LINE_AA);
}

// --- Output ---

void writeRow(std::ostream& csv, int frame, const FramePose& pose)
{
    csv << frame << ',' << pose.found << ',' << pose.matches << ',' << pose.inliers.size() << ','
        << fixed(pose.milliseconds, 3);
    for (const cv::Vec3d& v : {pose.result.rvec, pose.result.tvec, pose.result.cameraCenter})
        for (int k = 0; k < 3; ++k)
            csv << ',' << (pose.found ? fixed(v[k], 6) : "");
    csv << ',' << (pose.found ? fixed(uncertainty(pose), 6) : "") << '\n';
}

//! Whether to go on.
bool show(const cv::Mat& frame)
{
#ifdef HAVE_OPENCV_HIGHGUI
    cv::imshow("textured_object", frame);
    return cv::waitKey(1) < 0;
#else
    (void)frame;
    throw std::runtime_error("--show: this program was built without opencv_highgui");
#endif
}

// cv::VideoWriter does not say whether the disk was full, so the video is looked at.
void finish(cv::VideoWriter& video, files::PartialFile& file, int frames)
{
    video.release();
    if (cv::VideoCapture(file.path()).get(cv::CAP_PROP_FRAME_COUNT) != frames)
        file.fail();
    file.commit();
}

struct Summary
{
    int frames = 0, found = 0;
    std::vector<double> milliseconds, inliers;

    void add(const FramePose& pose)
    {
        ++frames;
        found += pose.found;
        milliseconds.push_back(pose.milliseconds);
        if (pose.found)
            inliers.push_back(static_cast<double>(pose.inliers.size()));
    }
};

int run(const Arguments& arguments)
{
    const ObjectModel model = readObjectModel(arguments.files[0]);
    const cv::Ptr<CameraModel> camera = cameraOf(arguments);
    Matcher matcher(model, arguments.get<int>("features"), arguments.get<float>("ratio"));
    const double threshold = arguments.get<double>("threshold");
    const std::string input = arguments.files[0] + "/box.mp4", csvPath = arguments.get<std::string>("csv"),
                      videoPath = arguments.get<std::string>("video"), picture = arguments.get<std::string>("picture");
    const int limit = arguments.get<int>("frames");
    const bool shown = arguments.options.has("show");
    cv::VideoCapture video(input);
    if (!video.isOpened())
        throw std::runtime_error(input + ": cannot be opened as a video");
    files::OutputFile csv(csvPath);
    csv.stream() << "frame,found,matches,inliers,ms,rx,ry,rz,tx_cm,ty_cm,tz_cm,cx_cm,cy_cm,cz_cm,camera_sd_cm\n";

    std::optional<files::PartialFile> videoFile;
    cv::VideoWriter out;
    cv::Mat frame, best;
    FramePose last;
    Summary summary;
    for (int i = 0; (limit == 0 || i < limit) && video.read(frame); ++i) {
        const Correspondences matches = matcher.match(frame);
        last = solveFrame(matches, camera, threshold, last);
        summary.add(last);
        writeRow(csv.stream(), i, last);
        draw(frame, matches, model, camera, last);
        if (i == 0 && !videoPath.empty()) {
            videoFile.emplace(videoPath);
            if (!out.open(videoFile->path(), cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 30, frame.size()))
                videoFile->fail();
        }
        if (out.isOpened())
            out.write(frame);
        if (last.found)
            frame.copyTo(best);
        if (shown && !show(frame))
            break;
        if (i % 50 == 49)
            std::cerr << "frame " << i + 1 << ", " << summary.found << " poses" << std::endl;
    }
    if (summary.frames == 0)
        throw std::runtime_error(input + ": has no frame");
    csv.commit();
    if (videoFile)
        finish(out, *videoFile, summary.frames);
    if (!picture.empty() && !best.empty())
        writeImage(picture, best);
    std::cout << summary.found << " poses in " << summary.frames
              << " frames; medians: " << (summary.found > 0 ? median(summary.inliers) : 0) << " inliers, "
              << fixed(median(summary.milliseconds), 2) << " ms for a pose\n"
              << "Poses: " << csvPath << (videoPath.empty() ? "" : "; video: " + videoPath) << "\n";
    return 0;
}

}  // namespace

int main(int argc, char** argv)
{
    return runProgram(argc, argv, kKeys,
                      "Tracks OpenCV's textured box through its video, with the uncertainty drawn.\n", 1, run);
}
