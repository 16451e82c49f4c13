// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_TEST_SCENES_HPP
#define OPENCV_GMLPNP_TEST_SCENES_HPP

#include "test_precomp.hpp"

#include "../src/estimator/solve.hpp"
#include "synthetic.hpp"

// Pose assertions and what else the tests share; the synthetic problems are in synthetic.hpp.

namespace opencv_test {

using namespace synthetic;
using cv::gmlpnp::detail::Matrix3d;
using cv::gmlpnp::detail::Matrix6d;
using cv::gmlpnp::detail::Pose;
using cv::gmlpnp::detail::Vector3d;
using cv::gmlpnp::detail::Vector6d;
using synthetic::poseOf;

/** A generator seeded from the name of the running test and its cell: fixed, and another for each. */
cv::RNG testRng();
uint64_t testSeed();

Pose poseOf(const cv::gmlpnp::Result& result);

/** Both errors at most the bounds [rad, length]; fails on NaN. */
testing::AssertionResult poseNear(const Pose& pose, const Pose& truth, double angle, double distance);
testing::AssertionResult poseNear(const cv::gmlpnp::Result& result, const Pose& truth, double angle, double distance);

/** Largest difference of entries at most `bound`; fails on NaN and on other shapes. */
template <class A, class B>
testing::AssertionResult matrixNear(const Eigen::MatrixBase<A>& a, const Eigen::MatrixBase<B>& b, double bound)
{
    const double worst = (a - b).cwiseAbs().maxCoeff();
    if (a.allFinite() && b.allFinite() && worst <= bound)
        return testing::AssertionSuccess();
    return testing::AssertionFailure() << "differ by " << worst << " > " << bound << "\n" << a << "\nand\n" << b;
}

inline constexpr int METHODS[] = {cv::gmlpnp::SOLVEPNP_GMLPNP, cv::gmlpnp::SOLVEPNP_GMLPNP_MARGINAL};

inline cv::gmlpnp::Params paramsOf(int method)
{
    cv::gmlpnp::Params params;
    params.method = method;
    return params;
}

/** The result of a solve that must succeed: of rays, or of the pixels of the scene in paperCamera(). */
cv::gmlpnp::Result solved(const cv::Mat_<double>& points, const cv::Mat_<double>& rays,
                          const cv::gmlpnp::Params& params = cv::gmlpnp::Params());
cv::gmlpnp::Result solved(const Scene& scene, const cv::gmlpnp::Params& params = cv::gmlpnp::Params());
cv::gmlpnp::Result solvedPixels(const Scene& scene, const cv::gmlpnp::Params& params = cv::gmlpnp::Params());

/** Distance of the translation from the true one. */
double distance(const cv::gmlpnp::Result& result, const Scene& scene);

Matrix3d matrix3(const cv::Mat& m);
Matrix6d matrix6(const cv::Mat& m);

/** Squared deviation of `a` from `b` in units of a covariance of the pose; chi-squared with 6 degrees of freedom where
that is true (NEES, of the truth and an estimate). */
double mahalanobis2(const Pose& a, const Pose& b, const cv::Mat& poseCovariance);

/** A lens as a caller writes it who knows nothing of angular scales: its pixels are rays and nothing else. */
class PlainLens : public cv::gmlpnp::CameraModel
{
public:
    explicit PlainLens(const cv::Ptr<CameraModel>& lens_) : lens(lens_) {}
    bool unprojectPoint(const cv::Point2d& pixel, cv::Vec3d& ray, cv::Matx32d* jacobian) const override
    {
        return lens->unprojectPoint(pixel, ray, jacobian);
    }
    bool projectPoint(const cv::Vec3d& point, cv::Point2d& pixel) const override
    {
        return lens->projectPoint(point, pixel);
    }

private:
    cv::Ptr<CameraModel> lens;
};

}  // namespace opencv_test

#endif  // OPENCV_GMLPNP_TEST_SCENES_HPP
