// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "same_pose.hpp"

namespace reliability {

double apart(const Vector3d& centre, const Pose& a, const Pose& b)
{
    const Vector3d X = a * centre;
    return std::max(synthetic::rotationAngle(a.R, b.R), (X - b * centre).norm() / X.norm());
}

bool roundingIsSmall(const Solver& solver, const Problem& problem)
{
    constexpr double PUBLISHED_CONDITION = 1e4;
    const bool published = solver.method == cv::gmlpnp::SOLVEPNP_GMLPNP;
    return problem.solvable() && problem.offset == 0 && !(published && problem.condition > PUBLISHED_CONDITION);
}

double roundingBound(const Problem& problem)
{
    // The solver's rotations act at the camera: turning a far thin rod about itself is there a small difference of
    // large numbers, and a step has an error of up to 1e-5 of its length.
    constexpr double BOUND = 1e-9, OF_DEVIATION = 1e-4, OF_DEVIATION_ILL = 1e-3, ILL_CONDITION = 1e5;
    const double share = problem.condition > ILL_CONDITION ? OF_DEVIATION_ILL : OF_DEVIATION;
    return std::max(BOUND, share * std::max(problem.rotationDeviation, problem.centreDeviation));
}

Problem shuffled(Problem problem, cv::RNG& rng)
{
    for (cv::Mat_<double>* rows : {&problem.points, &problem.rays, &problem.pixels})
        *rows = rows->clone();
    for (int i = problem.n - 1; i > 0; --i) {
        const int k = rng.uniform(0, i + 1);
        for (cv::Mat_<double>* rows : {&problem.points, &problem.rays, &problem.pixels})
            for (int column = 0; column < rows->cols && !rows->empty(); ++column)
                std::swap((*rows)(i, column), (*rows)(k, column));
    }
    return problem;
}

}  // namespace reliability
