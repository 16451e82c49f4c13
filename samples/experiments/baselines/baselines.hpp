// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_BASELINES_BASELINES_HPP
#define GMLPNP_BASELINES_BASELINES_HPP

#include "src/math/spd3.hpp"

/** The solvers that GMLPnP is compared with, written from the equations of their papers; one file each, which names the
paper. X = R p + t throughout; no solver changes its input; without a pose in front of the camera they return none. */
namespace baselines {

using cv::gmlpnp::detail::Matrix3d;
using cv::gmlpnp::detail::Matrix6d;
using cv::gmlpnp::detail::Pose;
using cv::gmlpnp::detail::Vector3d;
using cv::gmlpnp::detail::Vector6d;
using Eigen::Matrix2d;
using Eigen::Matrix2Xd;
using Eigen::Matrix3Xd;
using Eigen::Vector2d;

/** Object points (length), and what was seen of them: unit rays or points of the image plane at distance 1. */
struct Data
{
    Matrix3Xd points;  //!< object frame
    Matrix3Xd rays;    //!< camera frame, unit
    Matrix2Xd image;   //!< (X/Z, Y/Z); needed by the perspective solvers only

    int size() const { return static_cast<int>(points.cols()); }
};

/** Known noise of each correspondence. */
struct Uncertainty
{
    std::vector<Matrix3d> object;  //!< of the points, object frame, length^2
    std::vector<Matrix2d> image;   //!< of Data::image
};

struct PpnpOptions
{
    double tolerance = 1e-9;  //!< change of rotation [rad] and of translation, relative, below which it has converged
    int maxIterations = 20000;
};
std::optional<Pose> ppnp(const Data& data, const PpnpOptions& options = PpnpOptions());

/** `rayCovariances`: of the unit rays, camera frame, rad^2; empty: all alike. */
std::optional<Pose> mlpnp(const Data& data, const std::vector<Matrix3d>& rayCovariances = {});

struct CpnpOptions
{
    bool eliminateBias = true;
    int refinements = 5;  //!< Gauss-Newton steps on the pixels; one is enough for large n
};
std::optional<Pose> cpnp(const Data& data, const CpnpOptions& options = CpnpOptions());

/** `largestInlierError`: on the image plane at distance 1; points beyond are left out, but never more than 3/4. */
std::optional<Pose> reppnp(const Data& data, double largestInlierError);

std::optional<Pose> epnpu(const Data& data, const Uncertainty& uncertainty);
/** EPnPU's skeleton with all points alike and no refinement: EPnP. */
std::optional<Pose> epnp(const Data& data);

std::optional<Pose> dlsu(const Data& data, const Uncertainty& uncertainty);
/** DLSU's skeleton with all points alike and no refinement: DLS. */
std::optional<Pose> dls(const Data& data);

/** UPnP of OpenGV, if the build found that library; otherwise none. */
std::optional<Pose> upnp(const Data& data);
bool haveUpnp();

}  // namespace baselines

#endif  // GMLPNP_BASELINES_BASELINES_HPP
