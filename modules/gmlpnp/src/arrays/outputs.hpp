// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_ARRAYS_OUTPUTS_HPP
#define OPENCV_GMLPNP_ARRAYS_OUTPUTS_HPP

#include "../precomp.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

/** The outputs of a call, which come all or not at all. add() makes room for each output; it may throw where memory
runs out or an array of fixed size does not fit. write() hands all of them over and does not throw. The destructor gives
back room that was never written to. Only the shape of a UMat, and of a list other than vector<Mat>, may have changed
then. */
class Outputs
{
public:
    Outputs() = default;
    ~Outputs();
    Outputs(const Outputs&) = delete;
    Outputs& operator=(const Outputs&) = delete;

    /** Adds a matrix of one channel. An array of fixed type gets it in its own depth and channels.
    @throws cv::Exception StsAssert, with `name` in the message, where a row does not fit into an element. */
    void add(const Mat& value, OutputArray out, const char* name);
    /** Adds a 3x1 vector in the depth of the array that was passed, as cv::solvePnP does it. A value beyond the range
    of a float becomes CV_64F.
    @throws cv::Exception StsOutOfRange where the type is fixed and float, and cannot hold the value. */
    void add(const Vec3d& value, OutputArray out, const char* name);
    /** Adds a list of vectors: as matrices (3x1, CV_64F), or as the fixed type that was passed (Vec3d, Vec3f,
    Point3d...).
    @throws cv::Exception StsOutOfRange where that type is float and cannot hold a value. */
    void add(const std::vector<Vec3d>& values, const _OutputArray& out, const char* name);

    /** Writes all outputs that were added. */
    void write();

private:
    struct Entry
    {
        const _OutputArray* out;
        Mat value;
        std::vector<Mat> list;  // filled for a list of vectors, where `value` is empty
        int before;             // elements that a std::vector had
    };
    std::vector<Entry> entries_;

    void reserve(const Mat& value, const _OutputArray& out);
};

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_ARRAYS_OUTPUTS_HPP
