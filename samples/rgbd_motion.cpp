// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

// The motion of an RGB-D camera by all solvers, on sequences of the TUM RGB-D benchmark: pairs of images a fixed time
// apart, matched by ORB, the first lifted to 3D by its depth image, against the motion capture.

#include <iostream>
#include <stdexcept>

#include "common/feature_matching.hpp"
#include "common/study.hpp"

namespace {

using namespace samples;

const char* const kKeys =
    "{help h usage ? |      | print this help}"
    "{@sequences     |      | folders of TUM RGB-D sequences, one or more: rgb.txt, depth.txt, groundtruth.txt, images}"
    "{interval       | 0.1  | time between the two images of a pair, s}"
    "{features       | 1000 | ORB features per image}"
    "{ransac         | 3    | threshold of the rejection of wrong matches, px; 0: keep every match}"
    "{camera         |      | fx fy cx cy, px; default: the benchmark's, by freiburg1, 2 or 3 in the folder's name}"
    "{distortion     |      | k1 k2 p1 p2 k3, with --camera; default: none}";

//! A pair of images with the sequence it belongs to.
struct Job
{
    size_t sequence;
    FramePair pair;
};

MatchingOptions matchingOptions(const Arguments& arguments, const std::string& sequence)
{
    MatchingOptions options;
    options.features = arguments.get<int>("features");
    options.ransacPixels = arguments.get<double>("ransac");
    options.seed = arguments.get<int>("seed");
    if (options.features < 1 || !(options.ransacPixels >= 0.0))
        throw std::runtime_error("--features must be positive and --ransac not negative");
    if (arguments.options.has("camera")) {
        options.cameraMatrix = cameraMatrixOf(arguments);
        options.distCoeffs = arguments.numbers("distortion");
        return options;
    }
    TumCalibration calibration;
    if (!tumCalibration(sequence, calibration))
        throw std::runtime_error(sequence + ": the name tells no camera of the benchmark; give --camera");
    options.cameraMatrix = calibration.cameraMatrix;
    options.distCoeffs = calibration.distCoeffs;
    return options;
}

int run(const Arguments& arguments)
{
    const StudyOptions options = studyOptions(arguments);
    const double interval = arguments.get<double>("interval");
    if (!(interval > 0.0))
        throw std::runtime_error("--interval must be positive");
    std::vector<TumSequence> sequences;
    std::vector<MatchingOptions> matching;
    std::vector<Job> jobs;
    Study study;
    for (const std::string& folder : arguments.files) {
        sequences.push_back(readTumSequence(folder));
        const TumSequence& sequence = sequences.back();
        matching.push_back(matchingOptions(arguments, sequence.name));
        study.title += (study.title.empty() ? "" : ", ") + sequence.name;
        const size_t before = jobs.size();
        for (const FramePair& pair : pairsOf(sequence, interval)) {
            jobs.push_back({sequences.size() - 1, pair});
            study.pairs.push_back(sequence.name + cv::format("_%.6f", sequence.frames[pair.first].time));
        }
        if (jobs.size() == before)
            throw std::runtime_error(folder + ": no two frames with ground truth are that far apart");
    }
    study.correspondences = [&](size_t i) {
        const size_t s = jobs[i].sequence;
        return matchFrames(sequences[s], jobs[i].pair, matching[s]);
    };
    measureMotion(study);
    return runStudy(study, options);
}

}  // namespace

int main(int argc, char** argv)
{
    return runProgram(argc, argv, std::string(kKeys) + kStudyKeys, "The motion of an RGB-D camera by all solvers.\n", 1,
                      run);
}
