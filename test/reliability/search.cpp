// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "search.hpp"

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

double bestOfSearch(const Problem& problem, int starts)
{
    const Correspondences data(problem.points, problem.rays);
    double best = std::numeric_limits<double>::infinity();
    if (data.degenerate())
        return best;
    Stopping stopping = defaultStopping(false);
    stopping.robust = true;
    cv::RNG rng = experiments::trialRng("search", problem.n, 0);
    std::vector<Pose> minima;
    for (int k = 0; k < starts; ++k) {
        const Pose minimum = isotropicPose(data, withTranslation(data, synthetic::randomRotation(rng)));
        if (!std::any_of(minima.begin(), minima.end(), [&](const Pose& known) { return near(known, minimum); }))
            minima.push_back(minimum);
    }
    for (const Pose& minimum : minima) {
        const Estimate found = estimateMarginal(data, minimum, std::nullopt, std::nullopt, stopping);
        if (found.pose.t.allFinite() && determined(found.sums.H) && 2 * found.sums.inFront > data.size() &&
            found.sums.L < best)
            best = found.sums.L;
    }
    return best + 2 * data.size() * std::log(data.scale);
}

}  // namespace reliability
