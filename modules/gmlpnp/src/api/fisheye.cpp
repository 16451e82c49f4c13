// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "../arrays/inputs.hpp"
#include "options.hpp"
#include "ransac.hpp"
#include "solvepnp.hpp"

// solvePnP and solvePnPRansac of the fisheye lens: themselves with another camera. No mathematics.

namespace cv {
namespace gmlpnp {
namespace {

// Where the rays of the pixels meet the image plane of K: what a solver for pinhole cameras reads.
Mat_<double> onImagePlane(const CameraModel& camera, const Mat_<double>& pixels, const Matx33d& K)
{
    Mat_<double> plane(pixels.rows, 2);
    for (int i = 0; i < pixels.rows; ++i) {
        Vec3d ray;
        if (!camera.unprojectPoint({pixels(i, 0), pixels(i, 1)}, ray) || !(ray[2] > 0))
            CV_Error(
                Error::StsBadArg,
                format("imagePoints: number %d has no ray in front of the camera, as the flags of OpenCV need", i));
        plane(i, 0) = K(0, 0) * ray[0] / ray[2] + K(0, 2);
        plane(i, 1) = K(1, 1) * ray[1] / ray[2] + K(1, 2);
    }
    return plane;
}

// What a solver for pinhole cameras takes. Without the skew, which the lens has already undone.
struct PinholeView
{
    PinholeView(const CameraModel& camera, InputArray imagePoints, InputArray cameraMatrix)
    {
        const Matx33d M = detail::matrixFrom(cameraMatrix, 3, 3, "cameraMatrix");
        pixels = onImagePlane(camera, detail::pointsFrom(imagePoints, 2, "imagePoints"), M);
        K = Matx33d(M(0, 0), 0, M(0, 2), 0, M(1, 1), M(1, 2), 0, 0, 1);
    }

    Mat_<double> pixels;
    Matx33d K;
};

}  // namespace

bool fisheye::solvePnP(InputArray objectPoints, InputArray imagePoints, InputArray cameraMatrix, InputArray distCoeffs,
                       OutputArray rvec, OutputArray tvec, bool useExtrinsicGuess, int flags, TermCriteria)
{
    const Ptr<CameraModel> camera = CameraModel::fisheye(cameraMatrix, distCoeffs);
    if (!detail::isOpenCVFlag(flags))
        return detail::solvePnPWith(camera, objectPoints, imagePoints, rvec, tvec, useExtrinsicGuess, flags);
    const PinholeView view(*camera, imagePoints, cameraMatrix);
    return cv::solvePnP(objectPoints, view.pixels, view.K, noArray(), rvec, tvec, useExtrinsicGuess, flags);
}

bool fisheye::solvePnPRansac(InputArray objectPoints, InputArray imagePoints, InputArray cameraMatrix,
                             InputArray distCoeffs, OutputArray rvec, OutputArray tvec, bool useExtrinsicGuess,
                             int iterationsCount, float reprojectionError, double confidence, OutputArray inliers,
                             int flags, TermCriteria)
{
    const Ptr<CameraModel> camera = CameraModel::fisheye(cameraMatrix, distCoeffs);
    if (!detail::isOpenCVRansacFlag(flags))
        return detail::solvePnPRansacWith(camera, objectPoints, imagePoints, rvec, tvec, inliers,
                                          detail::ransacParamsOf(iterationsCount, reprojectionError, confidence),
                                          detail::paramsOf(flags, useExtrinsicGuess, rvec, tvec));
    const PinholeView view(*camera, imagePoints, cameraMatrix);
    return cv::solvePnPRansac(objectPoints, view.pixels, view.K, noArray(), rvec, tvec, useExtrinsicGuess,
                              iterationsCount, reprojectionError, confidence, inliers, flags);
}

}  // namespace gmlpnp
}  // namespace cv
