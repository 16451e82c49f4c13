// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

// The motion of a vehicle's camera by all solvers that can serve its lens, on KITTI-360: LiDAR points are projected
// into one picture through the camera model and tracked into a later one.

#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>

#include <opencv2/gmlpnp/compat.hpp>
#include <opencv2/imgcodecs.hpp>

#include "common/images.hpp"
#include "common/kitti360.hpp"
#include "common/lidar_tracking.hpp"
#include "common/outliers.hpp"
#include "common/resampling.hpp"
#include "common/study.hpp"

namespace {

using namespace samples;

const char* const kKeys =
    "{help h usage ? |     | print this help}"
    "{@root          |     | folder of KITTI-360: calibration, data_2d_raw, data_3d_raw, data_poses}"
    "{@drives        |     | drives, such as 2013_05_28_drive_0003_sync; default: all of data_2d_raw}"
    "{camera         | 00  | 00 or 01, rectified pinholes, 02 or 03, fisheyes}"
    "{step           | 3   | frames from the first picture of a pair to the second}"
    "{chain          |     | track through the pictures between the two of a pair instead of from one to the other}"
    "{every          | 1   | frames from one pair to the next}"
    "{motion         |     | true motion of the LiDAR from frame to frame instead of data_poses (one drive): rows of "
    "the "
    "frame k and the 3x4 pose of frame k+1 in frame k}"
    "{field          | 180 | only points within this full angle about the axis, degrees}"
    "{margin         | 16  | only points more than this inside of the picture, px}"
    "{there_and_back | 0.3 | tracked forward and backward a point ends at most this far from where it began, px}"
    "{ransac         | 3   | threshold of the rejection of wrong tracks, px; 0: keep every track}"
    "{through        |     | resample the pinhole's pictures into this fisheye, 02 or 03}"
    "{aside          | 45  | with --through: how far that one looks to the side, degrees}";

struct Options
{
    TrackingOptions tracking;
    int step, every, margin, seed;
    bool chain;
    double field, ransacPixels;
};

Options optionsOf(const Arguments& arguments)
{
    Options options;
    options.step = arguments.get<int>("step");
    options.every = arguments.get<int>("every");
    options.margin = arguments.get<int>("margin");
    options.seed = arguments.get<int>("seed");
    options.chain = arguments.options.has("chain");
    options.field = arguments.get<double>("field");
    options.ransacPixels = arguments.get<double>("ransac");
    options.tracking.thereAndBack = arguments.get<double>("there_and_back");
    if (options.step < 1 || options.every < 1 || options.margin < 0)
        throw std::runtime_error("--step and --every must be positive and --margin not negative");
    if (!(options.field > 0.0 && options.field <= 360.0) || !(options.ransacPixels >= 0.0) ||
        !(options.tracking.thereAndBack > 0.0))
        throw std::runtime_error("--field must be in (0, 360], --there_and_back positive and --ransac not negative");
    return options;
}

/** Pictures of a camera, or of another as it would see them. */
struct Eye
{
    KittiCamera source, camera;  //!< whose pictures are read, and the one that is used
    std::unique_ptr<Resampling> resampling;
    cv::Mat mask;

