// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_EXPERIMENTS_EXPERIMENTS_HPP
#define GMLPNP_EXPERIMENTS_EXPERIMENTS_HPP

#include <stdexcept>

#include "csv.hpp"
#include "solvers.hpp"
#include "trials.hpp"

namespace experiments {

/** One subcommand: it draws its problems, solves them and writes `<name>.csv` (some a second file). */
struct Experiment
{
    std::string name;
    std::string about;
    std::function<void(const Settings&)> run;
};

/** In the order of the paper's figures, then what goes beyond it. */
const std::vector<Experiment>& allExperiments();

/** Errors of a pose: the paper's two metrics, and the distance of the camera centres. Not a number: no pose. */
struct PoseErrors
{
    double rotation;     //!< largest angle between matching columns, degrees
    double translation;  //!< |t - t_true| / |t_true|, per cent
    double centre;       //!< length
};
PoseErrors errorsOf(const std::optional<Pose>& pose, const Pose& truth);

/** Solves; an exception of OpenCV's solvers is no pose. */
std::optional<Pose> poseBy(const Solver& solver, const Problem& problem);

void runPoints(const Settings& settings);
void runNoise(const Settings& settings);
void runDepth(const Settings& settings);
void runPixels(const Settings& settings);
void runWide(const Settings& settings);
void runOutliers(const Settings& settings);
void runConsistency(const Settings& settings);
void runTime(const Settings& settings);
void runGuess(const Settings& settings);
void runRounds(const Settings& settings);
void runCovariance(const Settings& settings);
void runCase(const Settings& settings);
void runCoverage(const Settings& settings);
void runRecovery(const Settings& settings);
void runSmall(const Settings& settings);
void runBias(const Settings& settings);
void runTails(const Settings& settings);

}  // namespace experiments

#endif  // GMLPNP_EXPERIMENTS_EXPERIMENTS_HPP
