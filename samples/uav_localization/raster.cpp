// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "uav_localization/raster.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <vector>

#include <gdal_priv.h>
#include <gdalwarper.h>
#include <ogr_spatialref.h>

#include <opencv2/imgproc.hpp>

#include "common/output_file.hpp"

namespace samples {

namespace {

struct CloseDataset
{
    void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, CloseDataset>;

[[noreturn]] void fail(const std::string& path, const std::string& message)
{
    const std::string reason = CPLGetLastErrorMsg();
    throw std::runtime_error(path + ": " + message + (reason.empty() ? "" : " (" + reason + ")"));
}

void startGdal()
{
    static const bool started = [] {
        GDALAllRegister();
        CPLSetErrorHandler(CPLQuietErrorHandler);  // the message is in the exception
        return true;
    }();
    CPLErrorReset();
    static_cast<void>(started);
}

OGRSpatialReference systemOf(const std::string& text)
{
    OGRSpatialReference system;
    system.SetFromUserInput(text.c_str());
    system.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    system.StripVertical();  // elevations stay as they are
    return system;
}

std::string wktOf(const OGRSpatialReference& system)
{
    char* text = nullptr;
    system.exportToWkt(&text);
    std::string wkt = text != nullptr ? text : "";
    CPLFree(text);
    return wkt;
}

GeoTransform geoTransformOf(GDALDataset& dataset, const std::string& path)
{
    double g[6];
    if (dataset.GetGeoTransform(g) != CE_None)
        fail(path, "no geotransform");
    // GDAL counts from the corner of the first pixel, OpenCV from its centre.
    return {cv::Matx23d(g[1], g[2], g[0] + 0.5 * (g[1] + g[2]), g[4], g[5], g[3] + 0.5 * (g[4] + g[5]))};
}

//! Of all its files.
std::uintmax_t bytesOf(GDALDataset& dataset)
{
    std::uintmax_t bytes = 0;
    const CPLStringList files(dataset.GetFileList(), true);
    for (int i = 0; i < files.size(); ++i) {
        VSIStatBufL status;
        if (VSIStatL(files[i], &status) == 0)
            bytes += static_cast<std::uintmax_t>(status.st_size);
    }
    return bytes;
}

Dataset opened(const std::string& path)
{
    startGdal();
    Dataset dataset(GDALDataset::Open(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY));
    if (!dataset)
        fail(path, "cannot be opened as a raster");
    if (dataset->GetRasterCount() == 0)
        fail(path, "no bands");
    // A header may name any size, and GDAL and cv::Mat would take the memory for it.
    int width = 0, height = 0;
    dataset->GetRasterBand(1)->GetBlockSize(&width, &height);
    const double pixels = std::max(static_cast<double>(width) * height,
                                   static_cast<double>(dataset->GetRasterXSize()) * dataset->GetRasterYSize());
    constexpr double MANY = 1e7, PIXELS_PER_BYTE = 5000;  // as much as blank pixels are compressed
    if (pixels > MANY && pixels > PIXELS_PER_BYTE * static_cast<double>(bytesOf(*dataset)))
        fail(path, "names more pixels than it can hold");
    return dataset;
}

//! The raster in the map's system: itself, or a view that warps it.
Dataset inSystem(Dataset& source, const std::string& path, const std::string& system)
{
    geoTransformOf(*source, path);
    const OGRSpatialReference* own = source->GetSpatialRef();
    if (system.empty() || own == nullptr)
        return nullptr;
    const OGRSpatialReference wanted = systemOf(system);
    if (systemOf(wktOf(*own)).IsSame(&wanted))
        return nullptr;
    Dataset warped(GDALDataset::FromHandle(GDALAutoCreateWarpedVRT(GDALDataset::ToHandle(source.get()), nullptr,
                                                                   system.c_str(), GRA_Bilinear, 0.0, nullptr)));
    if (!warped)
        fail(path, "cannot be brought into the map's coordinate system");
    return warped;
}

cv::Mat readBand(GDALRasterBand& band, int type, GDALDataType gdalType, const std::string& path)
{
    cv::Mat values(band.GetYSize(), band.GetXSize(), type);
    if (band.RasterIO(GF_Read, 0, 0, values.cols, values.rows, values.data, values.cols, values.rows, gdalType, 0, 0) !=
        CE_None)
        fail(path, "cannot be read");
    return values;
}

//! Brightness in 8 bits; other depths are stretched between their 2 % and 98 % values.
cv::Mat eightBits(const cv::Mat& values, const cv::Mat& mask, bool isByte)
{
    cv::Mat result;
    if (isByte) {
        values.convertTo(result, CV_8U);
        return result;
    }
    std::vector<float> seen;
    for (int y = 0; y < values.rows; ++y)
        for (int x = 0; x < values.cols; ++x)
            if (mask.at<uchar>(y, x))
                seen.push_back(values.at<float>(y, x));
    if (seen.empty())
        return cv::Mat::zeros(values.size(), CV_8U);
    const auto quantile = [&](double share) {
        const auto at = seen.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(seen.size() - 1));
        std::nth_element(seen.begin(), at, seen.end());
        return static_cast<double>(*at);
    };
    const double low = quantile(0.02), high = quantile(0.98), scale = high > low ? 255.0 / (high - low) : 1.0;
    values.convertTo(result, CV_8U, scale, -scale * low);
    return result;
}

void setSystem(GDALDataset& dataset, const std::string& system)
{
    if (system.empty())
        return;
    const OGRSpatialReference reference = systemOf(system);
    dataset.SetSpatialRef(&reference);
}

}  // namespace

cv::Point2d GeoTransform::map(const cv::Point2d& pixel) const
{
    const cv::Vec2d at = mapFromPixel * cv::Vec3d(pixel.x, pixel.y, 1.0);
    return {at[0], at[1]};
}

cv::Point2d GeoTransform::pixel(const cv::Point2d& map) const
{
    const cv::Matx22d A(mapFromPixel(0, 0), mapFromPixel(0, 1), mapFromPixel(1, 0), mapFromPixel(1, 1));
    const cv::Vec2d at = A.inv() * cv::Vec2d(map.x - mapFromPixel(0, 2), map.y - mapFromPixel(1, 2));
    return {at[0], at[1]};
}

double GeoTransform::resolution() const
{
    return std::sqrt(std::abs(mapFromPixel(0, 0) * mapFromPixel(1, 1) - mapFromPixel(0, 1) * mapFromPixel(1, 0)));
}

std::string mapSystem(const std::string& wanted, const std::string& dem)
{
    startGdal();
    if (!wanted.empty()) {
        OGRSpatialReference system;
        if (system.SetFromUserInput(wanted.c_str()) != OGRERR_NONE)
            fail("--crs", "'" + wanted + "' is no coordinate system");
        system = systemOf(wanted);
        if (!system.IsProjected() || std::abs(system.GetLinearUnits() - 1.0) > 1e-9)
            throw std::runtime_error("--crs: '" + wanted + "' is no projection in metres");
        return wktOf(system);
    }
    const Dataset dataset = opened(dem);
    const OGRSpatialReference* own = dataset->GetSpatialRef();
    if (own == nullptr)
        return std::string();
    OGRSpatialReference system = systemOf(wktOf(*own));
    if (system.IsProjected()) {
        if (std::abs(system.GetLinearUnits() - 1.0) > 1e-9)
            throw std::runtime_error(dem + ": its projection is not in metres; give another by --crs");
        return wktOf(system);
    }
    const cv::Size size(dataset->GetRasterXSize(), dataset->GetRasterYSize());
    const cv::Point2d middle = geoTransformOf(*dataset, dem).map({0.5 * size.width, 0.5 * size.height});
    constexpr double TURN = 360.0;
    if (!(std::abs(middle.x) <= TURN && std::abs(middle.y) <= TURN))
        fail(dem, "its middle is no place in degrees");
    const int zone = std::clamp(static_cast<int>(std::floor((middle.x + 180.0) / 6.0)) + 1, 1, 60);
    OGRSpatialReference utm;
    if (utm.importFromEPSG((middle.y >= 0.0 ? 32600 : 32700) + zone) != OGRERR_NONE)
        fail(dem, "no UTM zone for its middle; give a system by --crs");
    return wktOf(utm);
}

Raster readElevation(const std::string& path, const std::string& system)
{
    Dataset source = opened(path);
    const Dataset warped = inSystem(source, path, system);
    GDALDataset& dataset = warped ? *warped : *source;
    GDALRasterBand& band = *dataset.GetRasterBand(1);
    const std::string unit = band.GetUnitType() != nullptr ? band.GetUnitType() : "";
    if (!unit.empty() && unit != "m" && unit != "metre" && unit != "meter")
        throw std::runtime_error(path + ": elevations in '" + unit + "', not in metres");
    Raster raster{readBand(band, CV_32F, GDT_Float32, path), cv::Mat(), geoTransformOf(dataset, path)};
    raster.mask = readBand(*band.GetMaskBand(), CV_8U, GDT_Byte, path);
    raster.values.setTo(std::numeric_limits<float>::quiet_NaN(), raster.mask == 0);
    return raster;
}

Raster readOrthophoto(const std::string& path, const std::string& system)
{
    Dataset source = opened(path);
    const Dataset warped = inSystem(source, path, system);
    GDALDataset& dataset = warped ? *warped : *source;
    const int bands = dataset.GetRasterCount() >= 3 ? 3 : 1;
    Raster raster{cv::Mat(), readBand(*dataset.GetRasterBand(1)->GetMaskBand(), CV_8U, GDT_Byte, path),
                  geoTransformOf(dataset, path)};
    cv::Mat sum = cv::Mat::zeros(raster.mask.size(), CV_32F);
    for (int b = 1; b <= bands; ++b)
        sum += readBand(*dataset.GetRasterBand(b), CV_32F, GDT_Float32, path) / bands;
    raster.values = eightBits(sum, raster.mask, dataset.GetRasterBand(1)->GetRasterDataType() == GDT_Byte);
    return raster;
}

void writeOrthophoto(const std::string& path, const Raster& raster, const std::string& system)
{
    startGdal();
    const int channels = raster.values.channels();
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
    CPLStringList options;
    options.AddString("COMPRESS=DEFLATE");
    options.AddString("ALPHA=YES");
    options.AddString(channels == 3 ? "PHOTOMETRIC=RGB" : "PHOTOMETRIC=MINISBLACK");
    files::PartialFile file(path);
    Dataset dataset(driver == nullptr ? nullptr
                                      : driver->Create(file.path().c_str(), raster.values.cols, raster.values.rows,
                                                       channels + 1, GDT_Byte, options.List()));
    if (!dataset)
        fail(path, "cannot be written");
    const cv::Matx23d& A = raster.geo.mapFromPixel;
    double g[6] = {A(0, 2) - 0.5 * (A(0, 0) + A(0, 1)), A(0, 0), A(0, 1),
                   A(1, 2) - 0.5 * (A(1, 0) + A(1, 1)), A(1, 0), A(1, 1)};
    dataset->SetGeoTransform(g);
    setSystem(*dataset, system);
    std::vector<cv::Mat> planes;
    cv::split(raster.values, planes);
    std::reverse(planes.begin(), planes.end());  // red first
    planes.push_back(raster.mask);
    for (int b = 0; b <= channels; ++b) {
        cv::Mat& plane = planes[static_cast<size_t>(b)];
        if (dataset->GetRasterBand(b + 1)->RasterIO(GF_Write, 0, 0, plane.cols, plane.rows, plane.data, plane.cols,
                                                    plane.rows, GDT_Byte, 0, 0) != CE_None)
            fail(path, "cannot be written");
    }
    dataset.reset();  // what is still in memory goes to the disk now, and may not fit there
    if (CPLGetLastErrorType() >= CE_Failure)
        fail(path, "cannot be written");
    file.commit();
}

}  // namespace samples
