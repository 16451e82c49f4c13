// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_CAMERA_HPP
#define OPENCV_GMLPNP_CAMERA_HPP

#include "opencv2/gmlpnp/compat.hpp"

namespace cv {
namespace gmlpnp {

//! @addtogroup gmlpnp
//! @{

/** @brief A lens turns pixels into unit rays and points into pixels. The solver sees only its rays.

Camera frame: x right, y down, z forward along the optical axis; the ray of a pixel starts at the centre of
projection. Pixels are OpenCV's: (0, 0) is the centre of the top-left pixel. A camera never changes after its
construction and may be used from several threads at once.

Every lens documents its valid domain: the directions that it sees. A pixel without a ray and a point without a pixel
are reported as such, and never as NaN or a stand-in value. Inside the domain unproject() and project() are inverses of
each other, to 1e-12 on the image plane of focal length 1.

Below, (x, y) is a point of that plane: u = fx x + skew y + cx, v = fy y + cy, with the skew K(0, 1); r^2 = x^2 + y^2.
A camera matrix is 3x3 of any numeric depth. The factories throw cv::Exception: StsAssert (-215) for a wrong shape or
count, StsBadArg (-5) for a focal length of zero (less than 1e-30), values that are not finite (more than 1e30) or
parameters out of their range. The message names the argument.

For a lens of your own, derive from this class and implement unprojectPoint() and projectPoint().
*/
class CV_EXPORTS_W CameraModel
{
public:
    virtual ~CameraModel();

    /** @brief Makes the pinhole camera of cv::projectPoints. Its distortion is inverted to convergence.

        (a, b) = (X, Y) / Z,   r^2 = a^2 + b^2,   R = (1 + k1 r^2 + k2 r^4 + k3 r^6) / (1 + k4 r^2 + k5 r^4 + k6 r^6)
        x = a R + 2 p1 a b + p2 (r^2 + 2 a^2) + s1 r^2 + s2 r^4
        y = b R + p1 (r^2 + 2 b^2) + 2 p2 a b + s3 r^2 + s4 r^4

    With tau_x or tau_y the homography of the tilted sensor follows, which is inverted in closed form.

    Valid domain: Z > 0, and (a, b) up to where the distortion stops being one-to-one. On the way out from the centre,
    its Jacobian first loses rank there. Beyond, the formula folds points back into the picture (cv::projectPoints
    returns them, cv::undistortPoints may land there). All finite pixels of an undistorted camera have a ray.
    @param K camera matrix; only fx, fy, cx, cy are used and the skew is not, as everywhere in OpenCV.
    @param D distortion coefficients (k1, k2, p1, p2[, k3[, k4, k5, k6[, s1, s2, s3, s4[, tau_x, tau_y]]]]):
    0, 4, 5, 8, 12 or 14 of them. */
    CV_WRAP static Ptr<CameraModel> pinhole(InputArray K, InputArray D = noArray());

    /** @brief Makes the Kannala-Brandt camera of cv::fisheye, on the whole sphere.

        theta = atan2(sqrt(X^2 + Y^2), Z),   theta_d = theta (1 + k1 theta^2 + k2 theta^4 + k3 theta^6 + k4 theta^8)
        (x, y) = theta_d (X, Y) / sqrt(X^2 + Y^2)

    cv::fisheye::projectPoints loses the sign of Z, so the two agree for Z > 0 only; cv::fisheye::undistortPoints stops
    at 90 degrees.

    Valid domain: theta below the first turning point of theta_d and below pi.
    @param K camera matrix; its skew K(0, 1) is used and is fx alpha of cv::fisheye.
    @param D k1, k2, k3, k4, or none. */
    CV_WRAP static Ptr<CameraModel> fisheye(InputArray K, InputArray D = noArray());

