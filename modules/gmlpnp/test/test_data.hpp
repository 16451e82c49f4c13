// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_TEST_GMLPNP_DATA_HPP
#define OPENCV_TEST_GMLPNP_DATA_HPP

#include "test_precomp.hpp"

#include <cstdlib>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

// Real data, which are not part of the project: where they lie and how they are read. Tests are skipped without them.

namespace opencv_test {

const char* const kNoData = "data not found: set GMLPNP_DATA";

// A file of the data; empty where it does not exist.
inline std::string dataFile(const std::string& name)
{
    std::vector<std::string> folders;
    if (const char* folder = std::getenv("GMLPNP_DATA"))
        folders.emplace_back(folder);
#ifdef GMLPNP_SOURCE_DIR
    folders.emplace_back(std::string(GMLPNP_SOURCE_DIR) + "/../shared/data");
#endif
    for (std::string path : folders) {
        path.append("/").append(name);
        if (std::ifstream(path))
            return path;
    }
    return std::string();
}

// One view of a chessboard: its corners, their pixels and the pose that the calibration found.
struct BoardView
{
    Mat_<double> corners, pixels;  // Nx3, Nx2
    Vec3d rvec, tvec;
};

struct BoardCalibration
{
    Ptr<gmlpnp::CameraModel> camera;
    std::vector<BoardView> views;
};

// The tutorial data of cv::omnidir, 15 views of 54 corners; no views where the data are missing.
inline BoardCalibration omnidirChessboard()
{
    const std::string calibration = dataFile("omnidir_chessboard/calibration.yml");
    const std::string corners = dataFile("omnidir_chessboard/omni_calib_data.xml");
    BoardCalibration boards;
    if (calibration.empty() || corners.empty())
        return boards;
    boards.camera = gmlpnp::CameraModel::load(calibration);
    const FileStorage poses(calibration, FileStorage::READ), data(corners, FileStorage::READ);
    Mat rvecs, tvecs;
    poses["rvecs"] >> rvecs;
    poses["tvecs"] >> tvecs;
    for (int i = 0; i < rvecs.rows; ++i) {
        Mat board, seen;
        data["objectPoints"][i] >> board;
        data["imagePoints"][i] >> seen;
        BoardView view;
        board.reshape(1).convertTo(view.corners, CV_64F);
        seen.reshape(1).convertTo(view.pixels, CV_64F);
        view.rvec = Vec3d(rvecs.ptr<double>(i));
        view.tvec = Vec3d(tvecs.ptr<double>(i));
        boards.views.push_back(view);
    }
    return boards;
}

// Sum of the squared distances [px^2] of the pixels from those of the corners in this pose; NaN where one has none.
inline double squaredPixelErrors(const gmlpnp::CameraModel& camera, const BoardView& view, const Vec3d& rvec,
                                 const Vec3d& tvec)
{
    Matx33d R;
    Rodrigues(rvec, R);
    double squares = 0;
    for (int i = 0; i < view.corners.rows; ++i) {
        Point2d pixel;
        if (!camera.projectPoint(R * Vec3d(view.corners.ptr<double>(i)) + tvec, pixel))
            return std::numeric_limits<double>::quiet_NaN();
        const Point2d e = pixel - Point2d(view.pixels(i, 0), view.pixels(i, 1));
        squares += e.dot(e);
    }
    return squares;
}

}  // namespace opencv_test

#endif  // OPENCV_TEST_GMLPNP_DATA_HPP
