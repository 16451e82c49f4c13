// Included before OpenCV's tutorial programs (-include): each call of solvePnP and solvePnPRansac also writes its pose
// to the file that POSE_LOG names, and no window waits for a key. The programs themselves stay as they are.
#ifndef GMLPNP_TEST_LOG_POSES_HPP
#define GMLPNP_TEST_LOG_POSES_HPP

#include <cstdlib>
#include <fstream>
#include <opencv2/gmlpnp.hpp>
#include <opencv2/highgui.hpp>
#include <utility>

namespace log_poses {

inline bool write(bool found, cv::InputArray rvec, cv::InputArray tvec)
{
    static std::ofstream log(std::getenv("POSE_LOG"));
    log.precision(17);
    log << found;
    for (const cv::Mat& v : {rvec.getMat(), tvec.getMat()})
        for (int i = 0; i < 3; ++i)
            log << ' ' << (v.empty() ? 0 : v.at<double>(i));
    log << std::endl;
    return found;
}

}  // namespace log_poses

#define LOGGED(space, name)                                                                                         \
    namespace space {                                                                                               \
    template <class... More>                                                                                        \
    bool logged_##name(cv::InputArray objectPoints, cv::InputArray imagePoints, cv::InputArray K, cv::InputArray D, \
                       cv::OutputArray rvec, cv::OutputArray tvec, More&&... more)                                  \
    {                                                                                                               \
        const bool found = space::name(objectPoints, imagePoints, K, D, rvec, tvec, std::forward<More>(more)...);   \
        return log_poses::write(found, rvec, tvec);                                                                 \
    }                                                                                                               \
    }

LOGGED(cv, solvePnP)
LOGGED(cv, solvePnPRansac)
LOGGED(cv::gmlpnp, solvePnP)
LOGGED(cv::gmlpnp, solvePnPRansac)

#define solvePnP logged_solvePnP
#define solvePnPRansac logged_solvePnPRansac
#define waitKey(...) pollKey()

#endif  // GMLPNP_TEST_LOG_POSES_HPP
