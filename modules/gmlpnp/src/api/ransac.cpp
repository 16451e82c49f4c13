// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "../arrays/inputs.hpp"
#include "../ransac/measure.hpp"
#include "../ransac/repeats.hpp"
#include "../ransac/search.hpp"
#include "options.hpp"
#include "problem.hpp"
#include "ransac.hpp"
#include "result.hpp"
#include "solvepnp.hpp"

// The search for a consensus, the solve on its inliers, the inliers of what was solved.

namespace cv {
namespace gmlpnp {

RansacParams::RansacParams() : threshold(0), confidence(0.99), maxIterations(10000), seed(0), ordered(false) {}

namespace detail {

namespace {

constexpr double DEFAULT_PIXELS = 8, DEFAULT_ANGLE = 0.01;  // px, rad

void checkRansac(const RansacParams& ransac, double largestThreshold)
{
    if (!(ransac.threshold >= 0 && ransac.threshold < largestThreshold))
        CV_Error(Error::StsBadArg, format("threshold: %g is not between 0 and %g", ransac.threshold, largestThreshold));
    if (!(ransac.confidence > 0 && ransac.confidence < 1))
        CV_Error(Error::StsBadArg, format("confidence: %g is not between 0 and 1", ransac.confidence));
    if (ransac.maxIterations < 1)
        CV_Error(Error::StsBadArg, format("maxIterations: %d is no iteration", ransac.maxIterations));
}

size_t countDifferent(const std::vector<int>& a, const std::vector<int>& b)
{
    std::vector<int> different;
    std::set_symmetric_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(different));
    return different.size();
}

struct Robust
{
    Solution solution;
    std::vector<int> used;  //!< rows of the observations that it was solved from
    Inliers inliers;        //!< at its pose
};

// A threshold that cuts into the noise leaves residuals that are smaller than the noise by varianceLeft(); and as the
// points that a pose leaves behind no longer pull at it, the cost is as much flatter than that of as many points.
void undoTheCut(const Options& options, Robust& robust)
{
    constexpr double TAKEN = 3;  // points' worth of residuals that the pose takes: 6 of 2 n
    if (!robust.solution.covariance)
        return;
    const double count = static_cast<double>(robust.inliers.rows.size());
    const double left = varianceLeft(robust.inliers.sumOfSquares / std::max(count - TAKEN, 1.));
    const bool known = options.Sigma && options.Gamma;
    *robust.solution.covariance /= known ? left : left * left;
}

// From the pose of the consensus: solve on its inliers, take those of the solution, and again until they stay. A share
// of points that come and go at the threshold moves the pose by far less than its uncertainty.
Status solveInliers(const Observations& all, const Measure& measure, Options options, const Pose& consensus,
                    Robust& robust)
{
    constexpr int ROUNDS = 10;
    constexpr size_t COME_AND_GO = 100;  // one of so many
    Status status = STATUS_NO_CONSENSUS;
    std::vector<int> inliers = inliersOf(all, measure, consensus).rows;
    options.guess = consensus;
    for (int round = 0; round < ROUNDS; ++round) {
        if (inliers.size() < 4)
            return STATUS_NO_CONSENSUS;
        std::vector<Solution> solutions;
        status = solveMinima(chosenRows(all, inliers), options, solutions);
        if (!isSuccess(status))
            return status;
        robust.solution = solutions.front();
        robust.used = inliers;
        options.guess = robust.solution.pose;
        robust.inliers = inliersOf(all, measure, robust.solution.pose);
        if (countDifferent(inliers, robust.inliers.rows) * COME_AND_GO <= inliers.size())
            break;
        inliers = robust.inliers.rows;
    }
    undoTheCut(options, robust);
    return robust.inliers.rows.size() < 4 ? STATUS_NO_CONSENSUS : status;
}

// The search, among matches of which none repeats another; `data` are all of them.
std::optional<Consensus> searched(const Observations& all, const Correspondences& data, const Measure& measure,
                                  const RansacOptions& options)
{
    const std::vector<int> rows = withoutRepeats(data, measure.metrics);
    if (rows.empty())
        return findConsensus(data, measure.metrics, options);
    if (rows.size() < 4)
        return std::nullopt;
    std::vector<Metric> metrics;
    for (const int row : rows)
        metrics.push_back(measure.metrics[row]);
    return findConsensus(Correspondences(chosenRows(all.points, rows), chosenRows(all.rays, rows)), metrics, options);
}

Status runRansac(const Problem& input, const Measure& measure, const Options& options, const RansacParams& ransac,
                 Robust& robust)
{
    if (!input.finite)
        return STATUS_NOT_FINITE;
    if (input.observations.points.rows < 4)
        return STATUS_TOO_FEW_POINTS;
    const Correspondences data(input.observations.points, input.observations.rays);
    if (!data.finite())
        return STATUS_NOT_FINITE;
    if (data.degenerate())
        return STATUS_DEGENERATE;
    const std::optional<Consensus> consensus =
        searched(input.observations, data, measure,
                 {ransac.confidence, ransac.maxIterations, static_cast<uint64>(ransac.seed), ransac.ordered,
                  measure.chance, options.guess});
    if (!consensus)
        return STATUS_NO_CONSENSUS;
    return solveInliers(input.observations, measure, options, consensus->pose, robust);
}

std::vector<int> callersRows(const Problem& input, const std::vector<int>& rows)
{
    std::vector<int> callers;
    for (const int row : rows)
        callers.push_back(input.used[row]);
    return callers;
}

void addInliers(const Problem& input, const Robust& robust, OutputArray out, Outputs& outputs)
{
    if (out.needed())
        outputs.add(Mat(callersRows(input, robust.inliers.rows), true), out, "inliers");
}

bool solveToResult(Problem input, const Measure& measure, const Options& options, const RansacParams& ransac,
                   Result& result, OutputArray inliers)
{
    Robust robust;
    const Status status = runRansac(input, measure, options, ransac, robust);
    if (!isSuccess(status)) {
        result.status = status;
        return false;
    }
    Outputs outputs;
    addInliers(input, robust, inliers, outputs);
    input.used = callersRows(input, robust.used);
    result = toResult(robust.solution, status, input);
    outputs.write();
    return true;
}

// What a call with a lens measures by.
Measure measureOf(const Problem& input, InputArray imagePoints, const Ptr<CameraModel>& camera, double threshold)
{
    const Mat_<double> pixels = chosenRows(pointsFrom(imagePoints, 2, "imagePoints"), input.used);
    return pixelMeasure(camera, pixels, input.rayByPixel, threshold > 0 ? threshold : DEFAULT_PIXELS);
}

constexpr double ANY = std::numeric_limits<double>::max();  // threshold, px

}  // namespace

RansacParams ransacParamsOf(int iterationsCount, double reprojectionError, double confidence)
{
    if (iterationsCount < 1)
        CV_Error(Error::StsBadArg, format("iterationsCount: %d is no iteration", iterationsCount));
    if (!(reprojectionError > 0))
        CV_Error(Error::StsBadArg, format("reprojectionError: %g is not positive", reprojectionError));
    RansacParams ransac;
    ransac.maxIterations = iterationsCount;
    ransac.threshold = reprojectionError;
    ransac.confidence = confidence;
    return ransac;
}

bool solvePnPRansacWith(const Ptr<CameraModel>& camera, InputArray objectPoints, InputArray imagePoints,
                        OutputArray rvec, OutputArray tvec, OutputArray inliers, const RansacParams& ransac,
                        const Params& params)
{
    checkRansac(ransac, ANY);
    Options options = optionsFrom(params);
    options.report = false;  // they could not be returned
    const Problem input = problemFromPixels(objectPoints, imagePoints, camera, params, true);
    requireEnough(input, 4);
    Robust robust;
    const Measure measure = measureOf(input, imagePoints, camera, ransac.threshold);
    if (!isSuccess(runRansac(input, measure, options, ransac, robust)))
        return false;
    Outputs outputs;
    addPose(robust.solution.pose, rvec, tvec, outputs);
    addInliers(input, robust, inliers, outputs);
    outputs.write();
    return true;
}

}  // namespace detail

using namespace detail;

bool solveRansac(InputArray objectPoints, InputArray imagePoints, const Ptr<CameraModel>& camera, Result& result,
                 OutputArray inliers, const RansacParams& ransac, const Params& params)
{
    checkRansac(ransac, ANY);
    const Options options = optionsFrom(params);
    const Problem input = problemFromPixels(objectPoints, imagePoints, camera, params, true);
    return solveToResult(input, measureOf(input, imagePoints, camera, ransac.threshold), options, ransac, result,
                         inliers);
}

bool solveRansac(InputArray objectPoints, InputArray imagePoints, InputArray cameraMatrix, InputArray distCoeffs,
                 Result& result, OutputArray inliers, const RansacParams& ransac, const Params& params)
{
    return solveRansac(objectPoints, imagePoints, CameraModel::pinhole(cameraMatrix, distCoeffs), result, inliers,
                       ransac, params);
}

bool solveRaysRansac(InputArray objectPoints, InputArray rays, Result& result, OutputArray inliers,
                     const RansacParams& ransac, const Params& params)
{
    checkRansac(ransac, CV_PI / 2);
    const Options options = optionsFrom(params);
    const Problem input = problemFromRays(objectPoints, rays, params);
    const Measure measure =
        angularMeasure(input.observations.rays, ransac.threshold > 0 ? ransac.threshold : DEFAULT_ANGLE);
    return solveToResult(input, measure, options, ransac, result, inliers);
}

bool solvePnPRansac(InputArray objectPoints, InputArray imagePoints, InputArray cameraMatrix, InputArray distCoeffs,
                    OutputArray rvec, OutputArray tvec, bool useExtrinsicGuess, int iterationsCount,
                    float reprojectionError, double confidence, OutputArray inliers, int flags)
{
    if (isOpenCVRansacFlag(flags))
        return cv::solvePnPRansac(objectPoints, imagePoints, cameraMatrix, distCoeffs, rvec, tvec, useExtrinsicGuess,
                                  iterationsCount, reprojectionError, confidence, inliers, flags);
    return solvePnPRansacWith(CameraModel::pinhole(cameraMatrix, distCoeffs), objectPoints, imagePoints, rvec, tvec,
                              inliers, ransacParamsOf(iterationsCount, reprojectionError, confidence),
                              paramsOf(flags, useExtrinsicGuess, rvec, tvec));
}

bool solvePnPRansac(InputArray objectPoints, InputArray imagePoints, InputOutputArray cameraMatrix,
                    InputArray distCoeffs, OutputArray rvec, OutputArray tvec, OutputArray inliers,
                    const UsacParams& params)
{
    RansacParams ransac = ransacParamsOf(params.maxIterations, params.threshold, params.confidence);
    ransac.seed = params.randomGeneratorState;
    ransac.ordered = params.sampler == SAMPLING_PROSAC;
    return solvePnPRansacWith(CameraModel::pinhole(cameraMatrix, distCoeffs), objectPoints, imagePoints, rvec, tvec,
                              inliers, ransac, Params());
}

}  // namespace gmlpnp
}  // namespace cv
