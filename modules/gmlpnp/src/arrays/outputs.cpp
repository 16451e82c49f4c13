// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "outputs.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

namespace {

bool fits(const Mat& array, const Mat& value)
{
    return array.size == value.size && array.type() == value.type();
}

// Copies into the caller's array where the value fits, which needs no memory. Otherwise the caller's header takes over
// the value's memory.
void assign(const Mat& value, Mat& array)
{
    if (fits(array, value))
        value.copyTo(array);
    else
        array = value;
}

}  // namespace

Outputs::~Outputs()
{
    for (const Entry& entry : entries_)
        if (entry.out->kind() == _InputArray::STD_VECTOR && entry.before < static_cast<int>(entry.out->total()))
            entry.out->create(entry.before, 1, entry.out->type());  // a shorter vector needs no memory
}

void Outputs::reserve(const Mat& value, const _OutputArray& out)
{
    const int before = out.kind() == _InputArray::STD_VECTOR ? static_cast<int>(out.total()) : 0;
    entries_.push_back({&out, value, {}, before});
    if (out.kind() == _InputArray::MAT && !out.fixedSize())
        return;
    if (out.kind() != _InputArray::STD_VECTOR || static_cast<int>(value.total()) > before)
        out.create(value.size(), value.type());
}

void Outputs::add(const Mat& value, OutputArray out, const char* name)
{
    if (!out.needed())
        return;
    if (!out.fixedType() || out.type() == value.type())
        return reserve(value, out);
    if (out.channels() != 1 && out.channels() != value.cols)
        CV_Error(Error::StsAssert, format("'%s' needs %d numbers per point", name, value.cols));
    Mat converted;
    value.reshape(out.channels()).convertTo(converted, out.depth());
    reserve(converted, out);
}

namespace {

// Says whether every number lies within the range of a float.
bool fitsFloat(const Vec3d& value)
{
    constexpr double LARGEST_FLOAT = std::numeric_limits<float>::max();
    return norm(value, NORM_INF) <= LARGEST_FLOAT;
}

void requireFit(const Vec3d& value, int depth, const char* name)
{
    if (depth == CV_32F && !fitsFloat(value))
        CV_Error(Error::StsOutOfRange, format("'%s' is of float, which ends before %g", name, norm(value, NORM_INF)));
}

}  // namespace

void Outputs::add(const Vec3d& value, OutputArray out, const char* name)
{
    const bool isFloat = (out.fixedType() || !out.empty()) && out.depth() == CV_32F;
    if (out.fixedType())
        requireFit(value, out.depth(), name);
    Mat column;
    Mat(value, false).convertTo(column, isFloat && fitsFloat(value) ? CV_32F : CV_64F);
    add(column, out, name);
}

void Outputs::add(const std::vector<Vec3d>& values, const _OutputArray& out, const char* name)
{
    const int n = static_cast<int>(values.size()), depth = out.fixedType() ? out.depth() : CV_64F;
    for (const Vec3d& value : values)
        requireFit(value, depth, name);
    if (out.kind() == _InputArray::STD_VECTOR)
        return add(Mat(values).reshape(1), out, name);
    std::vector<Mat> list(n);
    for (int i = 0; i < n; ++i)
        Mat(values[i]).convertTo(list[i], depth);
    entries_.push_back({&out, Mat(), list, 0});
    if (out.kind() == _InputArray::STD_VECTOR_MAT && !out.fixedSize())
        return;
    out.create(n, 1, depth);
    for (int i = 0; i < n; ++i)
        out.create(3, 1, depth, i);
}

namespace {

void writeList(std::vector<Mat>& list, OutputArrayOfArrays out)
{
    if (out.kind() != _InputArray::STD_VECTOR_MAT || out.fixedSize()) {
        for (size_t i = 0; i < list.size(); ++i)
            list[i].copyTo(out.getMat(static_cast<int>(i)));
        return;
    }
    std::vector<Mat>& callers = *static_cast<std::vector<Mat>*>(out.getObj());
    for (size_t i = 0; i < std::min(list.size(), callers.size()); ++i) {
        assign(list[i], callers[i]);
        list[i] = callers[i];
    }
    callers.swap(list);
}

}  // namespace

void Outputs::write()
{
    for (Entry& entry : entries_) {
        const _OutputArray& out = *entry.out;
        if (!entry.list.empty())
            writeList(entry.list, out);
        else if (out.kind() == _InputArray::MAT && !out.fixedSize())
            assign(entry.value, out.getMatRef());
        else {
            out.create(entry.value.size(),
                       entry.value.type());  // there is room, and a std::vector that is too long becomes shorter
            entry.value.copyTo(out);
        }
    }
    entries_.clear();
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