    /** @brief Makes the unified (MEI) camera of cv::omnidir, for fisheye and catadioptric lenses.

        m = (X, Y, Z) / |X|,   (a, b) = (m1, m2) / (m3 + xi),   r^2 = a^2 + b^2
        x = a (1 + k1 r^2 + k2 r^4) + 2 p1 a b + p2 (r^2 + 2 a^2)
        y = b (1 + k1 r^2 + k2 r^4) + p1 (r^2 + 2 b^2) + 2 p2 a b

    cv::omnidir::undistortPoints returns plane coordinates, so it ends at 90 degrees, and it always iterates 20 times.

    Valid domain: m3 > -w, w = xi for xi <= 1, else 1 / xi; and (a, b) up to where the distortion stops being
    one-to-one, as in pinhole().
    @param K camera matrix with skew.
    @param D k1, k2, p1, p2, or none.
    @param xi mirror parameter, 0 <= xi <= 1e6; 0 makes it a pinhole. */
    CV_WRAP static Ptr<CameraModel> omnidir(InputArray K, InputArray D, double xi);

    /** @brief Makes the enhanced unified camera of Khomutenko et al. 2016.

        d = sqrt(beta (X^2 + Y^2) + Z^2),   (x, y) = (X, Y) / (alpha d + (1 - alpha) Z)

    Valid domain: Z > -w d, w = alpha / (1 - alpha) for alpha <= 1/2, else (1 - alpha) / alpha. For alpha <= 1/2 all
    pixels have a ray, else those with r^2 < 1 / (beta (2 alpha - 1)).
    @param K camera matrix with skew.
    @param alpha from 0 (pinhole) to 1.
    @param beta from 1e-9 to 1e9. */
    CV_WRAP static Ptr<CameraModel> eucm(InputArray K, double alpha, double beta);

    /** @brief Makes the double sphere camera of Usenko et al. 2018.

        d1 = |X|,   z1 = xi d1 + Z,   d2 = sqrt(X^2 + Y^2 + z1^2),   (x, y) = (X, Y) / (alpha d2 + (1 - alpha) z1)

    Valid domain: z1 > -w d2, w = alpha / (1 - alpha) for alpha <= 1/2, else (1 - alpha) / alpha. For alpha <= 1/2 all
    pixels have a ray, else those with r^2 < 1 / (2 alpha - 1). On this domain the model is one-to-one. The paper's
    closed form of it, Z > -w2 d1, is up to several degrees off where w < 1.
    @param K camera matrix with skew.
    @param xi distance of the two spheres, -1 < xi < 1.
    @param alpha from 0 to 1. */
    CV_WRAP static Ptr<CameraModel> doubleSphere(InputArray K, double xi, double alpha);

    /** @brief Makes an equirectangular panorama, which sees every direction. The optical axis is in the middle of the
    picture.

        u = (1/2 + atan2(X, Z) / (2 pi)) width - 1/2,   v = (1/2 + atan2(Y, sqrt(X^2 + Z^2)) / pi) height - 1/2

    Centres of pixels lie at integers; the width spans 2 pi, the height pi. A video stitched at another origin or axis
    differs by a rotation.

    Valid domain: every direction; every u, because the picture continues around, and v in [-1/2, height - 1/2]. At
    these two edges, the poles, all u have the same ray: the Jacobian has rank 1, and project() returns the middle u.
    @param size width and height of the whole panorama, px. */
    CV_WRAP static Ptr<CameraModel> equirectangular(const Size& size);

    /** @brief Reads a camera from a file. It is one that write() wrote, or one of these calibrations.

    - OpenCV: `K`, `camera_matrix` or `cameraMatrix`, and `D`, `distortion_coefficients` or `distCoeffs`; with `xi` it
      is omnidir(), with `fisheye_model: 1` it is fisheye(). Files with `distortion_model` (plumb_bob,
      rational_polynomial, equidistant, fisheye) are read too.
    - `model_type: MEI` with `mirror_parameters`, `distortion_parameters` and `projection_parameters`, as in KITTI-360.

    @param node the mapping that holds the camera.
    @param model the lens where the file does not name one: "pinhole" (default) or "fisheye", whose files look alike.
    @return the camera.
    @throws cv::Exception StsParseError where a field is missing or has the wrong form, and the message names it; the
    factory's own exceptions. */
    static Ptr<CameraModel> read(const FileNode& node, const String& model = String());

