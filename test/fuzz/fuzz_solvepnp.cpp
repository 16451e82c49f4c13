// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "fuzzed_arguments.hpp"
#include "outcome.hpp"

// OpenCV's names with our flags and with flags that nobody has. Flags of OpenCV go to OpenCV unchanged, as do
// solvePnPRefineLM and solvePnPRefineVVS: what they do with such arguments is not ours.

namespace {

using namespace fuzz;
namespace gmlpnp = cv::gmlpnp;

int flagFrom(Bytes& bytes)
{
    return bytes.pick<int>({gmlpnp::SOLVEPNP_GMLPNP_MARGINAL, gmlpnp::SOLVEPNP_GMLPNP_MARGINAL, gmlpnp::SOLVEPNP_GMLPNP,
                            gmlpnp::SOLVEPNP_GMLPNP, 99, -1, 102, 2147483647});
}

void requirePose(bool solved, const Output& rvec, const Output& tvec)
{
    if (solved)
        require(rvec.finite() && tvec.finite(), "a finite pose");
    else
        require(rvec.unchanged() && tvec.unchanged(), "a failure that writes nothing");
}

void pose(Bytes& bytes, const Arguments& in, bool isFisheye)
{
    const int flags = flagFrom(bytes);
    const bool guess = bytes.flip();
    Output rvec(bytes, in.rvec), tvec(bytes, in.tvec);
    const auto p = in.objectPoints.in(), u = in.imagePoints.in(), K = in.cameraMatrix.in(), D = in.distCoeffs.in();
    bool solved = false;
    call([&] {
        solved = isFisheye ? gmlpnp::fisheye::solvePnP(p, u, K, D, rvec.ref(), tvec.ref(), guess, flags)
                           : gmlpnp::solvePnP(p, u, K, D, rvec.ref(), tvec.ref(), guess, flags);
    });
    requirePose(solved, rvec, tvec);
}

void consensus(Bytes& bytes, const Arguments& in, bool isFisheye)
{
    const gmlpnp::RansacParams ransac = ransacFrom(bytes);
    const int flags = flagFrom(bytes);
    const bool guess = bytes.flip();
    Output rvec(bytes, in.rvec), tvec(bytes, in.tvec);
    std::vector<int> inliers(1, -7);
    const auto p = in.objectPoints.in(), u = in.imagePoints.in(), K = in.cameraMatrix.in(), D = in.distCoeffs.in();
    const auto threshold = static_cast<float>(ransac.threshold);
    bool solved = false;
    call([&] {
        solved = isFisheye
                     ? gmlpnp::fisheye::solvePnPRansac(p, u, K, D, rvec.ref(), tvec.ref(), guess, ransac.maxIterations,
                                                       threshold, ransac.confidence, inliers, flags)
                     : gmlpnp::solvePnPRansac(p, u, K, D, rvec.ref(), tvec.ref(), guess, ransac.maxIterations,
                                              threshold, ransac.confidence, inliers, flags);
    });
    requirePose(solved, rvec, tvec);
    if (solved)
        requireInliers(inliers, 1 << 30);
    else
        require(inliers == std::vector<int>(1, -7), "a failure that writes no inliers");
}

void usac(Bytes& bytes, const Arguments& in)
{
    const gmlpnp::RansacParams ransac = ransacFrom(bytes);
    gmlpnp::UsacParams params;
    params.threshold = ransac.threshold;
    params.confidence = ransac.confidence;
    params.maxIterations = ransac.maxIterations;
    params.randomGeneratorState = ransac.seed;
    params.sampler = bytes.pick({cv::SAMPLING_UNIFORM, cv::SAMPLING_PROSAC, cv::SAMPLING_NAPSAC});
    Output rvec(bytes, in.rvec), tvec(bytes, in.tvec);
    cv::Mat inliers;
    bool solved = false;
    call([&] {
        cv::Mat K = in.cameraMatrix.in().getMat();
        solved = gmlpnp::solvePnPRansac(in.objectPoints.in(), in.imagePoints.in(), K, in.distCoeffs.in(), rvec.ref(),
                                        tvec.ref(), inliers, params);
    });
    requirePose(solved, rvec, tvec);
    require(solved != inliers.empty(), "inliers with success only");
}

void every(Bytes& bytes, const Arguments& in)
{
    const int flags = flagFrom(bytes);
    const bool guess = bytes.flip();
    std::vector<cv::Vec3d> rvecs(1, cv::Vec3d::all(-7)), tvecs = rvecs;
    cv::Mat errors;
    const auto p = in.objectPoints.in(), u = in.imagePoints.in(), K = in.cameraMatrix.in(), D = in.distCoeffs.in();
    int count = 0;
    call([&] {
        count = gmlpnp::solvePnPGeneric(p, u, K, D, rvecs, tvecs, guess, flags, in.rvec, in.tvec,
                                        bytes.flip() ? cv::_OutputArray(errors) : cv::_OutputArray(cv::noArray()));
    });
    if (count == 0)
        require(rvecs == std::vector<cv::Vec3d>(1, cv::Vec3d::all(-7)) && tvecs == rvecs && errors.empty(),
                "a failure that writes nothing");
    else
        require(static_cast<int>(rvecs.size()) == count && static_cast<int>(tvecs.size()) == count &&
                    cv::checkRange(rvecs, true, nullptr, -DBL_MAX, DBL_MAX) &&
                    cv::checkRange(tvecs, true, nullptr, -DBL_MAX, DBL_MAX),
                "as many finite poses as said");
}

void refine(Bytes& bytes, const Arguments& in)
{
    const cv::TermCriteria criteria{bytes.between(0, 3), bytes.pick({20, 1, 0, -1, -2147483647}), bytes.number()};
    Output rvec(bytes, in.rvec), tvec(bytes, in.tvec);
    const bool isPose = rvec.finite() && tvec.finite();
    const bool returned = call([&] {
        gmlpnp::solvePnPRefine(in.objectPoints.in(), in.imagePoints.in(), in.cameraMatrix.in(), in.distCoeffs.in(),
                               rvec.ref(), tvec.ref(), criteria);
    });
    requirePose(returned && !(rvec.unchanged() && tvec.unchanged()), rvec, tvec);
    require(isPose || !returned || (rvec.unchanged() && tvec.unchanged()), "no pose from a guess that is none");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    Bytes bytes(data, size);
    const int which = bytes.between(0, 6);
    const Arguments in(bytes);
    if (which <= 1)
        pose(bytes, in, which == 1);
    else if (which <= 3)
        consensus(bytes, in, which == 3);
    else if (which == 4)
        usac(bytes, in);
    else if (which == 5)
        every(bytes, in);
    else
        refine(bytes, in);
    require(in.unchanged(), "inputs that stay");
    return 0;
}
