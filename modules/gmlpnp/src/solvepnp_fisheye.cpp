// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "precomp.hpp"

#include "arrays.hpp"
#include "solvepnp.hpp"

// solvePnP of the fisheye lens: solvePnP itself with another camera. No mathematics.

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

}  // namespace

bool fisheye::solvePnP(InputArray objectPoints, InputArray imagePoints, InputArray cameraMatrix, InputArray distCoeffs,
                       OutputArray rvec, OutputArray tvec, bool useExtrinsicGuess, int flags, TermCriteria)
{
    const Ptr<CameraModel> camera = CameraModel::fisheye(cameraMatrix, distCoeffs);
    if (!detail::isOpenCVFlag(flags))
        return detail::solvePnPWith(camera, objectPoints, imagePoints, rvec, tvec, useExtrinsicGuess, flags);
    const Matx33d K = detail::matrixFrom(cameraMatrix, 3, 3, "cameraMatrix");
    const Mat_<double> plane = onImagePlane(*camera, detail::pointsFrom(imagePoints, 2, "imagePoints"), K);
    // Without the skew, which the lens has already undone.
    const Matx33d pinhole(K(0, 0), 0, K(0, 2), 0, K(1, 1), K(1, 2), 0, 0, 1);
    return cv::solvePnP(objectPoints, plane, pinhole, noArray(), rvec, tvec, useExtrinsicGuess, flags);
}

}  // namespace gmlpnp
}  // namespace cv
