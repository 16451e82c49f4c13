// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

// A user's program: the pose of exact data, by the installed header and library alone.

#include <opencv2/gmlpnp.hpp>

#include <cstdlib>
#include <iostream>
#include <vector>

int main()
{
    const std::vector<cv::Point3d> objectPoints = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1},
                                                   {1, 1, 0}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
    const cv::Matx33d K(800, 0, 320, 0, 800, 240, 0, 0, 1);
    const cv::Vec3d trueRvec(0.3, -0.2, 0.1), trueTvec(-0.4, 0.2, 6);
    std::vector<cv::Point2d> imagePoints;
    cv::projectPoints(objectPoints, trueRvec, trueTvec, K, cv::noArray(), imagePoints);

    cv::Vec3d rvec, tvec;
    const bool solved = cv::gmlpnp::solvePnP(objectPoints, imagePoints, K, cv::noArray(), rvec, tvec);
    std::cout << "rvec " << rvec << ", tvec " << tvec << std::endl;

    const double tolerance = 1e-6;  // rad and length: exact data, conditioned by a depth of 6
    return solved && cv::norm(rvec - trueRvec) < tolerance && cv::norm(tvec - trueTvec) < tolerance ? EXIT_SUCCESS
                                                                                                    : EXIT_FAILURE;
}
