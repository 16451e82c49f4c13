// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "search.hpp"

#include "src/noise_estimate.hpp"
#include "src/pose_covariance.hpp"
#include "trials.hpp"

namespace reliability {

namespace {

using namespace cv::gmlpnp::detail;

// The translation of least isotropic cost for a rotation.
Pose withTranslation(const Correspondences& data, const Matrix3d& R)
{
    Matrix3d A = Matrix3d::Zero();
    Vector3d b = Vector3d::Zero();
    for (int i = 0; i < data.size(); ++i) {
        const Matrix3d Q = Matrix3d::Identity() - data.rayAt(i) * data.rayAt(i).transpose();
        A += Q;
        b -= Q * (R * data.pointAt(i));
    }
    return {R, A.ldlt().solve(b)};
}

bool near(const Pose& a, const Pose& b)
{
    constexpr double SAME = 1e-4;  // rad
    return (a.R - b.R).norm() < SAME;
}

}  // namespace

bool searchable(const Problem& problem)
{
    constexpr int FEWEST = 6;
    constexpr double ABOVE_ROUNDING = 1e-9;
    return problem.n >= FEWEST && !problem.hasGuess() && problem.outliers == 0 && !problem.corrupt &&
           problem.shape != Shape::BEHIND && problem.shape != Shape::UNRELATED &&
           problem.objectNoise + problem.rayNoise > ABOVE_ROUNDING;
}

namespace {

// What the estimator chooses by, near a minimum of isotropic noise; infinite where it finds no pose.
double criterion(const Correspondences& data, const Pose& minimum)
{
    Stopping stopping = defaultStopping(false);
    stopping.robust = true;
    const Estimate found = estimateMarginal(data, minimum, std::nullopt, std::nullopt, stopping);
    const bool sound = found.pose.t.allFinite() && determined(found.sums.H) && 2 * found.sums.inFront > data.size();
    return sound ? found.sums.L + found.penalty : std::numeric_limits<double>::infinity();
}

}  // namespace

double aboveSearch(const Problem& problem, const Pose& pose, int starts)
{
    const Correspondences data(problem.points, problem.rays);
    if (data.degenerate())
        return 0;
    const Pose ours = isotropicPose(data, data.fromObject(pose));
    double best = criterion(data, ours);
    const double found = best;
    cv::RNG rng = experiments::trialRng("search", problem.n, 0);
    std::vector<Pose> minima = {ours};
    for (int k = 0; k < starts; ++k) {
        const Pose minimum = isotropicPose(data, withTranslation(data, synthetic::randomRotation(rng)));
        if (std::any_of(minima.begin(), minima.end(), [&](const Pose& known) { return near(known, minimum); }))
            continue;
        minima.push_back(minimum);
        best = std::min(best, criterion(data, minimum));
    }
    return found - best;
}

}  // namespace reliability
