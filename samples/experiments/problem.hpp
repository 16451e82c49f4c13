// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_EXPERIMENTS_PROBLEM_HPP
#define GMLPNP_EXPERIMENTS_PROBLEM_HPP

#include <functional>
#include <string>

#include "baselines/baselines.hpp"
#include "test/synthetic.hpp"

namespace experiments {

using baselines::Matrix2d;
using baselines::Matrix3d;
using baselines::Pose;
using baselines::Vector3d;
using synthetic::Scene;

/** A scene in the form of every solver, with what is known of its noise for those that ask. */
struct Problem
{
    Scene scene;
    cv::Ptr<cv::gmlpnp::CameraModel> camera;
    bool perspective;  //!< a pinhole with the matrix synthetic::paperCamera(), all points before it
    baselines::Data data;
    baselines::Uncertainty uncertainty;    //!< true; of pixels on the image plane, where perspective
    std::vector<Matrix3d> rayCovariances;  //!< true, of the rays as seen from the true pose, camera frame, rad^2
    double inlierError = 0;                //!< three true standard deviations on the image plane
};

/** What does not depend on the solver, once. */
Problem prepared(const Scene& scene, const cv::Ptr<cv::gmlpnp::CameraModel>& camera, bool perspective);

cv::Ptr<cv::gmlpnp::CameraModel> pinhole();
/** A unified (MEI) lens of 220 degrees: xi = 1.5, f = 300 px. */
cv::Ptr<cv::gmlpnp::CameraModel> wideLens();

/** Draws one problem. */
using Draw = std::function<Problem(cv::RNG&)>;

/** The paper's: sigma [m] and px of the largest of each noise's deviations. */
Draw paperProblem(int n, double sigma, double px);

/** Points at log-uniform depths up to 45 degrees off the axis, horizontally and vertically. */
Draw depthProblem(int n, double nearest, double farthest, double sigma, double px);

/** A cube at 6 m that looks `halfSize` [px] wide and high to either side. */
Draw smallProblem(int n, double halfSize, double px);

/** Directions uniform in a cone around the axis, depths 4 to 8 m. */
Draw coneProblem(int n, double halfFieldDegrees, double sigma, double px);

/** As wideLens() sees them: directions uniform up to 110 degrees off the axis, depths 2 to 8 m. */
Draw wideProblem(int n, double sigma, double px);

/** Some of the points of the paper's problem have their pixels anywhere in the picture (gross), or five times the noise
in their object points. */
Draw outlierProblem(int n, double sigma, double px, double share, bool gross);

/** The paper's with object noise that is a Student-t of so many degrees of freedom. */
Draw studentProblem(int n, double sigma, double px, int dof);

}  // namespace experiments

#endif  // GMLPNP_EXPERIMENTS_PROBLEM_HPP
