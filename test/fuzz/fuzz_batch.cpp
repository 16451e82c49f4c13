// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "fuzzed_arguments.hpp"
#include "outcome.hpp"

// solveBatch: lists of any arrays, as long as each other or not.

namespace {

using namespace fuzz;
namespace gmlpnp = cv::gmlpnp;
using gmlpnp::Result;

/** Arrays as an argument: a list of matrices, of UMat or of vectors, an array by itself, or none. */
class List
{
public:
    List(Bytes& bytes, const std::vector<cv::Mat>& arrays)
        : mats_(arrays), kind_(bytes.pick({MATS, MATS, MATS, UMATS, UMATS, VECTORS, ONE, NONE}))
    {
        if (bytes.between(0, 7) == 7 && !mats_.empty())
            mats_.pop_back();
        for (const cv::Mat& m : mats_) {
            umats_.emplace_back();
            m.copyTo(umats_.back());
            vectors_.emplace_back();
            if (m.dims == 2 && m.cols == 3 && m.type() == CV_64F)
                m.reshape(3).copyTo(vectors_.back());
        }
    }

    cv::_InputArray in() const
    {
        switch (kind_) {
            case UMATS:
                return {umats_};
            case VECTORS:
                return {vectors_};
            case ONE:
                return mats_.empty() ? cv::_InputArray(cv::noArray()) : cv::_InputArray(mats_[0]);
            case NONE:
                return cv::noArray();
            default:
                return {mats_};
        }
    }

private:
    enum Kind
    {
        MATS,
        UMATS,
        VECTORS,
        ONE,
        NONE
    };

    std::vector<cv::Mat> mats_;
    std::vector<cv::UMat> umats_;
    std::vector<std::vector<cv::Point3d>> vectors_;
    Kind kind_;
};

// A list among them counts by its elements, so that it makes the lists differ in length.
std::vector<cv::Mat> arraysOf(const std::vector<Arguments>& problems, const Array Arguments::*which)
{
    std::vector<cv::Mat> all;
    for (const Arguments& problem : problems) {
        const cv::_InputArray array = (problem.*which).in();
        std::vector<cv::Mat> some(1);
        if (array.isMatVector())
            array.getMatVector(some);
        else
            some[0] = array.getMat();
        all.insert(all.end(), some.begin(), some.end());
    }
    return all;
}

// Of each problem the result is that of solveRays().
void requireResults(int count, const std::vector<Result>& results, const cv::_InputArray& points,
                    const cv::_InputArray& rays, const gmlpnp::Params& params)
{
    std::vector<cv::Mat> p, m;
    points.getMatVector(p);
    rays.getMatVector(m);
    require(results.size() == p.size(), "a result for each problem");
    for (size_t k = 0; k < results.size(); ++k) {
        Result alone;
        if (p[k].empty() && m[k].empty()) {  // misuse of that, but not of a batch
            require(results[k].status == gmlpnp::STATUS_TOO_FEW_POINTS, "a problem without points");
            continue;
        }
        if (gmlpnp::solveRays(p[k], m[k], alone, params)) {
            requireSound(results[k]);
            --count;
        }
        require(same(alone, results[k]), "the results of solveRays");
    }
    require(count == 0, "the number of poses");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    Bytes bytes(data, size);
    const int count = bytes.pick({2, 3, 1, 4, 0});
    std::vector<Arguments> problems;
    problems.reserve(static_cast<size_t>(count));  // a vector of points that moved would leave its cv::Mat behind
    for (int k = 0; k < count; ++k)
        problems.emplace_back(bytes);
    const List points(bytes, arraysOf(problems, &Arguments::objectPoints));
    const List rays(bytes, arraysOf(problems, &Arguments::rays));
    gmlpnp::Params params = problems.empty() ? gmlpnp::Params() : problems[0].params;
    if (bytes.between(0, 7) < 6)
        params.objectCovariances.release();
    std::vector<Result> results(1, untouchedResult());
    int solved = 0;
    if (call([&] { solved = gmlpnp::solveBatch(points.in(), rays.in(), results, params); }))
        requireResults(solved, results, points.in(), rays.in(), params);
    else
        require(results.size() == 1 && same(results[0], untouchedResult()), "an exception that writes nothing");
    for (const Arguments& problem : problems)
        require(problem.unchanged(), "inputs that stay");
    return 0;
}
