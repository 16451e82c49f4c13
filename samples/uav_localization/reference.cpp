// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "uav_localization/reference.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "common/images.hpp"

namespace samples {

namespace {

constexpr int kOutlineSteps = 32;  // rays along the larger side of the picture, to find what it shows
//! A place is hidden where its ray meets the ground this many cells of the terrain before it.
constexpr double kHiddenCells = 1.5;
constexpr double kMostPixels = 4e8;

//! What is seen of the ground by rays all over the picture.
std::vector<cv::Vec3d> groundOf(cv::Size picture, const cv::gmlpnp::CameraModel& camera, const Pose& cameraFromMap,
                                const Terrain& terrain)
{
    std::vector<cv::Vec3d> ground;
    const cv::Vec3d centre = cameraFromMap.centre();
    for (int j = 0; j <= kOutlineSteps; ++j)
        for (int i = 0; i <= kOutlineSteps; ++i) {
            const cv::Point2d pixel((picture.width - 1.0) * i / kOutlineSteps,
                                    (picture.height - 1.0) * j / kOutlineSteps);
            cv::Vec3d ray, place;
            if (camera.unprojectPoint(pixel, ray) && terrain.meet(centre, cameraFromMap.R.t() * ray, place))
                ground.push_back(place);
        }
    return ground;
}

//! The size on the ground of a pixel in the middle of the picture, m.
double groundResolution(cv::Size picture, const cv::gmlpnp::CameraModel& camera, const Pose& cameraFromMap,
                        const std::vector<cv::Vec3d>& ground)
{
    std::vector<double> depths;
    for (const cv::Vec3d& place : ground)
        depths.push_back(cv::norm(cameraFromMap * place));
    std::nth_element(depths.begin(), depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2), depths.end());
    cv::Vec3d a, b;
    const cv::Point2d middle(0.5 * picture.width, 0.5 * picture.height);
    if (!camera.unprojectPoint(middle, a) || !camera.unprojectPoint(middle + cv::Point2d(1.0, 0.0), b))
        throw std::runtime_error("the camera has no ray in the middle of its picture");
    return depths[depths.size() / 2] * cv::norm(a - b);
}

//! A north-up frame around places of the ground.
Raster emptyMap(const std::vector<cv::Vec3d>& ground, double resolution)
{
    cv::Point2d low(INFINITY, INFINITY), high(-INFINITY, -INFINITY);
    for (const cv::Vec3d& place : ground) {
        low = {std::min(low.x, place[0]), std::min(low.y, place[1])};
        high = {std::max(high.x, place[0]), std::max(high.y, place[1])};
    }
    const double width = std::ceil((high.x - low.x) / resolution), height = std::ceil((high.y - low.y) / resolution);
    if (!(width * height < kMostPixels))
        throw std::runtime_error(
            cv::format("an orthophoto of %.0f x %.0f pixels; give a coarser --resolution", width, height));
    Raster raster;
    raster.geo.mapFromPixel = cv::Matx23d(resolution, 0.0, low.x, 0.0, -resolution, high.y);
    raster.mask = cv::Mat::zeros(static_cast<int>(height) + 1, static_cast<int>(width) + 1, CV_8U);
    return raster;
}

//! Whether a camera sees a place of the ground, and at which pixel.
bool sees(const cv::gmlpnp::CameraModel& camera, const Pose& cameraFromMap, const Terrain& terrain,
          const cv::Vec3d& place, cv::Size picture, cv::Point2d& pixel)
{
    const cv::Vec3d centre = cameraFromMap.centre();
    cv::Vec3d first;
    return camera.projectPoint(cameraFromMap * place, pixel) && pixel.x >= 0.0 && pixel.y >= 0.0 &&
           pixel.x <= picture.width - 1.0 && pixel.y <= picture.height - 1.0 &&
           terrain.meet(centre, place - centre, first) && cv::norm(first - place) < kHiddenCells * terrain.resolution();
}

}  // namespace

Reference orthophotoReference(const std::string& path, const std::string& system, const Terrain& terrain)
{
    const Raster raster = readOrthophoto(path, system);
    Reference reference{path, raster.values, raster.mask, {}};
    reference.lift = [&terrain, geo = raster.geo](const cv::Point2d& pixel, cv::Vec3d& ground) {
        const cv::Point2d place = geo.map(pixel);
        ground = cv::Vec3d(place.x, place.y, terrain.elevation(place));
        return std::isfinite(ground[2]);
    };
    return reference;
}

Reference orientedReference(const std::string& path, const cv::Ptr<cv::gmlpnp::CameraModel>& camera,
                            const Pose& cameraFromMap, const Terrain& terrain)
{
    Reference reference{path, readImage(path, cv::IMREAD_GRAYSCALE), cv::Mat(), {}};
    reference.lift = [&terrain, camera, cameraFromMap](const cv::Point2d& pixel, cv::Vec3d& ground) {
        cv::Vec3d ray;
        return camera->unprojectPoint(pixel, ray) &&
               terrain.meet(cameraFromMap.centre(), cameraFromMap.R.t() * ray, ground);
    };
    return reference;
}

Raster makeOrthophoto(const cv::Mat& photograph, const cv::gmlpnp::CameraModel& camera, const Pose& cameraFromMap,
                      const Terrain& terrain, double resolution)
{
    const std::vector<cv::Vec3d> ground = groundOf(photograph.size(), camera, cameraFromMap, terrain);
    if (ground.empty())
        throw std::runtime_error("the photograph shows nothing of the elevation model");
    if (!(resolution > 0.0))
        resolution = groundResolution(photograph.size(), camera, cameraFromMap, ground);
    Raster raster = emptyMap(ground, resolution);
    cv::Mat map(raster.mask.size(), CV_32FC2, cv::Scalar::all(-1e4));
    for (int y = 0; y < map.rows; ++y)
        for (int x = 0; x < map.cols; ++x) {
            const cv::Point2d place = raster.geo.map(cv::Point2d(x, y));
            const cv::Vec3d point(place.x, place.y, terrain.elevation(place));
            cv::Point2d pixel;
            if (!std::isfinite(point[2]) || !sees(camera, cameraFromMap, terrain, point, photograph.size(), pixel))
                continue;
            map.at<cv::Vec2f>(y, x) = cv::Vec2f(static_cast<float>(pixel.x), static_cast<float>(pixel.y));
            raster.mask.at<uchar>(y, x) = 255;
        }
    cv::remap(photograph, raster.values, map, cv::noArray(), cv::INTER_LINEAR);
    return raster;
}

}  // namespace samples
