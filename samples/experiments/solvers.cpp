// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "solvers.hpp"

namespace experiments {

using cv::gmlpnp::Params;
using cv::gmlpnp::Result;

Pose poseOf(const Result& result)
{
    return poseOf(result.rvec, result.tvec);
}

Matrix3d matrixOf(const cv::Mat& m)
{
    return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(m.ptr<double>());
}

Params trueNoise(const Problem& problem)
{
    constexpr int TO_CONVERGENCE = 50;
    const int n = problem.data.size();
    Params params;
    params.method = cv::gmlpnp::SOLVEPNP_GMLPNP;
    params.maxRounds = TO_CONVERGENCE;
    params.objectNoise.create(3, 3, CV_64F);
    Eigen::Map<Matrix3d>(params.objectNoise.ptr<double>()) = problem.scene.Sigma;
    params.bearingNoise = cv::Mat::zeros(3, 3, CV_64F);
    params.pixelCovariances.create(n, 4, CV_64F);
    for (int i = 0; i < n; ++i)
        Eigen::Map<Matrix2d>(params.pixelCovariances.ptr<double>(i)) = problem.scene.pixelCovariance;
    return params;
}

std::optional<Result> solved(const Problem& problem, const Params& params)
{
    Result result;
    if (!cv::gmlpnp::solve(problem.scene.objectPoints, problem.scene.imagePoints, problem.camera, result, params))
        return std::nullopt;
    return result;
}

namespace {

// By a flag of solvePnP, or on rays where the lens is none of OpenCV's.
Solver byFlag(const std::string& name, int flag)
{
    const bool ours = flag >= cv::gmlpnp::SOLVEPNP_GMLPNP;
    const auto solve = [flag](const Problem& problem) -> std::optional<Pose> {
        if (!problem.perspective) {
            Params params;
            params.method = flag;
            const std::optional<Result> result = solved(problem, params);
            return result ? std::optional<Pose>(poseOf(*result)) : std::nullopt;
        }
        cv::Vec3d rvec, tvec;
        if (!cv::gmlpnp::solvePnP(problem.scene.objectPoints, problem.scene.imagePoints, synthetic::paperCamera(),
                                  cv::noArray(), rvec, tvec, false, flag))
            return std::nullopt;
        return poseOf(rvec, tvec);
    };
    return {name, ours, solve};
}

}  // namespace

const std::vector<Solver>& allSolvers()
{
    static const std::vector<Solver> solvers = [] {
        std::vector<Solver> all = {
            byFlag("EPnP", cv::gmlpnp::SOLVEPNP_EPNP),
            byFlag("BA", cv::gmlpnp::SOLVEPNP_ITERATIVE),
            {"PPnP", false, [](const Problem& p) { return baselines::ppnp(p.data); }},
            byFlag("SQPnP", cv::gmlpnp::SOLVEPNP_SQPNP),
            {"CPnP", false, [](const Problem& p) { return baselines::cpnp(p.data); }},
            {"MLPnP", true, [](const Problem& p) { return baselines::mlpnp(p.data, p.rayCovariances); }},
            {"REPPnP", false, [](const Problem& p) { return baselines::reppnp(p.data, p.inlierError); }},
            {"EPnPU", false, [](const Problem& p) { return baselines::epnpu(p.data, p.uncertainty); }},
            {"DLSU", false, [](const Problem& p) { return baselines::dlsu(p.data, p.uncertainty); }},
            byFlag("GMLPnP", cv::gmlpnp::SOLVEPNP_GMLPNP),
            byFlag("GMLPnP marginal", cv::gmlpnp::SOLVEPNP_GMLPNP_MARGINAL),
            {"GMLPnP*", true, [](const Problem& p) -> std::optional<Pose> {
                 const std::optional<Result> result = solved(p, trueNoise(p));
                 return result ? std::optional<Pose>(poseOf(*result)) : std::nullopt;
             }}};
        if (baselines::haveUpnp())
            all.insert(all.begin() + 5, {"UPnP", true, [](const Problem& p) { return baselines::upnp(p.data); }});
        return all;
    }();
    return solvers;
}

std::vector<Solver> solversFor(bool perspective)
{
    std::vector<Solver> chosen;
    for (const Solver& solver : allSolvers())
        if (perspective || solver.anyLens)
            chosen.push_back(solver);
    return chosen;
}

}  // namespace experiments
