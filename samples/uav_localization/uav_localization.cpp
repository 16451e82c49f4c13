// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

// Where an aerial picture was taken: matched to a georeferenced picture, whose pixels an elevation model lifts to map
// coordinates. The pose by all solvers, its errors where the truth is known, and its 95 % region on the map.

#include <filesystem>
#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>

#include <opencv2/imgcodecs.hpp>

#include "common/images.hpp"
#include "common/outliers.hpp"
#include "common/pixel_matches.hpp"
#include "common/study.hpp"
#include "common/table.hpp"
#include "uav_localization/localization.hpp"
#include "uav_localization/photographs.hpp"
#include "uav_localization/reference.hpp"

namespace {

using namespace samples;

const char* const kKeys =
    "{help h usage ? |      | print this help}"
    "{@queries       |      | pictures to be localised, one or more; each is matched to each reference of another name}"
    "{reference      |      | oriented photographs, separated by commas; --poses knows them by their names}"
    "{orthophoto     |      | orthophotos with a geotransform, separated by commas}"
    "{matches        |      | a file of matches from elsewhere (one query and reference), or a folder of files "
    "REFERENCE__QUERY.txt: rows u v u' v' (samples/common/pixel_matches.hpp); instead of SIFT}"
    "{features       | 8000 | SIFT features per picture}"
    "{ratio          | 0.8  | of the ratio test}"
    "{ransac         | 8    | threshold of the rejection of wrong matches, px; 0: keep every match}";

struct Options
{
    cv::Matx33d cameraMatrix;
    std::vector<double> distCoeffs;
    std::string matches;
    int features, seed;
    double ratio, ransacPixels;
};

Options optionsOf(const Arguments& arguments)
{
    Options options{
        cameraMatrixOf(arguments),      arguments.numbers("distortion"), arguments.get<std::string>("matches"),
        arguments.get<int>("features"), arguments.get<int>("seed"),      arguments.get<double>("ratio"),
        arguments.get<double>("ransac")};
    if (options.features < 1 || !(options.ratio > 0.0 && options.ratio <= 1.0) || !(options.ransacPixels >= 0.0))
        throw std::runtime_error("--features must be positive, --ratio in (0, 1] and --ransac not negative");
    return options;
}

std::vector<std::string> splitAtCommas(const std::string& text)
{
    std::istringstream stream(text);
    std::vector<std::string> parts;
    for (std::string part; std::getline(stream, part, ',');)
        parts.push_back(part);
    return parts;
}

//! A query and the reference it is matched to.
struct Job
{
    std::string query;
    const Reference* reference;
};

std::vector<Job> jobsOf(const std::vector<std::string>& queries, const std::vector<Reference>& references)
{
    std::vector<Job> jobs;
    for (const std::string& query : queries)
        for (const Reference& reference : references)
            if (pictureName(query) != pictureName(reference.path))
                jobs.push_back({query, &reference});
    if (jobs.empty())
        throw std::runtime_error("each query is its own reference; there is nothing to match");
    return jobs;
}

/** Matches by SIFT, or from files. Jobs come query by query: the references' features are kept, and the last query's.
 */
class Matcher
{
public:
    Matcher(const Options& options, bool onlyOne) : options_(options), onlyOne_(onlyOne) {}

    PixelMatches operator()(const Job& job) { return options_.matches.empty() ? bySift(job) : readMatches(file(job)); }

private:
    Options options_;
    bool onlyOne_;  //!< one query and one reference
    std::map<const Reference*, SiftFeatures> references_;
    std::string query_;
    SiftFeatures queryFeatures_;

    PixelMatches bySift(const Job& job)
    {
        auto entry = references_.find(job.reference);
        if (entry == references_.end())
            entry =
                references_
                    .emplace(job.reference, siftFeatures(job.reference->grey, job.reference->mask, options_.features))
                    .first;
        if (query_ != job.query)
            queryFeatures_ = siftFeatures(readImage(job.query, cv::IMREAD_GRAYSCALE), cv::Mat(), options_.features);
        query_ = job.query;
        return matchSift(entry->second, queryFeatures_, options_.ratio);
    }

