// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef GMLPNP_FUZZ_FUZZED_ARGUMENTS_HPP
#define GMLPNP_FUZZ_FUZZED_ARGUMENTS_HPP

#include <string>
#include <vector>

#include <opencv2/gmlpnp.hpp>

#include "bytes.hpp"

// From bytes to the arguments of the public functions: a plain problem, which further bytes spoil.

namespace fuzz {

/** An array as an argument: a matrix in any layout and of any type, a vector of points, a UMat, a list, or none. */
class Array
{
public:
    Array() = default;
    //! `plain` in a form that the bytes choose, some of its numbers and perhaps its shape spoilt.
    Array(Bytes& bytes, const cv::Mat_<double>& plain);

    cv::_InputArray in() const;
    //! Whether the data are still those of the construction, bit for bit.
    bool unchanged() const;

private:
    enum Kind
    {
        MAT,
        VECTOR,
        UMAT,
        LIST,
        NONE
    };
    Kind kind_ = NONE;
    cv::Mat mat_;
    cv::Mat memory_;               //!< mat_ is a part of it
    std::vector<cv::Mat> before_;  //!< copies of data()
    cv::UMat umat_;
    std::vector<cv::Point2d> points2_;
    std::vector<cv::Point3d> points3_;
    std::vector<cv::Mat> list_;

    void arrange(Bytes& bytes, cv::Mat m);
    //! All that a function that gets in() could write to.
    std::vector<cv::Mat> data() const;
};

/** What a call gets. */
struct Arguments
{
    Array objectPoints, imagePoints, rays, cameraMatrix, distCoeffs;
    cv::Ptr<cv::gmlpnp::CameraModel> camera;
    cv::gmlpnp::Params params;
    cv::Vec3d rvec, tvec;  //!< a guess

    explicit Arguments(Bytes& bytes);
    bool unchanged() const;
};

/** Options of RANSAC; the iterations are few enough for a fuzzer. */
cv::gmlpnp::RansacParams ransacFrom(Bytes& bytes);

/** One of the lenses, of the caller's own that gives what it likes, or null. */
cv::Ptr<cv::gmlpnp::CameraModel> lensFrom(Bytes& bytes);

/** A vector as an output, with a value in it: of any matrix type, fixed or not. */
class Output
{
public:
    Output(Bytes& bytes, const cv::Vec3d& value);

    cv::_InputOutputArray ref();
    bool unchanged() const;
    //! Whether it holds three finite numbers.
    bool finite() const;

private:
    bool fixed_;
    cv::Vec3d vec_, vecBefore_;
    cv::Mat mat_, matBefore_;
};

/** A matrix of any size, type and content. */
cv::Mat anyMat(Bytes& bytes);

/** Whether two matrices are equal in type, shape and every bit. */
bool sameBits(const cv::Mat& a, const cv::Mat& b);

}  // namespace fuzz

#endif  // GMLPNP_FUZZ_FUZZED_ARGUMENTS_HPP
