// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_ARRAYS_OUTPUTS_HPP
#define OPENCV_GMLPNP_ARRAYS_OUTPUTS_HPP

#include "../precomp.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

/** The outputs of a call, which come all or not at all: add() makes room for each, which may throw where memory runs
out or an array of fixed size does not fit, and write() hands all of them over and does not. Room that was made and
never written to is given back. (Of UMat and lists other than vector<Mat> the shape may have changed then, not more.) */
class Outputs
{
public:
    Outputs() = default;
    ~Outputs();
    Outputs(const Outputs&) = delete;
    Outputs& operator=(const Outputs&) = delete;

    /** A matrix of one channel. Arrays of fixed type get it in their depth and channels; StsAssert, with `name` in the
    message, where its rows are no elements of theirs. */
    void add(const Mat& value, OutputArray out, const char* name);
    /** 3x1, in the depth of the array that was passed, as cv::solvePnP does it. What a float cannot hold becomes
    CV_64F; StsOutOfRange where the type is fixed. */
    void add(const Vec3d& value, OutputArray out, const char* name);
    /** A list of them: of matrices (3x1, CV_64F), or of the fixed type that was passed (Vec3d, Vec3f, Point3d...);
    StsOutOfRange where that is float and cannot hold them. */
    void add(const std::vector<Vec3d>& values, const _OutputArray& out, const char* name);

    void write();

private:
    struct Entry
    {
        const _OutputArray* out;
        Mat value;
        std::vector<Mat> list;  // of a vector<Mat>
        int before;             // elements of a std::vector
    };
    std::vector<Entry> entries;

    void reserve(const Mat& value, const _OutputArray& out);
};

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_ARRAYS_OUTPUTS_HPP