    /** @brief Calls read() on a file in YAML, XML or JSON: on its entry `camera`, or else on its top level.

    YAML without its `%YAML` line and with tabs is accepted.
    @param filename the file.
    @param model as in read().
    @return the camera.
    @throws cv::Exception as in read(), and StsObjectNotFound where the file cannot be opened; the message starts with
    the file's name. */
    CV_WRAP static Ptr<CameraModel> load(const String& filename, const String& model = String());

    /** @brief Writes the camera into the mapping that is open in `fs`, so that read() gives an equal camera.

        fs << "camera" << "{"; camera->write(fs); fs << "}";

    @throws cv::Exception StsNotImplemented where the lens is the caller's own and does not override this. */
    virtual void write(FileStorage& fs) const;

    /** @brief Finds the unit rays of pixels.
    @param imagePoints N pixels: Nx2, Nx1 or 1xN with 2 channels, or a vector of points; float or double.
    @param rays Nx3, CV_64F: unit rays in the camera frame; zero where a pixel has no ray.
    @param valid Nx1, CV_8U: 255 where the pixel has a ray, 0 where it has none.
    @param jacobian Nx6, CV_64F: the 3x2 derivative of the ray with respect to the pixel, row-major; its two
    columns are tangent to the unit sphere at the ray.
    @throws cv::Exception StsAssert for a wrong shape or depth. */
    CV_WRAP virtual void unproject(InputArray imagePoints, OutputArray rays, OutputArray valid = noArray(),
                                   OutputArray jacobian = noArray()) const;

    /** @brief Finds the pixels of points in the camera frame.
    @param points N points: Nx3, Nx1 or 1xN with 3 channels, or a vector of points; float or double.
    @param imagePoints Nx2, CV_64F: pixels; zero where the lens does not see the point.
    @param valid Nx1, CV_8U: 255 where the lens sees the point, 0 where it does not.
    @throws cv::Exception StsAssert for a wrong shape or depth. */
    CV_WRAP virtual void project(InputArray points, OutputArray imagePoints, OutputArray valid = noArray()) const;

    /** @brief Finds the unit ray of one pixel.
    @param pixel image point, px.
    @param ray unit ray, camera frame; untouched where there is none.
    @param jacobian derivative of the ray with respect to the pixel (3x2), or null.
    @return whether the pixel has a ray. */
    virtual bool unprojectPoint(const Point2d& pixel, Vec3d& ray, Matx32d* jacobian = nullptr) const = 0;

    /** @brief Finds the unit rays of many pixels. unproject() calls it. It calls unprojectPoint() for each pixel;
    override it where a lens has a faster way.
    @param pixels image points, px.
    @param count the number of pixels.
    @param rays unit rays, camera frame; zero where there is none.
    @param valid 255 where the pixel has a ray, 0 where it has none. */
    virtual void unprojectPoints(const Point2d* pixels, int count, Vec3d* rays, uchar* valid) const;

    /** @brief Returns the angle that a pixel spans at each ray, over the angle of a pixel on the optical axis.

    An error in pixels turns into an error in bearing by this scale, so the solvers scale Gamma by its square. With the
    scale of a pinhole, cos(theta), the noise of a pixel is then one Gamma all over the picture. A pixel spans two
    angles; the scale takes the angle around the axis, sin(theta) / r for the radius r on the plane of focal length 1.
    It may leave the distortion out.
    @param rays unit rays, camera frame.
    @param count the number of rays.
    @param scales receives the scales. A lens that does not override this has a scale of 1 everywhere. */
    virtual void angularScales(const Vec3d* rays, int count, double* scales) const;

    /** @brief Finds the pixel of one point of the camera frame. The length of the point does not matter.
    @param point point or ray, camera frame.
    @param pixel image point, px; untouched where the lens does not see the point.
    @return whether the lens sees the point. */
    virtual bool projectPoint(const Vec3d& point, Point2d& pixel) const = 0;
};

//! @}

}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_CAMERA_HPP
