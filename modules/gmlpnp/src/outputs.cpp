// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "precomp.hpp"

#include "outputs.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

namespace {

bool fits(const Mat& array, const Mat& value)
{
    return array.size == value.size && array.type() == value.type();
}

// Into the caller's memory where it fits, which needs no memory; else the caller's header takes the value's.
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
    for (const Entry& entry : entries)
        if (entry.out->kind() == _InputArray::STD_VECTOR && entry.before < static_cast<int>(entry.out->total()))
            entry.out->create(entry.before, 1, entry.out->type());  // shorter: no memory needed
}

void Outputs::reserve(const Mat& value, OutputArray out)
{
    const int before = out.kind() == _InputArray::STD_VECTOR ? static_cast<int>(out.total()) : 0;
    entries.push_back({&out, value, {}, before});
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

void Outputs::add(const Vec3d& value, OutputArray out, const char* name)
{
    const int depth = out.empty() && !out.fixedType() ? CV_64F : out.depth();
    Mat column;
    Mat(value, false).convertTo(column, depth == CV_32F ? CV_32F : CV_64F);
    add(column, out, name);
}

void Outputs::add(const std::vector<Vec3d>& values, OutputArrayOfArrays out, const char* name)
{
    if (out.kind() == _InputArray::STD_VECTOR)
        return add(Mat(values).reshape(1), out, name);
    const int n = static_cast<int>(values.size()), depth = out.fixedType() ? out.depth() : CV_64F;
    std::vector<Mat> list(n);
    for (int i = 0; i < n; ++i)
        Mat(values[i]).convertTo(list[i], depth);
    entries.push_back({&out, Mat(), list, 0});
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
    for (Entry& entry : entries) {
        const _OutputArray& out = *entry.out;
        if (!entry.list.empty())
            writeList(entry.list, out);
        else if (out.kind() == _InputArray::MAT && !out.fixedSize())
            assign(entry.value, out.getMatRef());
        else {
            out.create(entry.value.size(), entry.value.type());  // there is room: a longer std::vector becomes shorter
            entry.value.copyTo(out);
        }
    }
    entries.clear();
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
