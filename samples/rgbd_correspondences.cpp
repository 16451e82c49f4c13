// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

// Turns a sequence of the TUM RGB-D benchmark into correspondence files: pairs of images a fixed time apart, matched
// by ORB, the first lifted to 3D by its depth image, with the true motion between the two in the header.

#include <iostream>
#include <stdexcept>

#include <opencv2/core/version.hpp>

#include "common/command_line.hpp"
#include "common/feature_matching.hpp"

namespace {

using namespace samples;

const char* const kKeys =
    "{help h usage ? |     | print this help}"
    "{@sequence      |     | folder of a TUM RGB-D sequence: rgb.txt, depth.txt, groundtruth.txt and the images}"
    "{@output        |     | folder for the correspondence files; it must exist}"
    "{interval       | 0.1 | time between the two images of a pair, s}"
    "{pairs          | 0   | how many pairs, evenly spaced through the sequence; 0: all}"
    "{name           |     | name of the sequence in headers and file names; default: the folder's}"
    "{features       | 1000 | ORB features per image}"
    "{ransac         | 3   | inlier threshold of cv::solvePnPRansac, px; 0: keep every match}"
    "{camera         | 517.3 516.5 318.6 255.3 | fx fy cx cy, px; default: freiburg1}"
    "{distortion     | 0.2624 -0.9531 -0.0054 0.0026 1.1633 | k1 k2 p1 p2 k3; default: freiburg1}"
    "{source         | TUM RGB-D benchmark, TUM Computer Vision Group, CC BY 4.0; Sturm et al., A Benchmark for the "
    "Evaluation of RGB-D SLAM Systems, IROS 2012 | attribution for the files' headers}";

MatchingOptions matchingOptions(const Arguments& arguments)
{
    MatchingOptions options;
    options.cameraMatrix = cameraMatrixOf(arguments);
    options.distCoeffs = arguments.numbers("distortion");
    options.features = arguments.get<int>("features");
    options.ransacPixels = arguments.get<double>("ransac");
    if (options.features < 1 || !(options.ransacPixels >= 0.0))
        throw std::runtime_error("--features must be positive and --ransac not negative");
    return options;
}

//! `count` of the pairs, the first of each of `count` equal stretches of the sequence; 0: all.
std::vector<FramePair> evenlySpaced(const std::vector<FramePair>& pairs, size_t count)
{
    if (count == 0 || count >= pairs.size())
        return pairs;
    std::vector<FramePair> chosen;
    for (size_t i = 0; i < count; ++i)
        chosen.push_back(pairs[i * pairs.size() / count]);
    return chosen;
}

std::vector<std::string> sourceLines(const TumSequence& sequence, const FramePair& pair, const MatchingOptions& options,
                                     const std::string& attribution)
{
    const RgbdFrame &first = sequence.frames[pair.first], &second = sequence.frames[pair.second];
    const std::string rejection =
        options.ransacPixels > 0.0
            ? cv::format("cv::solvePnPRansac (EPnP, %g px) on the lifted points", options.ransacPixels)
            : std::string("no outlier rejection");
    return {
        attribution + ".",
        "Sequence " + sequence.name +
            cv::format(", colour images %.6f (points) and %.6f (pixels).", first.time, second.time),
        "Changed: correspondences derived from the images, which are not contained. " +
            std::to_string(options.features) + " ORB features per image,",
        "brute-force Hamming matches with cross-check, " + rejection + "; OpenCV " CV_VERSION ".",
        "Points: features of the first image lifted to its camera frame by its depth image and the intrinsics below.",
        "Truth: motion capture, interpolated to the time stamps of the two colour images.",
    };
}

int run(const Arguments& arguments)
{
    const MatchingOptions options = matchingOptions(arguments);
    const int count = arguments.get<int>("pairs");
    const double interval = arguments.get<double>("interval");
    if (count < 0 || !(interval > 0.0))
        throw std::runtime_error("--pairs must not be negative and --interval must be positive");
    TumSequence sequence = readTumSequence(arguments.files[0]);
    if (arguments.options.has("name"))
        sequence.name = arguments.get<std::string>("name");
    const std::vector<FramePair> pairs = evenlySpaced(pairsOf(sequence, interval), static_cast<size_t>(count));
    if (pairs.empty())
        throw std::runtime_error(arguments.files[0] + ": no two frames with ground truth are that far apart");
    for (size_t i = 0; i < pairs.size(); ++i) {
        CorrespondenceSet set = matchFrames(sequence, pairs[i], options);
        set.source = sourceLines(sequence, pairs[i], options, arguments.get<std::string>("source"));
        const double time = sequence.frames[pairs[i].first].time;
        const std::string path = arguments.files[1] + cv::format("/%s_%.3f.txt", sequence.name.c_str(), time);
        writeCorrespondences(path, set);
        std::cout << "[" << i + 1 << "/" << pairs.size() << "] " << path << ": " << set.objectPoints.size()
                  << " correspondences" << std::endl;
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv)
{
    return runProgram(argc, argv, kKeys, "Correspondence files from a TUM RGB-D sequence.\n", 2, run);
}
