// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>

#include <gdal_priv.h>

#include <opencv2/imgproc.hpp>

#include "uav_localization/localization.hpp"
#include "uav_localization/reference.hpp"

namespace {

using namespace samples;
using cv::gmlpnp::CameraModel;

const cv::Point2d kOrigin(500000.0, 4000000.0);
const char* const kSystem = "EPSG:32651";

//! Waves of 40 m over a plane that rises to the east, cells of 10 m.
double waveAt(const cv::Point2d& place)
{
    const cv::Point2d p = place - kOrigin;
    return 100.0 + 0.05 * p.x + 20.0 * std::sin(p.x / 150.0) * std::cos(p.y / 200.0);
}

Raster waves()
{
    Raster raster;
    raster.geo.mapFromPixel = cv::Matx23d(10.0, 0.0, kOrigin.x, 0.0, -10.0, kOrigin.y);
    raster.values.create(200, 200, CV_32F);
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 200; ++x)
            raster.values.at<float>(y, x) = static_cast<float>(waveAt(raster.geo.map(cv::Point2d(x, y))));
    return raster;
}

//! A camera 800 m above the middle that looks down, a little aside.
Pose cameraFromMap()
{
    const cv::Matx33d down(1, 0, 0, 0, -1, 0, 0, 0, -1);
    return inverse(
        Pose{poseFromRotationVector({0.1, -0.15, 0.5}, {}).R * down, {kOrigin.x + 1000.0, kOrigin.y - 1000.0, 950.0}});
}

cv::Ptr<CameraModel> camera()
{
    return CameraModel::pinhole(cv::Matx33d(500, 0, 320, 0, 500, 240, 0, 0, 1), cv::noArray());
}

TEST(GeoTransform, isInvertible)
{
    const GeoTransform geo{cv::Matx23d(3.0, 0.5, 100.0, 0.25, -4.0, 200.0)};
    EXPECT_LT(cv::norm(geo.pixel(geo.map({17.0, 5.5})) - cv::Point2d(17.0, 5.5)), 1e-12);
    EXPECT_NEAR(geo.resolution(), std::sqrt(12.125), 1e-12);
}

TEST(Terrain, isExactOnAPlaneAndUnknownBesideIt)
{
    Raster plane = waves();
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 200; ++x)
            plane.values.at<float>(y, x) = static_cast<float>(2.0 * x - y);
    plane.values.at<float>(100, 100) = std::numeric_limits<float>::quiet_NaN();
    const Terrain terrain(plane);
    EXPECT_NEAR(terrain.elevation(plane.geo.map({50.25, 60.5})), 40.0, 1e-6);
    EXPECT_NEAR(terrain.elevation(plane.geo.map({199.0, 199.0})), 199.0, 1e-6);
    EXPECT_TRUE(std::isnan(terrain.elevation(plane.geo.map({100.5, 99.5}))));
    EXPECT_TRUE(std::isnan(terrain.elevation(plane.geo.map({199.5, 10.0}))));
    EXPECT_TRUE(std::isnan(terrain.elevation(plane.geo.map({-0.5, 10.0}))));
    plane.values.setTo(std::numeric_limits<float>::quiet_NaN());
    EXPECT_THROW(Terrain{plane}, std::runtime_error);
}

TEST(Terrain, raysMeetTheGroundTheySee)
{
    const Terrain terrain(waves());
    const cv::Vec3d eye(kOrigin.x + 900.0, kOrigin.y - 1000.0, 700.0);
    for (int i = 0; i < 200; ++i) {
        const cv::Point2d place(kOrigin.x + 300.0 + 7.0 * i, kOrigin.y - 500.0 - 5.0 * i);
        const cv::Vec3d target(place.x, place.y, terrain.elevation(place));
        cv::Vec3d ground;
        ASSERT_TRUE(terrain.meet(eye, target - eye, ground)) << i;
        EXPECT_NEAR(ground[2], terrain.elevation({ground[0], ground[1]}), 1e-6);
        // What is met lies on the ray, and nothing of the ground lies before it.
        EXPECT_LT(cv::norm((ground - eye).cross(target - eye)) / cv::norm(target - eye), 1e-6);
        EXPECT_LT(cv::norm(ground - eye), cv::norm(target - eye) + 1e-6);
    }
    cv::Vec3d ground;
    EXPECT_TRUE(terrain.meet(eye, {0.0, 0.0, -1.0}, ground));
    EXPECT_LT(std::hypot(ground[0] - eye[0], ground[1] - eye[1]), 1e-6);
    EXPECT_FALSE(terrain.meet(eye, {1.0, 0.0, 0.01}, ground)) << "the sky";
    EXPECT_FALSE(terrain.meet(eye, {1.0, 0.0, -0.05}, ground)) << "leaves the map above the ground";
}

