// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include "options.hpp"
#include "problem.hpp"
#include "result.hpp"

namespace cv {
namespace gmlpnp {

namespace {

using namespace detail;

// A picture in which nothing was seen is no misuse: it has too few points.
Problem problemOf(const Mat& objectPoints, const Mat& rays, const Params& params, int problem)
{
    if (objectPoints.empty() && rays.empty())
        return Problem();
    try {
        return problemFromRays(objectPoints, rays, params);
    } catch (const Exception& e) {
        CV_Error(e.code, format("problem %d: %s", problem, e.err.c_str()));
    }
}

}  // namespace

int solveBatch(InputArrayOfArrays objectPoints, InputArrayOfArrays rays, std::vector<Result>& results,
               const Params& params)
{
    if (!params.objectCovariances.empty())
        CV_Error(Error::StsBadArg, "objectCovariances belong to the points of one problem");
    const Options options = optionsFrom(params);
    std::vector<Mat> points, directions;
    objectPoints.getMatVector(points);
    rays.getMatVector(directions);
    if (points.size() != directions.size())
        CV_Error(Error::StsAssert, format("objectPoints and rays differ in the number of problems: %d and %d",
                                          static_cast<int>(points.size()), static_cast<int>(directions.size())));
    const int count = static_cast<int>(points.size());
    std::vector<Problem> problems;  // all are checked before any is solved
    for (int k = 0; k < count; ++k)
        problems.push_back(problemOf(points[k], directions[k], params, k));

    std::vector<Result> found(count);
    parallel_for_(Range(0, count), [&](const Range& range) {
        for (int k = range.start; k < range.end; ++k)
            solveToResult(problems[k], options, found[k]);
    });
    results.swap(found);
    return static_cast<int>(
        std::count_if(results.begin(), results.end(), [](const Result& result) { return isSuccess(result.status); }));
}

}  // namespace gmlpnp
}  // namespace cv
