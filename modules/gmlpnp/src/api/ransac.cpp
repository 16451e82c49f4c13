// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "../arrays/inputs.hpp"
#include "../estimator/robust.hpp"
#include "options.hpp"
#include "problem.hpp"
#include "ransac.hpp"
#include "result.hpp"
#include "solvepnp.hpp"

// The public functions for correspondences that may be wrong: ours first, then OpenCV's own names.

namespace cv {
namespace gmlpnp {

RansacParams::RansacParams() : threshold(0), confidence(0.99), maxIterations(10000), seed(0), ordered(false) {}

namespace detail {

namespace {

constexpr double DEFAULT_PIXELS = 8, DEFAULT_ANGLE = 0.01;  // px, rad
constexpr int FEWEST = 4;                                   // points, as cv::solvePnPRansac asks for

void checkRansac(const RansacParams& ransac, double largestThreshold)
{
    if (!(ransac.threshold >= 0 && ransac.threshold < largestThreshold))
        CV_Error(Error::StsBadArg, format("threshold: %g is not between 0 and %g", ransac.threshold, largestThreshold));
    if (!(ransac.confidence > 0 && ransac.confidence < 1))
        CV_Error(Error::StsBadArg, format("confidence: %g is not between 0 and 1", ransac.confidence));
    if (ransac.maxIterations < 1)
        CV_Error(Error::StsBadArg, format("maxIterations: %d is no iteration", ransac.maxIterations));
}

// Options of the search.
RansacOptions searchOptions(const RansacParams& ransac, const Options& options, const Measure& measure)
{
    return {ransac.confidence, ransac.maxIterations, static_cast<uint64>(ransac.seed),
            ransac.ordered,    measure.chance,       options.guess};
}

Status solveRobust(const Problem& problem, const Measure& measure, const Options& options, const RansacParams& ransac,
                   RobustSolution& out)
{
    return problem.finite ? detail::solveRobust(problem.observations, measure, options,
                                                searchOptions(ransac, options, measure), out)
                          : STATUS_NOT_FINITE;
}

std::vector<int> callersRows(const Problem& problem, const std::vector<int>& rows)
{
    std::vector<int> callers;
    for (const int row : rows)
        callers.push_back(problem.used[row]);
    return callers;
}

void addInliers(const Problem& problem, const RobustSolution& robust, OutputArray out, Outputs& outputs)
{
    if (out.needed())
        outputs.add(Mat(callersRows(problem, robust.inliers), true), out, "inliers");
}

bool solveToResult(Problem problem, const Measure& measure, const Options& options, const RansacParams& ransac,
                   Result& result, OutputArray inliers)
{
    RobustSolution robust;
    const Status status = solveRobust(problem, measure, options, ransac, robust);
    if (!isSuccess(status)) {
        result.status = status;
        return false;
    }
    Outputs outputs;
    addInliers(problem, robust, inliers, outputs);
    problem.used = callersRows(problem, robust.used);
    result = toResult(robust.solution, status, problem);
    outputs.write();
    return true;
}

// The measure of a call with a lens.
Measure measureOf(const Problem& problem, InputArray imagePoints, const Ptr<CameraModel>& camera, double threshold)
{
    const Mat_<double> pixels = chosenRows(pointsFrom(imagePoints, 2, "imagePoints"), problem.used);
    return pixelMeasure(camera, pixels, problem.rayByPixel, threshold > 0 ? threshold : DEFAULT_PIXELS);
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
    options.report = false;  // it could not be returned
    const Problem problem = problemFromPixels(objectPoints, imagePoints, camera, params, true);
    requireEnough(problem, FEWEST);
    RobustSolution robust;
    const Measure measure = measureOf(problem, imagePoints, camera, ransac.threshold);
    if (!isSuccess(solveRobust(problem, measure, options, ransac, robust)))
        return false;
    Outputs outputs;
    addPose(robust.solution.pose, rvec, tvec, outputs);
    addInliers(problem, robust, inliers, outputs);
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
    const Problem problem = problemFromPixels(objectPoints, imagePoints, camera, params, true);
    return solveToResult(problem, measureOf(problem, imagePoints, camera, ransac.threshold), options, ransac, result,
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
    const Problem problem = problemFromRays(objectPoints, rays, params);
    const Measure measure =
        angularMeasure(problem.observations.rays, ransac.threshold > 0 ? ransac.threshold : DEFAULT_ANGLE);
    return solveToResult(problem, measure, options, ransac, result, inliers);
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
