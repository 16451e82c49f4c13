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

/** Object points and rays as a structure of arrays. The points are centred and scaled:  p = centre + scale * p'.

The solver works on p' alone, so UTM, ECEF and millimetres look the same to it. toObject() and its kin undo it:
X = R p + t = scale (R p' + t'),  so  t = scale t' - R centre,  delta = scale delta',  Sigma = scale^2 Sigma'.

The rays are as long as their angular scales k, where the observations say so. What a pass adds up holds for rays of any
length: with  m' = k m  the depth  s' = k s  makes of  s'^2 Gamma  the  s^2 k^2 Gamma  that is meant, while c, z and Q
stay as they are. Only D is k^2 times as large (logAngularScales()), and the known covariances of rays are kept divided
by k^2. */
class Correspondences
{
public:
    /** Of observations that are not finite() nothing else may be asked. */
    CV_EXPORTS explicit Correspondences(const Observations& observations);
    Correspondences(const Mat_<double>& objectPoints, const Mat_<double>& rays)
        : Correspondences(Observations{objectPoints, rays, {}, {}, false})
    {}

    /** `count` of the points, one drawn from each stretch of the caller's order (always the same ones), with the centre
    and the scale of all. Poses and noises of the part are those of the whole. */
    CV_EXPORTS Correspondences part(int count) const;

    /** The chosen rows with a centre and a scale of their own, relative to the same object frame. */
    CV_EXPORTS Correspondences subset(const std::vector<int>& rows) const;

    int size() const { return static_cast<int>(columns_.rows()); }
    /** The columns for the kernels. They are valid as long as this object. */
    CV_EXPORTS PointArrays arrays() const;
    Vector3d pointAt(int i) const { return columns_.row(i).head<3>(); }
    /** As long as its angular scale k, or of length 1 where the observations have none. */
    Vector3d scaledRayAt(int i) const { return columns_.row(i).tail<3>(); }
    Vector3d unitRayAt(int i) const { return scaledRayAt(i).normalized(); }
    /** sum log k, by which L comes out too large. */
    CV_EXPORTS double logAngularScales() const;

    bool hasKnown() const { return known_.rows() > 0; }
    Matrix3d knownObject(int i) const { return knownAt(i, 0); }
    Matrix3d knownRay(int i) const { return knownAt(i, 6); }

    /** Whether every point and ray was finite, no ray was zero, and the object is of a size for which covariances have
    numbers. */
    CV_EXPORTS bool finite() const;

    /** Whether no pose can follow: points on one line or at one place, or rays all in one direction. */
    CV_EXPORTS bool degenerate() const;

    /** Whether the points are at so many distinct places, up to 4. Places within a millionth of the object are one. */
    CV_EXPORTS bool hasPlaces(int wanted) const;

    CV_EXPORTS Pose toObject(const Pose& normalised) const;
    CV_EXPORTS Pose fromObject(const Pose& pose) const;

    Vector3d centre;
    double scale = 0;  //!< root mean square distance of the points from their centre, the caller's length

private:
    Correspondences() = default;
    Correspondences gathered(const std::vector<int>& rows) const;
    void normalise();
    void prepare(const Vector3d& origin);
    void takeScaledRays(const Correspondences& from, const std::vector<int>& rows);
    void setKnown(const Mat_<double>& objectCovariances, const Mat_<double>& rayCovariances);
    CV_EXPORTS Matrix3d knownAt(int i, int first) const;

    Eigen::Matrix<double, Eigen::Dynamic, 6> columns_;  // px py pz mx my mz
    // Entries 0..5 (xx xy xz yy yz zz) are those of the known object covariance, 6..11 those of the known ray
    // covariance. Without known covariances there are no rows.
    Eigen::Matrix<double, Eigen::Dynamic, 12> known_;
    bool scaled_ = false;  // whether the rays are as long as their angular scales, not unit
    ColumnSums sums_;      // the scatter in units of scale^2, the rest of unit rays
};

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_RAYS_CORRESPONDENCES_HPP
