// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "every_function.hpp"
#ifdef GMLPNP_HAVE_DRAW
#include "opencv2/gmlpnp/draw.hpp"
#endif

namespace opencv_test {
namespace {

using cv::gmlpnp::CameraModel;
using cv::gmlpnp::Params;
using cv::gmlpnp::Result;

Bits bitsOf(const std::vector<cv::Mat>& arrays)
{
    Bits bits;
    for (const cv::Mat& array : arrays) {
        if (array.empty())
            continue;
        cv::Mat_<double> flat;
        array.reshape(1, 1).convertTo(flat, CV_64F);
        bits.insert(bits.end(), flat.begin(), flat.end());
    }
    return bits;
}

Bits bitsOf(const Result& r)
{
    return bitsOf({cv::Mat(r.rvec), cv::Mat(r.tvec), r.poseCovariance, r.poseCovarianceRt, r.cameraCenterCovariance,
                   r.objectNoise, r.objectNoiseStdErr, r.bearingNoise, r.bearingNoiseStdErr, r.weights,
                   cv::Mat(cv::Matx<double, 5, 1>(r.cost, r.rounds, r.noiseEvidence, r.poseEvidence, r.tailShare))});
}

std::vector<Function> solvers()
{
    using namespace cv::gmlpnp;
    return {
        {"solve",
         [](const Shared& s) {
             Result r;
             cv::gmlpnp::solve(s.scene.objectPoints, s.scene.imagePoints, s.K, s.D, r);
             return bitsOf(r);
         }},
        {"solve with a camera, published",
         [](const Shared& s) {
             Result r;
             Params params;
             params.method = SOLVEPNP_GMLPNP;
             cv::gmlpnp::solve(s.scene.objectPoints, s.scene.imagePoints, s.camera, r, params);
             return bitsOf(r);
         }},
        {"solveRays",
         [](const Shared& s) {
             Result r;
             solveRays(s.scene.objectPoints, s.scene.rays, r);
             return bitsOf(r);
         }},
        {"solveBatch",
         [](const Shared& s) {
             std::vector<Result> r;
             solveBatch(std::vector<cv::Mat>(3, s.scene.objectPoints), std::vector<cv::Mat>(3, s.scene.rays), r);
             return bitsOf(r.at(2));
         }},
        {"solveAll",
         [](const Shared& s) {
             std::vector<Result> r;
             solveAll(s.scene.objectPoints, s.scene.imagePoints, s.K, s.D, r);
             return bitsOf(r.at(0));
         }},
        {"solveAll with a camera",
         [](const Shared& s) {
             std::vector<Result> r;
             solveAll(s.scene.objectPoints, s.scene.imagePoints, s.camera, r);
             return bitsOf(r.at(0));
         }},
        {"solveRansac",
         [](const Shared& s) {
             Result r;
             cv::Mat inliers;
             solveRansac(s.scene.objectPoints, s.scene.imagePoints, s.K, s.D, r, inliers);
             return bitsOf({inliers, r.poseCovariance});
         }},
        {"solveRansac with a camera",
         [](const Shared& s) {
             Result r;
             cv::Mat inliers;
             solveRansac(s.scene.objectPoints, s.scene.imagePoints, s.camera, r, inliers);
             return bitsOf({inliers, r.poseCovariance});
         }},
        {"solveRaysRansac",
         [](const Shared& s) {
             Result r;
             cv::Mat inliers;
             solveRaysRansac(s.scene.objectPoints, s.scene.rays, r, inliers);
             return bitsOf({inliers, r.poseCovariance});
         }},
    };
}

// The names of OpenCV, our flags and one that is forwarded.
std::vector<Function> dropIns()
{
    using namespace cv::gmlpnp;
    std::vector<Function> all;
    for (const int flag : {int(SOLVEPNP_GMLPNP), int(SOLVEPNP_GMLPNP_MARGINAL), int(cv::SOLVEPNP_SQPNP)}) {
        all.push_back({"solvePnP", [flag](const Shared& s) {
                           cv::Mat r, t;
                           cv::gmlpnp::solvePnP(s.scene.objectPoints, s.scene.imagePoints, s.K, s.D, r, t, false, flag);
                           return bitsOf({r, t});
                       }});
        all.push_back({"solvePnPGeneric", [flag](const Shared& s) {
                           std::vector<cv::Mat> r, t;
                           cv::gmlpnp::solvePnPGeneric(s.scene.objectPoints, s.scene.imagePoints, s.K, s.D, r, t, false,
                                                       flag);
                           return bitsOf({r.at(0), t.at(0)});
                       }});
        all.push_back({"fisheye::solvePnP", [flag](const Shared& s) {
                           cv::Mat r, t;
                           cv::gmlpnp::fisheye::solvePnP(s.scene.objectPoints, s.scene.imagePoints, s.K, s.D, r, t,
                                                         false, flag);
                           return bitsOf({r, t});
                       }});
        all.push_back({"solvePnPRansac", [flag](const Shared& s) {
                           cv::Mat r, t, inliers;
                           cv::gmlpnp::solvePnPRansac(s.scene.objectPoints, s.scene.imagePoints, s.K, s.D, r, t, false,
                                                      1000, 8, 0.99, inliers, flag);
                           return bitsOf({r, t, inliers});
                       }});
        all.push_back({"fisheye::solvePnPRansac", [flag](const Shared& s) {
                           cv::Mat r, t, inliers;
                           cv::gmlpnp::fisheye::solvePnPRansac(s.scene.objectPoints, s.scene.imagePoints, s.K, s.D, r,
                                                               t, false, 1000, 8, 0.99, inliers, flag);
                           return bitsOf({r, t, inliers});
                       }});
    }
    all.push_back({"solvePnPRansac of UsacParams", [](const Shared& s) {
                       cv::Mat r, t, inliers, K(s.K);
                       cv::gmlpnp::solvePnPRansac(s.scene.objectPoints, s.scene.imagePoints, K, s.D, r, t, inliers,
                                                  cv::UsacParams());
                       return bitsOf({r, t, inliers});
                   }});
    return all;
}

template <class Refine>
Bits refined(const Shared& s, const Refine& refine)
{
    cv::Mat r = cv::Mat(s.nearby.rvec).clone(), t = cv::Mat(s.nearby.tvec).clone();
    refine(s.scene.objectPoints, s.scene.imagePoints, s.K, s.D, r, t);
    return bitsOf({r, t});
}

std::vector<Function> refiners()
{
    const auto by = [](auto function) {
        return [function](const Shared& s) {
            return refined(s, [&](const auto&... arguments) { function(arguments...); });
        };
    };
    const auto ours = [](const auto& p, const auto& u, const auto& K, const auto& D, const auto& r, const auto& t) {
        cv::gmlpnp::solvePnPRefine(p, u, K, D, r, t);
    };
    const auto lm = [](const auto& p, const auto& u, const auto& K, const auto& D, const auto& r, const auto& t) {
        cv::gmlpnp::solvePnPRefineLM(p, u, K, D, r, t);
    };
    const auto vvs = [](const auto& p, const auto& u, const auto& K, const auto& D, const auto& r, const auto& t) {
        cv::gmlpnp::solvePnPRefineVVS(p, u, K, D, r, t);
    };
    return {{"solvePnPRefine", by(ours)}, {"solvePnPRefineLM", by(lm)}, {"solvePnPRefineVVS", by(vvs)}};
}

// Through every lens and back, then through a file in memory.
std::vector<Function> cameras()
{
    const auto throughLens = [](const Shared& s) {
        Bits all;
        for (const cv::Ptr<CameraModel>& camera :
             {s.camera, CameraModel::pinhole(s.K, s.D), CameraModel::fisheye(s.K, s.D),
              CameraModel::omnidir(s.K, s.D, 0.8), CameraModel::eucm(s.K, 0.6, 1),
              CameraModel::doubleSphere(s.K, 0.2, 0.5), CameraModel::equirectangular({640, 480})}) {
            cv::Mat rays, valid, jacobian, pixels;
            camera->unproject(s.scene.imagePoints, rays, valid, jacobian);
            camera->project(rays, pixels, valid);
            const Bits bits = bitsOf({rays, jacobian, pixels, valid});
            all.insert(all.end(), bits.begin(), bits.end());
        }
        return all;
    };
    const auto throughFile = [](const Shared& s) {
        cv::FileStorage out(".yml", cv::FileStorage::WRITE | cv::FileStorage::MEMORY);
        out << "camera"
            << "{";
        s.camera->write(out);
        out << "}";
        const cv::FileStorage in(out.releaseAndGetString(), cv::FileStorage::READ | cv::FileStorage::MEMORY);
        cv::Mat rays;
        CameraModel::read(in["camera"])->unproject(s.scene.imagePoints, rays);
        return bitsOf({rays});
    };
    const auto loaded = [](const Shared& s) {
        cv::Mat rays;
        CameraModel::load(s.file)->unproject(s.scene.imagePoints, rays);
        return bitsOf({rays});
    };
    return {{"lenses", throughLens}, {"a camera's file", throughFile}, {"load", loaded}};
}

}  // namespace

std::vector<Function> everyFunction()
{
    std::vector<Function> all = solvers();
    for (const std::vector<Function>& more : {dropIns(), refiners(), cameras()})
        all.insert(all.end(), more.begin(), more.end());
#ifdef GMLPNP_HAVE_DRAW
    all.push_back({"drawPoseUncertainty", [](const Shared& s) {
                       cv::Mat image(480, 640, CV_8UC3, cv::Scalar::all(0));
                       cv::gmlpnp::drawPoseUncertainty(image, s.camera, s.nearby, 1, s.scene.objectPoints);
                       return bitsOf({image});
                   }});
#endif
    return all;
}

}  // namespace opencv_test