TEST(Terrain, whatIsBehindAHillIsHidden)
{
    Raster step = waves();
    step.values.setTo(0.0);
    step.values(cv::Rect(100, 0, 5, 200)).setTo(50.0);  // a wall, 50 m high
    const Terrain terrain(step);
    const cv::Vec3d eye(step.geo.map({50.0, 100.0}).x, step.geo.map({50.0, 100.0}).y, 60.0);
    const cv::Vec3d behind(step.geo.map({110.0, 100.0}).x, eye[1], 0.0);
    cv::Vec3d ground;
    ASSERT_TRUE(terrain.meet(eye, behind - eye, ground));
    EXPECT_LT(ground[0], step.geo.map({105.0, 100.0}).x);
    EXPECT_GT(ground[2], 1.0);
}

TEST(Terrain, longRaysAndStrangeCellsEnd)
{
    Raster raster = waves();
    const Terrain terrain(raster);
    cv::Vec3d ground;
    const cv::Vec3d eye(kOrigin.x + 900.0, kOrigin.y - 1000.0, 700.0);
    EXPECT_FALSE(terrain.meet(eye, {1.0, 0.0, -1e-300}, ground)) << "along the horizon";
    EXPECT_FALSE(terrain.meet(eye + cv::Vec3d(1e12, 0.0, 1e12), {0.0, 0.0, -1.0}, ground)) << "beside the map";
    EXPECT_TRUE(terrain.meet(eye + cv::Vec3d(0.0, 0.0, 1e9), {0.0, 0.0, -1.0}, ground)) << "from far above";
    EXPECT_NEAR(ground[2], waveAt({eye[0], eye[1]}), 0.1);

    raster.geo.mapFromPixel = cv::Matx23d(1e-12, 0.0, 0.0, 0.0, -1e-12, 0.0);  // cells far smaller than the relief
    EXPECT_TRUE(Terrain(raster).meet({1e-10, -1e-10, 1e3}, {1e-13, 0.0, -1.0}, ground));
    raster.geo.mapFromPixel = cv::Matx23d(1e12, 0.0, 0.0, 0.0, -1e-12, 0.0);  // and far from square
    EXPECT_TRUE(Terrain(raster).meet({1e13, -1e-10, 1e3}, {1e-3, 0.0, -1.0}, ground));
    raster.geo.mapFromPixel = cv::Matx23d(1e-300, 0.0, 0.0, 0.0, 1e-3, 0.0);  // a step is nothing
    EXPECT_FALSE(Terrain(raster).meet({1e-298, 0.1, 1e3}, {1e-3, 0.0, -1.0}, ground));
    raster.geo.mapFromPixel = cv::Matx23d(10.0, 20.0, 0.0, 10.0, 20.0, 0.0);  // on a line
    EXPECT_THROW(Terrain{raster}, std::runtime_error);
}

