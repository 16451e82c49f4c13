// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "baselines.hpp"

// L. Kneip, H. Li, Y. Seo: UPnP: An Optimal O(n) Solution to the Absolute Pose Problem with Universal Applicability,
// ECCV 2014, in the authors' library OpenGV.

#ifdef GMLPNP_HAVE_OPENGV

#include <opengv/absolute_pose/CentralAbsoluteAdapter.hpp>
#include <opengv/absolute_pose/methods.hpp>

namespace baselines {

bool haveUpnp()
{
    return true;
}

std::optional<Pose> upnp(const Data& data)
{
    opengv::bearingVectors_t rays;
    opengv::points_t points;
    for (int i = 0; i < data.size(); ++i) {
        rays.push_back(data.rays.col(i));
        points.push_back(data.points.col(i));
    }
    const opengv::absolute_pose::CentralAbsoluteAdapter adapter(rays, points);
    std::optional<Pose> best;
    double least = std::numeric_limits<double>::infinity();
    for (const opengv::transformation_t& objectFromCamera : opengv::absolute_pose::upnp(adapter)) {
        Pose pose;
        pose.R = objectFromCamera.leftCols<3>().transpose();
        pose.t = -pose.R * objectFromCamera.col(3);
        double cost = 0;  // 1 - cos of the angles between rays and points: a point behind costs most
        for (int i = 0; i < data.size(); ++i)
            cost += 1 - data.rays.col(i).dot((pose * data.points.col(i)).normalized());
        if (cost < least) {
            least = cost;
            best = pose;
        }
    }
    return best;
}

}  // namespace baselines

#else

namespace baselines {

bool haveUpnp()
{
    return false;
}

std::optional<Pose> upnp(const Data&)
{
    return std::nullopt;
}

}  // namespace baselines

#endif  // GMLPNP_HAVE_OPENGV
