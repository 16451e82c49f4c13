// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "../arrays/eigen.hpp"
#include "../estimator/pose_covariance.hpp"
#include "../noise/tails.hpp"
#include "result.hpp"

namespace cv {
namespace gmlpnp {

Result::Result()
    : status(STATUS_TOO_FEW_POINTS),
      rounds(0),
      cost(0),
      objectNoiseRank(0),
      noiseModel(NOISE_GIVEN),
      noiseEvidence(0),
      poseEvidence(0),
      tailShare(0),
      tailDof(std::numeric_limits<double>::infinity()),
      usedPoints(0)
{}

namespace detail {

Answer answerTo(const Problem& problem, const Options& options)
{
    Answer answer;
    answer.status = problem.finite ? solveMinima(problem.observations, options, answer.solutions) : STATUS_NOT_FINITE;
    return answer;
}

namespace {

NoiseModel noiseModelOf(NoiseKind kind)
{
    switch (kind) {
        case NoiseKind::BEARING:
            return NOISE_BEARING;
        case NoiseKind::BOTH:
            return NOISE_BOTH;
        case NoiseKind::FIXED:
            return NOISE_GIVEN;
        case NoiseKind::ISOTROPIC:
            return NOISE_ISOTROPIC;
        default:
            return NOISE_OBJECT;
    }
}

void addCovariances(const Solution& solution, Result& out)
{
    if (!solution.covariance)
        return;
    out.poseCovariance = toMat(*solution.covariance);
    out.poseCovarianceRt = toMat(toRvecTvec(*solution.covariance, solution.pose));
    out.cameraCenterCovariance = toMat(toCameraCenter(*solution.covariance, solution.pose));
}

void addNoise(const Solution& solution, Result& out)
{
    constexpr double NUMERICAL_RANK = 1e-6;  // of the largest variance
    out.objectNoise = toMat(solution.noise.Sigma);
    out.bearingNoise = toMat(solution.noise.Gamma);
    if (solution.objectError)
        out.objectNoiseStdErr = toMat(*solution.objectError);
    if (solution.bearingError)
        out.bearingNoiseStdErr = toMat(*solution.bearingError);
    out.objectNoiseRank = rank(solution.noise.Sigma, NUMERICAL_RANK);
    out.noiseModel = noiseModelOf(solution.kind);
    out.noiseEvidence = solution.evidence;
    out.tailShare = solution.noise.tails.share;
    out.tailDof = nearestStudentT(solution.noise.tails);
}

// A weight per row of the caller's arrays: zero for points that were not used.
Mat weightsOf(const Solution& solution, const Problem& problem)
{
    Mat_<double> weights(problem.total, 1, 0.0);
    for (size_t k = 0; k < solution.weights.size(); ++k)
        weights(problem.used[k]) = solution.weights[k];
    return std::move(weights);
}

}  // namespace

Result toResult(const Solution& solution, Status status, const Problem& problem)
{
    const Pose& pose = solution.pose;
    Result out;
    out.status = status;
    out.rounds = solution.rounds;
    out.cost = solution.cost;
    out.rvec = toVec(logSO3(pose.R));
    out.tvec = toVec(pose.t);
    out.cameraCenter = toVec(-pose.R.transpose() * pose.t);
    out.poseEvidence = solution.poseEvidence;
    addCovariances(solution, out);
    addNoise(solution, out);
    out.usedPoints = static_cast<int>(problem.used.size());
    out.weights = weightsOf(solution, problem);
    return out;
}

bool solveToResult(const Problem& problem, const Options& options, Result& result)
{
    const Answer answer = answerTo(problem, options);
    if (answer)
        result = toResult(answer.best(), answer.status, problem);
    else
        result.status = answer.status;
    return static_cast<bool>(answer);
}

void addPose(const Pose& pose, OutputArray rvec, OutputArray tvec, Outputs& outputs)
{
    outputs.add(toVec(logSO3(pose.R)), rvec, "rvec");
    outputs.add(toVec(pose.t), tvec, "tvec");
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
