// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

// The program of the tutorial: a pose by cv::solvePnP, by its replacement, with its uncertainty, and from a wide lens.

//! [include]
#include <opencv2/gmlpnp.hpp>
//! [include]

#include <cmath>
#include <iostream>
#include <vector>

namespace {

const cv::Vec3d TRUE_RVEC(0.3, -0.4, 0.5), TRUE_TVEC(0.1, -0.2, 6);

// Points of a cube of edge 4 around the origin of the object; with noise: 0.02 along x and y, 0.1 along z.
std::vector<cv::Point3d> makePoints(int n, cv::RNG& rng)
{
    std::vector<cv::Point3d> points;
    for (int i = 0; i < n; ++i)
        points.emplace_back(rng.uniform(-2., 2.), rng.uniform(-2., 2.), rng.uniform(-2., 2.));
    return points;
}

void addNoise(std::vector<cv::Point3d>& points, cv::RNG& rng)
{
    for (cv::Point3d& p : points)
        p += cv::Point3d(rng.gaussian(0.02), rng.gaussian(0.02), rng.gaussian(0.1));
}

bool pinhole()
{
    cv::RNG rng(1);
    const cv::Matx33d cameraMatrix(800, 0, 320, 0, 800, 240, 0, 0, 1);
    const std::vector<double> distCoeffs = {-0.1, 0.01, 0.001, -0.001};
    std::vector<cv::Point3d> objectPoints = makePoints(100, rng);
    std::vector<cv::Point2d> imagePoints;
    cv::projectPoints(objectPoints, TRUE_RVEC, TRUE_TVEC, cameraMatrix, distCoeffs, imagePoints);
    addNoise(objectPoints, rng);

    cv::Mat rvec, tvec;
    //! [before]
    cv::solvePnP(objectPoints, imagePoints, cameraMatrix, distCoeffs, rvec, tvec);
    //! [before]
    std::cout << "cv::solvePnP:          t = " << tvec.t() << std::endl;

    //! [after]
    cv::gmlpnp::solvePnP(objectPoints, imagePoints, cameraMatrix, distCoeffs, rvec, tvec);
    //! [after]
    std::cout << "cv::gmlpnp::solvePnP:  t = " << tvec.t() << std::endl;

    //! [solve]
    cv::gmlpnp::Result result;
    if (!cv::gmlpnp::solve(objectPoints, imagePoints, cameraMatrix, distCoeffs, result)) {
        std::cerr << "no pose: status " << result.status << std::endl;
        return false;
    }
    //! [solve]

    //! [uncertainty]
    for (int i = 0; i < 3; ++i) {
        const double sigma = std::sqrt(result.poseCovarianceRt.at<double>(3 + i, 3 + i));
        std::cout << "t[" << i << "] = " << result.tvec[i] << " +- " << sigma << std::endl;
    }
    //! [uncertainty]

    //! [noise]
    std::cout << "Covariance of the object points:\n" << result.objectNoise << std::endl;
    std::cout << "Covariance of the rays:\n" << result.bearingNoise << std::endl;
    //! [noise]
    return cv::norm(result.tvec - TRUE_TVEC) < 0.05;
}

bool wide()
{
    cv::RNG rng(2);
    const cv::Matx33d cameraMatrix(300, 0, 640, 0, 300, 480, 0, 0, 1);
    const std::vector<double> distCoeffs = {0.05, -0.01, 0.002, -0.0005};
    //! [camera]
    const cv::Ptr<cv::gmlpnp::CameraModel> camera = cv::gmlpnp::CameraModel::fisheye(cameraMatrix, distCoeffs);
    //! [camera]

    // A lens of 200 degrees in the middle of the points: some are beside the camera, some behind it.
    std::vector<cv::Point3d> objectPoints, cameraPoints;
    cv::Matx33d R;
    cv::Rodrigues(TRUE_RVEC, R);
    const cv::Vec3d inside(0.1, -0.2, 0.3);
    for (const cv::Point3d& p : makePoints(100, rng)) {
        const cv::Vec3d X = R * cv::Vec3d(p.x, p.y, p.z) + inside;
        if (std::atan2(std::hypot(X[0], X[1]), X[2]) > 100 * CV_PI / 180)
            continue;
        objectPoints.push_back(p);
        cameraPoints.emplace_back(X);
    }
    cv::Mat imagePoints;
    camera->project(cameraPoints, imagePoints);
    addNoise(objectPoints, rng);

    //! [wide]
    cv::gmlpnp::Result result;
    const bool found = cv::gmlpnp::solve(objectPoints, imagePoints, camera, result);
    //! [wide]
    std::cout << "Fisheye, " << result.usedPoints << " points: t = " << result.tvec << std::endl;
    return found && cv::norm(result.tvec - inside) < 0.05;
}

}  // namespace

int main()
{
    const bool good = pinhole() && wide();
    std::cout << (good ? "Both poses are right." : "A pose is off.") << std::endl;
    return good ? 0 : 1;
}
