// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_GMLPNP_API_BOUNDARY_HPP
#define OPENCV_GMLPNP_API_BOUNDARY_HPP

#include "../arrays/outputs.hpp"
#include "../estimator/solve.hpp"

// Between OpenCV's types and the solver's: checks and conversions, no mathematics.

namespace cv {
namespace gmlpnp {
namespace detail {

/** Params as the solver takes them; what is out of range: StsBadArg, named. */
Options checked(const Params& params);

/** What a call passes in, with the points that have no ray left out. */
struct Input
{
    Observations observations;
    std::vector<int> used;    //!< their rows in the caller's arrays
    int total = 0;            //!< rows of the caller's arrays
    bool finite = true;       //!< pixels and guess; the solver looks at points and rays
    Mat_<double> rayByPixel;  //!< N x 6, where asked for: derivatives of the rays, row-major 3x2
};

Input inputRays(InputArray objectPoints, InputArray rays, const Params& params);
Input inputPixels(InputArray objectPoints, InputArray imagePoints, const Ptr<CameraModel>& camera, const Params& params,
                  bool wantRayByPixel = false);

/** The chosen rows; all of them without a copy. */
Mat_<double> chosenRows(const Mat_<double>& all, const std::vector<int>& rows);

/** Runs the solver; on a failure only `status` is written. */
bool run(const Input& input, const Options& options, Status& status, std::vector<Solution>& solutions);

Result toResult(const Solution& solution, Status status, const Input& input);

/** One problem; on a failure only Result::status is written. */
bool solveOne(const Input& input, const Options& options, Result& result);

/** Params of a call with one of our flags; StsBadArg for every other flag. */
Params paramsOf(int flags, bool useExtrinsicGuess, InputArray rvec, InputArray tvec);

/** OpenCV's names refuse what is too few; ours return a status. StsAssert below 4 points, 3 with a guess. */
void requireEnough(const Input& input, int fewest);

/** 3 floating-point numbers of any shape; anything else: StsAssert, named. */
Vec3d guessFrom(InputArray vec, const char* name);

/** Rotation vector and translation of a pose. */
void addPose(const Pose& pose, OutputArray rvec, OutputArray tvec, Outputs& outputs);

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv

#endif  // OPENCV_GMLPNP_API_BOUNDARY_HPP
