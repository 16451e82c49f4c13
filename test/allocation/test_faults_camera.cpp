// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

// Memory runs out in the lenses, their files and the drawing.

#include <fstream>

#include "faults.hpp"
#ifdef GMLPNP_HAVE_DRAW
#include "opencv2/gmlpnp/draw.hpp"
#endif

namespace {

using namespace allocation;
using cv::gmlpnp::CameraModel;

TEST_F(Faults, factories)
{
    expectClean([](const Scene& s, Outputs&) { CameraModel::pinhole(s.K, s.D); });
    expectClean([](const Scene& s, Outputs&) { CameraModel::fisheye(s.K, cv::Vec4d()); });
    expectClean([](const Scene& s, Outputs&) { CameraModel::omnidir(s.K, cv::Vec4d(), 0.8); });
    expectClean([](const Scene& s, Outputs&) { CameraModel::eucm(s.K, 0.6, 1); });
    expectClean([](const Scene& s, Outputs&) { CameraModel::doubleSphere(s.K, 0.2, 0.5); });
    expectClean([](const Scene&, Outputs&) { CameraModel::equirectangular({640, 320}); });
}

TEST_F(Faults, unproject)
{
    expectClean([](const Scene& s, Outputs& out) { s.camera->unproject(s.pixels, out.rays, out.valid, out.jacobian); });
    expectClean([](const Scene& s, Outputs& out) { s.camera->unproject(s.pixels, out.raysVector, out.validVector); });
}

TEST_F(Faults, project)
{
    expectClean([](const Scene& s, Outputs& out) { s.camera->project(s.rays, out.rays, out.valid); });
}

const char* const FILE_TEXT =
    "%YAML:1.0\n---\nK: [ 800., 0., 320., 0., 800., 240., 0., 0., 1. ]\nD: [ 0.1, 0., 0., 0. ]\n";

TEST_F(Faults, load)
{
    const std::string name = testing::TempDir() + "gmlpnp_faults_camera.yml";
    std::ofstream(name) << FILE_TEXT;
    expectClean([&](const Scene&, Outputs&) { CameraModel::load(name); });
}

TEST_F(Faults, read)
{
    const cv::FileStorage file(FILE_TEXT, cv::FileStorage::READ | cv::FileStorage::MEMORY);
    expectClean([&](const Scene&, Outputs&) { CameraModel::read(file.root()); });
}

TEST_F(Faults, write)
{
    expectClean([](const Scene& s, Outputs&) {
        cv::FileStorage file(".yml", cv::FileStorage::WRITE | cv::FileStorage::MEMORY);
        file << "camera"
             << "{";
        s.camera->write(file);
        file << "}";
        file.releaseAndGetString();
    });
}

#ifdef GMLPNP_HAVE_DRAW
TEST_F(Faults, drawPoseUncertainty)
{
    cv::gmlpnp::Result result;
    result.tvec = {0, 0, 20};
    result.poseCovariance = 1e-4 * cv::Mat::eye(6, 6, CV_64F);
    const auto camera = CameraModel::pinhole(cv::Matx33d(80, 0, 32, 0, 80, 24, 0, 0, 1));
    expectClean(
        [&](const Scene& s, Outputs& out) { cv::gmlpnp::drawPoseUncertainty(out.image, camera, result, 1, s.points); });
}
#endif

}  // namespace
