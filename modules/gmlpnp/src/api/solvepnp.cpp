// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "../arrays/inputs.hpp"
#include "options.hpp"
#include "problem.hpp"
#include "result.hpp"
#include "solvepnp.hpp"

// The public functions: ours first, then OpenCV's own names.

namespace cv {
namespace gmlpnp {

namespace {

using namespace detail;

int solveEvery(const Problem& problem, Options options, std::vector<Result>& results)
{
    options.everyMinimum = true;
    const Answer answer = answerTo(problem, options);
    if (!answer)
        return 0;
    std::vector<Result> found;
    for (const Solution& solution : answer.solutions)
        found.push_back(toResult(solution, solution.converged ? STATUS_CONVERGED : STATUS_MAX_ROUNDS, problem));
    results.swap(found);
    return static_cast<int>(results.size());
}

}  // namespace

bool solveRays(InputArray objectPoints, InputArray rays, Result& result, const Params& params)
{
    const Options options = optionsFrom(params);
    return solveToResult(problemFromRays(objectPoints, rays, params), options, result);
}

bool solve(InputArray objectPoints, InputArray imagePoints, const Ptr<CameraModel>& camera, Result& result,
           const Params& params)
{
    const Options options = optionsFrom(params);
    return solveToResult(problemFromPixels(objectPoints, imagePoints, camera, params), options, result);
}

bool solve(InputArray objectPoints, InputArray imagePoints, InputArray cameraMatrix, InputArray distCoeffs,
           Result& result, const Params& params)
{
    return solve(objectPoints, imagePoints, CameraModel::pinhole(cameraMatrix, distCoeffs), result, params);
}

int solveAll(InputArray objectPoints, InputArray imagePoints, const Ptr<CameraModel>& camera,
             std::vector<Result>& results, const Params& params)
{
    const Options options = optionsFrom(params);
    return solveEvery(problemFromPixels(objectPoints, imagePoints, camera, params), options, results);
}

int solveAll(InputArray objectPoints, InputArray imagePoints, InputArray cameraMatrix, InputArray distCoeffs,
             std::vector<Result>& results, const Params& params)
{
    return solveAll(objectPoints, imagePoints, CameraModel::pinhole(cameraMatrix, distCoeffs), results, params);
}

namespace {

Problem enoughPixels(InputArray objectPoints, InputArray imagePoints, const Ptr<CameraModel>& camera,
                     const Params& params, const Options& options)
{
    Problem problem = problemFromPixels(objectPoints, imagePoints, camera, params);
    requireEnough(problem, options.fewestPoints());
    return problem;
}

bool solveToVectors(InputArray objectPoints, InputArray imagePoints, const Ptr<CameraModel>& camera,
                    const Params& params, OutputArray rvec, OutputArray tvec)
{
    Options options = optionsFrom(params);
    options.report = false;  // it could not be returned
    const Answer answer = answerTo(enoughPixels(objectPoints, imagePoints, camera, params, options), options);
    if (!answer)
        return false;
    Outputs outputs;
    addPose(answer.best().pose, rvec, tvec, outputs);
    outputs.write();
    return true;
}

}  // namespace

bool detail::solvePnPWith(const Ptr<CameraModel>& camera, InputArray objectPoints, InputArray imagePoints,
                          OutputArray rvec, OutputArray tvec, bool useExtrinsicGuess, int flags)
{
    const Params params = paramsOf(flags, useExtrinsicGuess, rvec, tvec);
    return solveToVectors(objectPoints, imagePoints, camera, params, rvec, tvec);
}

bool solvePnP(InputArray objectPoints, InputArray imagePoints, InputArray cameraMatrix, InputArray distCoeffs,
              OutputArray rvec, OutputArray tvec, bool useExtrinsicGuess, int flags)
{
    if (detail::isOpenCVFlag(flags))
        return cv::solvePnP(objectPoints, imagePoints, cameraMatrix, distCoeffs, rvec, tvec, useExtrinsicGuess, flags);
    return detail::solvePnPWith(CameraModel::pinhole(cameraMatrix, distCoeffs), objectPoints, imagePoints, rvec, tvec,
                                useExtrinsicGuess, flags);
}

namespace {

// Root mean square over both coordinates of all points, as cv::solvePnPGeneric computes it.
Mat reprojectionErrors(InputArray objectPoints, InputArray imagePoints, InputArray cameraMatrix, InputArray distCoeffs,
                       const std::vector<Result>& results)
{
    const Mat points = pointsFrom(objectPoints, 3, "objectPoints"), pixels = pointsFrom(imagePoints, 2, "imagePoints");
    Mat K, D, projected;  // cv::projectPoints takes floating-point numbers only
    cameraMatrix.getMat().convertTo(K, CV_64F);
    distCoeffs.getMat().convertTo(D, CV_64F);
    Mat_<double> errors(static_cast<int>(results.size()), 1);
    for (int i = 0; i < errors.rows; ++i) {
        projectPoints(points, results[i].rvec, results[i].tvec, K, D, projected);
        errors(i) = norm(projected.reshape(1, pixels.rows), pixels, NORM_L2) / std::sqrt(2. * pixels.rows);
    }
    return std::move(errors);
}

}  // namespace

int solvePnPGeneric(InputArray objectPoints, InputArray imagePoints, InputArray cameraMatrix, InputArray distCoeffs,
                    OutputArrayOfArrays rvecs, OutputArrayOfArrays tvecs, bool useExtrinsicGuess, int flags,
                    InputArray rvec, InputArray tvec, OutputArray reprojectionError)
{
    if (detail::isOpenCVFlag(flags))
        return cv::solvePnPGeneric(objectPoints, imagePoints, cameraMatrix, distCoeffs, rvecs, tvecs, useExtrinsicGuess,
                                   static_cast<cv::SolvePnPMethod>(flags), rvec, tvec, reprojectionError);
    const Params params = paramsOf(flags, useExtrinsicGuess, rvec, tvec);
    const Ptr<CameraModel> camera = CameraModel::pinhole(cameraMatrix, distCoeffs);
    std::vector<Result> results;
    const Options options = optionsFrom(params);
    const int count = solveEvery(enoughPixels(objectPoints, imagePoints, camera, params, options), options, results);
    if (count == 0)
        return 0;
    std::vector<Vec3d> rotations, translations;
    for (const Result& result : results) {
        rotations.push_back(result.rvec);
        translations.push_back(result.tvec);
    }
    Outputs outputs;
    outputs.add(rotations, rvecs, "rvecs");
    outputs.add(translations, tvecs, "tvecs");
    if (reprojectionError.needed())
        outputs.add(reprojectionErrors(objectPoints, imagePoints, cameraMatrix, distCoeffs, results), reprojectionError,
                    "reprojectionError");
    outputs.write();
    return count;
}

void solvePnPRefine(InputArray objectPoints, InputArray imagePoints, InputArray cameraMatrix, InputArray distCoeffs,
                    InputOutputArray rvec, InputOutputArray tvec, TermCriteria criteria)
{
    Params params = paramsOf(SOLVEPNP_GMLPNP_MARGINAL, true, rvec, tvec);
    if (criteria.type & TermCriteria::COUNT) {
        if (criteria.maxCount < 1)
            CV_Error(Error::StsBadArg, format("criteria: a count of %d is no round", criteria.maxCount));
        params.maxRounds = criteria.maxCount;
    }
    solveToVectors(objectPoints, imagePoints, CameraModel::pinhole(cameraMatrix, distCoeffs), params, rvec, tvec);
}

void solvePnPRefineLM(InputArray objectPoints, InputArray imagePoints, InputArray cameraMatrix, InputArray distCoeffs,
                      InputOutputArray rvec, InputOutputArray tvec, TermCriteria criteria)
{
    cv::solvePnPRefineLM(objectPoints, imagePoints, cameraMatrix, distCoeffs, rvec, tvec, criteria);
}

void solvePnPRefineVVS(InputArray objectPoints, InputArray imagePoints, InputArray cameraMatrix, InputArray distCoeffs,
                       InputOutputArray rvec, InputOutputArray tvec, TermCriteria criteria, double VVSlambda)
{
    cv::solvePnPRefineVVS(objectPoints, imagePoints, cameraMatrix, distCoeffs, rvec, tvec, criteria, VVSlambda);
}

}  // namespace gmlpnp
}  // namespace cv