    std::string file(const Job& job) const
    {
        if (std::filesystem::is_directory(options_.matches))
            return options_.matches + "/" + pictureName(job.reference->path) + "__" + pictureName(job.query) + ".txt";
        if (!onlyOne_)
            throw std::runtime_error("--matches: a file is for one query and one reference; give a folder");
        return options_.matches;
    }
};

CorrespondenceSet correspondencesOf(const Job& job, const PixelMatches& matches,
                                    const std::map<std::string, Pose>& poses, const Options& options)
{
    CorrespondenceSet set;
    set.cameraMatrix = options.cameraMatrix;
    set.distCoeffs = options.distCoeffs;
    set.unit = "m";
    const auto truth = poses.find(pictureName(job.query));
    set.hasTruth = truth != poses.end();
    if (set.hasTruth)
        set.truth = truth->second;
    for (size_t i = 0; i < matches.query.size(); ++i) {
        cv::Vec3d ground;
        if (!job.reference->lift(matches.reference[i], ground))
            continue;
        set.objectPoints.emplace_back(ground);
        set.imagePoints.push_back(matches.query[i]);
    }
    rejectOutliers(set, options.ransacPixels, options.seed);
    requireMatches(set, job.reference->path, job.query);
    return set;
}

//! The paper's six errors, and the two that do not depend on the axes.
void measureLocalization(Study& study)
{
    study.quantities = {{"roll", "deg", 4}, {"pitch", "deg", 4},   {"yaw", "deg", 4},      {"east", "m", 3},
                        {"north", "m", 3},  {"elevation", "m", 3}, {"rotation", "deg", 4}, {"position", "m", 3}};
    study.errors = [](const Pose& estimate, const Pose& truth) {
        const cv::Vec3d a = rollPitchYaw(estimate), b = rollPitchYaw(truth), c = estimate.centre() - truth.centre();
        return std::vector<double>{angleDifference(a[0], b[0]),
                                   angleDifference(a[1], b[1]),
                                   angleDifference(a[2], b[2]),
                                   c[0],
                                   c[1],
                                   c[2],
                                   rotationErrorDegrees(estimate, truth),
                                   positionError(estimate, truth)};
    };
}

void printLocalizations(const std::vector<Localization>& all)
{
    Table table({"GMLPNP_MARGINAL", "points", "easting [m]", "northing [m]", "elevation [m]", "standard deviations [m]",
                 "roll [deg]", "pitch [deg]", "yaw [deg]"});
    int inside = 0, known = 0;
    for (const Localization& l : all) {
        const cv::Matx33d& C = l.covariance;
        table.add(
            {l.name, std::to_string(l.points), fixed(l.centre[0], 2), fixed(l.centre[1], 2), fixed(l.centre[2], 2),
             fixed(std::sqrt(C(0, 0)), 2) + " " + fixed(std::sqrt(C(1, 1)), 2) + " " + fixed(std::sqrt(C(2, 2)), 2),
             fixed(l.attitude[0], 3), fixed(l.attitude[1], 3), fixed(l.attitude[2], 3)});
        known += l.hasTruth ? 1 : 0;
        inside += l.hasTruth && l.squaredDistance() < kReach3 ? 1 : 0;
    }
    std::cout << "\n";
    table.printMarkdown(std::cout);
    if (known > 0)
        std::cout << "\nThe truth lies in the 95 % region of " << inside << " of " << known << " positions\n";
}

std::vector<Reference> referencesOf(const Arguments& arguments, const std::map<std::string, Pose>& poses,
                                    const Options& options, const std::string& system, const Terrain& terrain)
{
    const auto camera = cv::gmlpnp::CameraModel::pinhole(options.cameraMatrix, options.distCoeffs);
    std::vector<Reference> references;
    for (const std::string& path : splitAtCommas(arguments.get<std::string>("reference")))
        references.push_back(orientedReference(path, camera, poseOf(path, poses), terrain));
    for (const std::string& path : splitAtCommas(arguments.get<std::string>("orthophoto")))
        references.push_back(orthophotoReference(path, system, terrain));
    if (references.empty())
        throw std::runtime_error("--reference or --orthophoto is needed");
    return references;
}

int run(const Arguments& arguments)
{
    const StudyOptions studied = studyOptions(arguments);
    const Options options = optionsOf(arguments);
    const std::string dem = required(arguments, "dem"), system = mapSystem(arguments.get<std::string>("crs"), dem);
    const Terrain terrain(readElevation(dem, system));
    const auto poses = orientationsOf(arguments);
    const std::vector<Reference> references = referencesOf(arguments, poses, options, system, terrain);
    const std::vector<Job> jobs = jobsOf(arguments.files, references);
    Study study;
    study.title = "UAV localisation";
    study.unit = {"m", 1.0};
    study.frame = {"map", {"east", "north", "up"}};
    bool truth = true;
    for (const Job& job : jobs) {
        study.pairs.push_back(pictureName(job.query) + "_by_" + pictureName(job.reference->path));
        truth = truth && poses.count(pictureName(job.query)) > 0;
    }
    if (truth)
        measureLocalization(study);
    else if (studied.residuals)
        throw std::runtime_error("--residuals: --poses does not know the truth of every query");
    Matcher matcher(options, jobs.size() == 1);
    study.correspondences = [&](size_t i) { return correspondencesOf(jobs[i], matcher(jobs[i]), poses, options); };
    std::vector<Localization> all;
    study.visit = [&](size_t i, const CorrespondenceSet& set, const std::vector<Outcome>& outcomes) {
        Localization found;
        if (!localize(set, study.pairs[i], found))
            return;
        all.push_back(found);
        if (!studied.output.empty())
            writeMap(studied.output + "/map_" + found.name + ".csv", found, set, terrain, studied.methods, outcomes);
    };
    const int code = runStudy(study, studied);
    if (!all.empty())
        printLocalizations(all);
    if (!studied.output.empty())
        writeLocalizations(studied.output + "/positions.csv", all);
    return code;
}

}  // namespace

int main(int argc, char** argv)
{
    return runProgram(argc, argv, std::string(kKeys) + kPhotographKeys + kStudyKeys,
                      "Where aerial pictures were taken, by a georeferenced picture and an elevation model.\n", 1, run);
}