TEST(Reference, orthophotoAndPhotographAgree)
{
    const std::string folder = ::testing::TempDir();
    const Raster elevations = waves();
    const Terrain terrain(elevations);
    // The photograph of a map whose brightness tells the place.
    cv::Mat photograph(480, 640, CV_8UC3);
    for (int v = 0; v < 480; ++v)
        for (int u = 0; u < 640; ++u) {
            cv::Vec3d ray, ground;
            ASSERT_TRUE(camera()->unprojectPoint(cv::Point2d(u, v), ray));
            ASSERT_TRUE(terrain.meet(cameraFromMap().centre(), cameraFromMap().R.t() * ray, ground));
            photograph.at<cv::Vec3b>(v, u) = cv::Vec3b::all(cv::saturate_cast<uchar>(
                127.0 + 60.0 * std::sin(ground[0] / 40.0) + 60.0 * std::sin(ground[1] / 50.0)));
        }
    const Raster made = makeOrthophoto(photograph, *camera(), cameraFromMap(), terrain, 0.0);
    EXPECT_NEAR(made.geo.resolution(), 850.0 / 500.0, 0.2);
    const std::string path = folder + "gmlpnp_ortho.tif";
    writeOrthophoto(path, made, kSystem);
    const Raster read = readOrthophoto(path, kSystem);
    EXPECT_LT(cv::norm(cv::Mat(read.geo.mapFromPixel), cv::Mat(made.geo.mapFromPixel)), 1e-6);
    EXPECT_EQ(cv::norm(read.mask, made.mask), 0.0);
    int seen = 0;
    for (int y = 0; y < read.mask.rows; ++y)
        for (int x = 0; x < read.mask.cols; ++x) {
            if (!read.mask.at<uchar>(y, x))
                continue;
            ++seen;
            const cv::Point2d place = read.geo.map(cv::Point2d(x, y));
            const double expected = 127.0 + 60.0 * std::sin(place.x / 40.0) + 60.0 * std::sin(place.y / 50.0);
            EXPECT_NEAR(read.values.at<uchar>(y, x), expected, 3.0);
        }
    EXPECT_GT(seen, 200000);
    const Reference reference = orthophotoReference(path, kSystem, terrain);
    cv::Vec3d ground;
    ASSERT_TRUE(reference.lift({300.0, 200.0}, ground));
    EXPECT_NEAR(ground[2], terrain.elevation({ground[0], ground[1]}), 1e-12);
    EXPECT_LT(cv::norm(cv::Point2d(ground[0], ground[1]) - made.geo.map({300.0, 200.0})), 1e-6);
}

//! A ramp of elevations in degrees: the map becomes the UTM zone there, and places keep their elevations.
TEST(Raster, inDegreesIsWarpedIntoUtm)
{
    Raster ramp;
    ramp.geo.mapFromPixel = cv::Matx23d(1e-3, 0.0, 120.9, 0.0, -1e-3, 24.7);
    ramp.values.create(80, 100, CV_8U);
    for (int x = 0; x < 100; ++x)
        ramp.values.col(x).setTo(2 * x);
    ramp.mask = cv::Mat(80, 100, CV_8U, cv::Scalar(255));
    const std::string path = ::testing::TempDir() + "gmlpnp_degrees.tif";
    writeOrthophoto(path, ramp, "EPSG:4326");
    const std::string system = mapSystem("", path);
    EXPECT_NE(system.find("UTM zone 51N"), std::string::npos) << system;
    const Terrain terrain(readElevation(path, system));
    EXPECT_NEAR(terrain.resolution(), 106.0, 6.0);
    // 24.66 N 120.93 E and 120.97 E by gdaltransform.
    EXPECT_NEAR(terrain.elevation({290515.84, 2728880.22}), 60.0, 1.5);
    EXPECT_NEAR(terrain.elevation({294564.96, 2728819.75}), 140.0, 1.5);
    EXPECT_TRUE(std::isnan(terrain.elevation({120.95, 24.66})));
    ramp.geo.mapFromPixel(0, 2) = -6.6e180;
    writeOrthophoto(path, ramp, "EPSG:4326");
    EXPECT_THROW(mapSystem("", path), std::runtime_error);
}

// A GeoTIFF without any of its pixels, one block of all of them. Its size is no fault: the format allows for it.
std::string writeBlank(int side)
{
    const std::string path = ::testing::TempDir() + "gmlpnp_blank.tif", text = std::to_string(side);
    GDALAllRegister();
    CPLStringList options;
    options.AddString("SPARSE_OK=TRUE");
    options.AddString("TILED=YES");
    options.SetNameValue("BLOCKXSIZE", text.c_str());
    options.SetNameValue("BLOCKYSIZE", text.c_str());
    GDALDataset* const dataset =
        GetGDALDriverManager()->GetDriverByName("GTiff")->Create(path.c_str(), side, side, 1, GDT_Byte, options.List());
    double geo[6] = {kOrigin.x, 10.0, 0.0, kOrigin.y, 0.0, -10.0};
    dataset->SetGeoTransform(geo);
    GDALClose(dataset);
    return path;
}

// A header may name any size, and memory is taken for it only where the file may hold as much.
TEST(Raster, ofMorePixelsThanItsFileHoldsIsRefused)
{
    EXPECT_EQ(readOrthophoto(writeBlank(1024), kSystem).values.rows, 1024);
    try {
        readOrthophoto(writeBlank(4096), kSystem);
        FAIL() << "not refused";
    } catch (const std::runtime_error& e) {
        EXPECT_NE(std::string(e.what()).find("more pixels than it can hold"), std::string::npos) << e.what();
    }
}

