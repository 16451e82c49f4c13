// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_RAYS_CORRESPONDENCES_HPP
#define OPENCV_GMLPNP_RAYS_CORRESPONDENCES_HPP

#include "../kernels/kernels.hpp"
#include "../math/spd3.hpp"
#include "observations.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

/** Object points and unit rays as a structure of arrays, points centred and scaled:  p = centre + scale * p'.

The solver works on p' alone (UTM, ECEF and millimetres then look the same); toObject() and its kin undo it:
X = R p + t = scale (R p' + t'),  so  t = scale t' - R centre,  delta = scale delta',  Sigma = scale^2 Sigma'. */
class Correspondences
{
public:
    /** Both N x 3; rays need not be unit. Of what is not finite() nothing else may be asked.
    Known covariances of each point, N x 9 or empty: of the object points, object frame, length^2, and of the rays,
    camera frame, rad^2.
    @param scaled whether rays are as long as their angular scales: by the squares Gamma differs from ray to ray. */
    CV_EXPORTS Correspondences(const Mat_<double>& objectPoints, const Mat_<double>& rays,
                               const Mat_<double>& objectCovariances = {}, const Mat_<double>& rayCovariances = {},
                               bool scaled = false);
    explicit Correspondences(const Observations& observations)
        : Correspondences(observations.points, observations.rays, observations.objectCovariances,
                          observations.rayCovariances, observations.scaled)
    {}

    /** `count` of the points, one drawn from each stretch of the caller's order (always the same ones), with the centre
    and the scale of all: poses and noises of the part are those of the whole. */
    CV_EXPORTS Correspondences part(int count) const;

    int size() const { return static_cast<int>(columns.rows()); }
    /** For the kernels; valid as long as this object. */
    CV_EXPORTS PointArrays arrays() const;
    Vector3d pointAt(int i) const { return columns.row(i).head<3>(); }
    /** As long as its angular scale k. What a pass adds up holds for rays of any length: with  m' = k m  the depth
    s' = k s  makes of  s'^2 Gamma  the  s^2 k^2 Gamma  that is meant, while c, z and Q stay as they are. Only D is k^2
    times as large (logAngularScales()), and the known covariances of rays are kept divided by k^2. */
    Vector3d rayAt(int i) const { return columns.row(i).tail<3>(); }
    /** sum log k: what L is too large by. */
    CV_EXPORTS double logAngularScales() const;

    bool hasKnown() const { return known.rows() > 0; }
    Matrix3d knownObject(int i) const { return knownAt(i, 0); }
    Matrix3d knownRay(int i) const { return knownAt(i, 6); }

    /** Whether every point and ray was finite, the object not of a size that covariances have no numbers for, and no
    ray zero. */
    CV_EXPORTS bool finite() const;

    /** Whether no pose can follow: points on one line or at one place, or rays all in one direction. */
    CV_EXPORTS bool degenerate() const;

    /** Whether the points are at so many distinct places, up to 4; nearer than a millionth of the object is the same.
     */
    CV_EXPORTS bool hasPlaces(int wanted) const;

    CV_EXPORTS Pose toObject(const Pose& normalised) const;
    CV_EXPORTS Pose fromObject(const Pose& pose) const;

    Vector3d centre;
    double scale = 0;  //!< root mean square distance of the points from their centre, the caller's length

private:
    Correspondences() = default;
    void prepare(const Vector3d& origin);
    void setKnown(const Mat_<double>& objectCovariances, const Mat_<double>& rayCovariances);
    CV_EXPORTS Matrix3d knownAt(int i, int first) const;

    Eigen::Matrix<double, Eigen::Dynamic, 6> columns;  // px py pz mx my mz
    // Entries 0..5 (xx xy xz yy yz zz) of the known object covariance, 6..11 of the known ray covariance; no rows:
    // none.
    Eigen::Matrix<double, Eigen::Dynamic, 12> known;
    bool scaled = false;  // whether the rays are as long as their angular scales, not unit
    ColumnSums sums;      // the scatter in units of scale^2
};

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_RAYS_CORRESPONDENCES_HPP