    cv::Mat picture(const std::string& root, const std::string& drive, int frame) const
    {
        const std::string path = kittiPicture(root, drive, source, frame);
        const cv::Mat picture = readImage(path, cv::IMREAD_GRAYSCALE);
        if (picture.size() != source.size)
            throw std::runtime_error(path + cv::format(": %d x %d px, but its calibration is for %d x %d", picture.cols,
                                                       picture.rows, source.size.width, source.size.height));
        return resampling ? (*resampling)(picture) : picture;
    }
};

Eye eyeOf(const Arguments& arguments, const std::string& root, const Options& options)
{
    Eye eye;
    eye.source = eye.camera = readKittiCamera(root, arguments.get<std::string>("camera"));
    const std::string through = arguments.get<std::string>("through");
    if (!through.empty()) {
        const KittiCamera fisheye = readKittiCamera(root, through);
        if (!eye.source.isPinhole || fisheye.isPinhole)
            throw std::runtime_error("--through: pictures of a pinhole are resampled into a fisheye, 02 or 03");
        cv::Matx33d turn;
        cv::Rodrigues(cv::Vec3d(0.0, arguments.get<double>("aside") * CV_PI / 180.0, 0.0), turn);
        eye.camera = turnedCamera(eye.source, fisheye, turn);
        eye.resampling =
            std::make_unique<Resampling>(*eye.source.lens, eye.source.size, *eye.camera.lens, eye.camera.size, turn);
    }
    eye.mask = seenPixels(*eye.camera.lens, eye.camera.size, options.field, options.margin);
    if (eye.resampling)
        eye.mask &= shrunkMask(eye.resampling->mask(), options.margin);
    if (cv::countNonZero(eye.mask) == 0)
        throw std::runtime_error("--field, --margin or --aside leave nothing of the picture");
    return eye;
}

//! A pair of frames and the true motion between them.
struct Job
{
    std::string drive;
    int first, second;
    Pose secondFromFirst;
};

KittiTruth truthOf(const Arguments& arguments, const std::string& root, const std::string& drive)
{
    const std::string motion = arguments.get<std::string>("motion");
    if (!motion.empty())
        return {{}, readKittiPoses(motion)};
    const std::string poses = root + "/data_poses/" + drive + "/poses.txt";
    if (!std::filesystem::exists(poses))
        throw std::runtime_error(poses + ": no true poses; give them there or by --motion");
    return {readKittiPoses(poses), {}};
}

std::vector<Job> jobsOf(const Arguments& arguments, const std::string& root, const Eye& eye, const Options& options)
{
    std::vector<std::string> drives(arguments.files.begin() + 1, arguments.files.end());
    if (drives.empty())
        drives = kittiDrives(root);
    if (drives.size() > 1 && arguments.options.has("motion"))
        throw std::runtime_error("--motion: the motion of one drive, but there are " + std::to_string(drives.size()));
    std::vector<Job> jobs;
    for (const std::string& drive : drives) {
        const KittiTruth truth = truthOf(arguments, root, drive);
        int next = 0;
        for (const int frame : kittiFrames(root, drive)) {
            Job job{drive, frame, frame + options.step, {}};
            if (frame < next || !std::filesystem::exists(kittiPicture(root, drive, eye.source, frame)) ||
                !std::filesystem::exists(kittiPicture(root, drive, eye.source, job.second)) ||
                !trueMotion(truth, eye.camera, frame, job.second, job.secondFromFirst))
                continue;
            jobs.push_back(job);
            next = frame + options.every;
        }
    }
    if (jobs.empty())
        throw std::runtime_error(root + ": no two pictures of camera " + eye.source.name +
                                 " with a LiDAR scan and true poses are that far apart");
    return jobs;
}

CorrespondenceSet correspondencesOf(const std::string& root, const Job& job, const Eye& eye, const Options& options)
{
    std::vector<cv::Mat> pictures;
    for (int frame = job.first; frame <= job.second; frame += options.chain ? 1 : options.step)
        pictures.push_back(eye.picture(root, job.drive, frame));
    const auto scan = readScan(kittiScan(root, job.drive, job.first), eye.camera);
    const auto points = trackablePoints(scan, pictures[0], *eye.camera.lens, eye.mask, options.tracking);
    const Tracks tracks = trackPoints(points, pictures, *eye.camera.lens, eye.mask, options.tracking);
    CorrespondenceSet set;
    set.objectPoints = tracks.points;
    set.imagePoints = tracks.pixels;
    set.cameraMatrix = eye.camera.cameraMatrix;
    if (!eye.camera.isPinhole)
        set.lens = eye.camera.lens;
    set.imageSize = eye.camera.size;
    set.unit = "m";
    set.hasTruth = true;
    set.truth = job.secondFromFirst;
    rejectOutliers(set, options.ransacPixels, options.seed);
    requireMatches(set, kittiPicture(root, job.drive, eye.source, job.first),
                   kittiPicture(root, job.drive, eye.source, job.second));
    return set;
}

int run(const Arguments& arguments)
{
    const StudyOptions studied = studyOptions(arguments);
    const Options options = optionsOf(arguments);
    const std::string& root = arguments.files[0];
    const Eye eye = eyeOf(arguments, root, options);
    const std::vector<Job> jobs = jobsOf(arguments, root, eye, options);
    Study study;
    study.title = "KITTI-360, camera " + eye.source.name + (eye.resampling ? " through " + eye.camera.name : "") +
                  ", " + std::to_string(options.step) + (options.step == 1 ? " frame apart" : " frames apart");
    for (const Job& job : jobs)
        study.pairs.push_back(job.drive + cv::format("_%010d", job.first));
    study.correspondences = [&](size_t i) { return correspondencesOf(root, jobs[i], eye, options); };
    measureMotion(study);
    return runStudy(study, studied);
}

}  // namespace

int main(int argc, char** argv)
{
    return runProgram(argc, argv, std::string(kKeys) + kStudyKeys,
                      "The motion of a vehicle's camera by all solvers that serve its lens.\n", 1, run);
}