TEST(Raster, ofAnotherSystemIsWarpedIntoTheMaps)
{
    const char* const variable = std::getenv("GMLPNP_DATA");
    const std::string root = variable ? variable : GMLPNP_DATA_DEFAULT;
    const std::string path = root + "/dem_bigtujunga/srtm_bigtujunga30m_utm11.tif";
    if (!std::filesystem::exists(path))
        GTEST_SKIP() << "no " << path << "; the folder is GMLPNP_DATA";
    const std::string own = mapSystem("", path);
    EXPECT_NE(own.find("UTM zone 11N"), std::string::npos) << own;
    const Terrain terrain(readElevation(path, own)), next(readElevation(path, mapSystem("EPSG:32612", path)));
    // Two places, whose coordinates in the next zone were computed by gdaltransform.
    const cv::Point2d here[] = {{390000.0, 3800000.0}, {405000.0, 3792000.0}};
    const cv::Point2d there[] = {{-162532.7034, 3822892.5842}, {-147957.9037, 3813972.3625}};
    for (int i = 0; i < 2; ++i)
        EXPECT_NEAR(next.elevation(there[i]), terrain.elevation(here[i]), 12.0) << "two interpolations of 30 m cells";
    EXPECT_THROW(mapSystem("EPSG:4326", path), std::runtime_error) << "degrees";
    EXPECT_THROW(mapSystem("nonsense", path), std::runtime_error);
    EXPECT_THROW(readElevation(root + "/README.md", own), std::runtime_error);
}

TEST(Localization, covarianceMeasuresTheTruthsDistance)
{
    Localization found;
    found.covariance = cv::Matx33d::diag(cv::Vec3d(4.0, 1.0, 9.0));
    found.truth = cv::Vec3d(2.0, -1.0, 3.0);
    EXPECT_NEAR(found.squaredDistance(), 3.0, 1e-12);
}

TEST(Localization, mapCarriesTheGroundAndThePlaces)
{
    const Terrain terrain(waves());
    Localization found;
    found.name = "photo_by_ortho";
    found.points = 2;
    found.centre = cv::Vec3d(kOrigin.x + 500.0, kOrigin.y - 500.0, 950.0);
    found.covariance = cv::Matx33d(4.0, 0.5, 0.0, 0.5, 1.0, 0.0, 0.0, 0.0, 9.0);
    CorrespondenceSet set;
    set.objectPoints = {{kOrigin.x + 300.0, kOrigin.y - 700.0, 120.0}, {kOrigin.x + 700.0, kOrigin.y - 300.0, 130.0}};
    const std::string path = ::testing::TempDir() + "gmlpnp_map.csv";
    writeMap(path, found, set, terrain, {}, {});

    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    EXPECT_EQ(text.str(),
              "# kind map\n# title photo_by_ortho: 2 points\n# unit m\n# terrain gmlpnp_map.asc\n"
              "# covariance 4 0.5 0 0.5 1 0 0 0 9\nwhat,name,easting,northing,elevation\n"
              "centre,GMLPNP_MARGINAL,500500.0000,3999500.0000,950.0000\n"
              "point,,500300.0000,3999300.0000,120.0000\npoint,,500700.0000,3999700.0000,130.0000\n");

    // 1.2 times the 400 m between the points, in cells of the terrain's 10 m.
    std::ifstream ground(::testing::TempDir() + "gmlpnp_map.asc");
    std::map<std::string, double> head;
    for (int i = 0; i < 6; ++i) {
        std::string key;
        ground >> key >> head[key];
    }
    EXPECT_EQ(head["ncols"], 48.0);
    EXPECT_EQ(head["cellsize"], 10.0);
    EXPECT_EQ(head["xllcorner"], kOrigin.x + 260.0);
    EXPECT_EQ(head["yllcorner"], kOrigin.y - 740.0);
    int cells = 0;
    for (double z = 0.0; ground >> z; ++cells)
        EXPECT_NEAR(
            z, terrain.elevation({kOrigin.x + 265.0 + 10.0 * (cells % 48), kOrigin.y - 265.0 - 10.0 * (cells / 48)}),
            0.006);
    EXPECT_EQ(cells, 48 * 48);
}

}  // namespace
