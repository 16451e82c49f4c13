// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "camera_util.hpp"

// What holds for every lens.

namespace opencv_test {
namespace {

using namespace camera;

struct Lens
{
    const char* name;
    double maxAngle;  // degrees: every direction up to here is seen
    std::function<Ptr<CameraModel>()> make;
};

void PrintTo(const Lens& lens, std::ostream* os)
{
    *os << lens.name;
}

using Coefficients = std::vector<double>;

const Matx33d kTum = matrixK(517.3, 516.5, 318.6, 255.3);
const Matx33d kWide = matrixK(190.9785, 190.9733, 254.9317, 256.8974);
const Matx33d kSkewed = matrixK(407.63, 409.18, 630.66, 431.52, 0.8);

const Lens kLenses[] = {
    {"pinhole", 89, [] { return CameraModel::pinhole(kTum); }},
    {"pinhole4", 80,
     [] {
         return CameraModel::pinhole(kTum, Coefficients{-0.26, 0.10, 0.0003, -0.0002});
     }},
    {"pinhole5", 75,
     [] {
         return CameraModel::pinhole(kTum, Coefficients{0.2624, -0.9531, -0.0054, 0.0026, 1.1633});
     }},
    {"pinhole8", 70,
     [] {
         return CameraModel::pinhole(kTum, Coefficients{0.47, -2.4, 0.0008, -0.0004, 1.7, 0.35, -2.2, 1.6});
     }},
    {"pinhole12", 40,
     [] {
         return CameraModel::pinhole(
             kTum, Coefficients{-0.12, 0.08, 0.001, -0.002, 0.01, 0.02, 0.01, 0.005, 0.004, -0.001, -0.003, 0.002});
     }},
    {"pinhole14", 40,
     [] {
         return CameraModel::pinhole(kTum, Coefficients{-0.12, 0.08, 0.001, -0.002, 0.01, 0.02, 0.01, 0.005, 0.004,
                                                        -0.001, -0.003, 0.002, 0.05, -0.08});
     }},
    {"fisheye", 110,
     [] {
         return CameraModel::fisheye(kWide, Coefficients{0.0034824, 0.000715, -0.0020532, 0.00020294});
     }},
    {"fisheyeEquidistant", 179.5, [] { return CameraModel::fisheye(kSkewed); }},
    {"omnidirUnit", 140,
     [] {
         return CameraModel::omnidir(kSkewed, Coefficients{-0.01034, 0.01188, 0.02262, -0.00402}, 1.04956);
     }},
    {"omnidirLargeXi", 112,
     [] {
         return CameraModel::omnidir(matrixK(1336.3, 1335.8, 716.9, 705.8),
                                     Coefficients{0.0168, 1.6548, 0.000422, 0.000425}, 2.2134);
     }},
    {"omnidirSmallXi", 115,
     [] {
         return CameraModel::omnidir(kSkewed, Coefficients{-0.05, 0.02, 0.001, 0.0}, 0.8);
     }},
    {"omnidirPinhole", 80, [] { return CameraModel::omnidir(kSkewed, noArray(), 0); }},
    {"eucm", 120, [] { return CameraModel::eucm(kSkewed, 0.6, 1.1); }},
    {"eucmSmallAlpha", 115, [] { return CameraModel::eucm(kWide, 0.4, 0.9); }},
    {"eucmSphere", 175, [] { return CameraModel::eucm(kWide, 0.5, 1.0); }},
    {"doubleSphere", 125, [] { return CameraModel::doubleSphere(kWide, -0.27, 0.57); }},
    {"doubleSphereSmallAlpha", 120, [] { return CameraModel::doubleSphere(kSkewed, 0.3, 0.4); }},
    {"equirectangular", 179.5, [] { return CameraModel::equirectangular(Size(2000, 1000)); }},
};

class Gmlpnp_Camera : public testing::TestWithParam<Lens>
{
protected:
    Ptr<CameraModel> camera = GetParam().make();
    std::vector<Vec3d> grid = polarGrid(GetParam().maxAngle * kDegree);
};

// Pixels in a radian at the optical axis.
double pixelsPerRadian(const CameraModel& camera)
{
    Point2d centre, aside;
    EXPECT_TRUE(camera.projectPoint(Vec3d(0, 0, 1), centre) && camera.projectPoint(Vec3d(1e-5, 0, 1), aside));
    return cv::norm(aside - centre) / 1e-5;
}

TEST_P(Gmlpnp_Camera, rays_to_pixels_and_back)
{
    double worst = 0;
    for (const Vec3d& m : grid) {
        Point2d pixel;
        Vec3d ray;
        ASSERT_TRUE(camera->projectPoint(m, pixel)) << m;
        ASSERT_TRUE(camera->unprojectPoint(pixel, ray)) << m << pixel;
        ASSERT_NEAR(ray.dot(ray), 1, 1e-14) << m;
        worst = std::max(worst, cv::norm(ray - m));
    }
    EXPECT_LT(worst, 1e-12);
    RecordProperty("worst_rad", std::to_string(worst));
}

TEST_P(Gmlpnp_Camera, pixels_to_rays_and_back)
{
    double worst = 0;
    for (const Vec3d& m : grid) {
        Point2d pixel, again;
        Vec3d ray;
        ASSERT_TRUE(camera->projectPoint(m, pixel));
        const Point2d rounded(std::round(pixel.x), pixel.y);
        if (!camera->unprojectPoint(rounded, ray))
            continue;  // rounding left the domain
        ASSERT_TRUE(camera->projectPoint(ray, again)) << rounded;
        worst = std::max(worst, cv::norm(again - rounded) / (1 + cv::norm(rounded)));
    }
    EXPECT_LT(worst, 1e-12);  // relative
}

TEST_P(Gmlpnp_Camera, length_of_the_point_does_not_matter)
{
    for (const double length : {1e-200, 1e-3, 1e5, 1e200})
        for (size_t i = 0; i < grid.size(); i += 7) {
            Point2d unit, scaled;
            ASSERT_TRUE(camera->projectPoint(grid[i], unit));
            ASSERT_TRUE(camera->projectPoint(grid[i] * length, scaled)) << grid[i] << length;
            ASSERT_LT(cv::norm(unit - scaled), 1e-10 * (1 + cv::norm(unit))) << grid[i] << length;
        }
}

TEST_P(Gmlpnp_Camera, jacobian_is_the_derivative_and_tangent)
{
    int compared = 0;
    for (const Vec3d& m : grid) {
        Point2d pixel;
        Vec3d ray;
        Matx32d J, Jn;
        ASSERT_TRUE(camera->projectPoint(m, pixel));
        ASSERT_TRUE(camera->unprojectPoint(pixel, ray, &J));
        const double size = cv::norm(J);
        ASSERT_LT(cv::norm(ray.t() * J), 1e-13 * size) << m;
        if (!numericJacobian(*camera, pixel, 1e-4 / size, Jn))
            continue;  // a neighbour lies outside of the domain
        ASSERT_LT(cv::norm(J - Jn), 1e-8 * size) << m << "\n" << J << "\n" << Jn;
        ++compared;
    }
    EXPECT_GT(compared, static_cast<int>(grid.size() * 9 / 10));
}

// The Jacobian leads along the sphere to the ray whose pixel is the moved one: project() is the independent side.
TEST_P(Gmlpnp_Camera, jacobian_agrees_with_projection)
{
    for (const Vec3d& m : grid) {
        Point2d pixel, moved;
        Vec3d ray;
        Matx32d J;
        ASSERT_TRUE(camera->projectPoint(m, pixel));
        ASSERT_TRUE(camera->unprojectPoint(pixel, ray, &J));
        const Vec2d step(1e-5, -2e-5);  // px
        ASSERT_TRUE(camera->projectPoint(ray + J * step, moved));
        ASSERT_LT(cv::norm(moved - pixel - Point2d(step)), 1e-8 + 1e-12 * cv::norm(pixel)) << m;
    }
}

// The angle that a pixel spans around the axis, by the Jacobian. Distortion of the plane may be left out of it, and
// where fx and fy differ the axis sees their mean; a panorama has no axis.
TEST_P(Gmlpnp_Camera, angular_scale_is_that_of_the_jacobian_around_the_axis)
{
    const std::string name = GetParam().name;
    if (name == "equirectangular")
        return;
    const std::set<std::string> distorted = {"pinhole4",  "pinhole5",    "pinhole8",       "pinhole12",
                                             "pinhole14", "omnidirUnit", "omnidirLargeXi", "omnidirSmallXi"};
    const bool exact = distorted.count(name) == 0;
    const double focal = pixelsPerRadian(*camera);
    for (const Vec3d& m : polarGrid((exact ? GetParam().maxAngle : 15) * kDegree)) {
        Point2d pixel;
        Vec3d ray;
        Matx32d J;
        ASSERT_TRUE(camera->projectPoint(m, pixel) && camera->unprojectPoint(pixel, ray, &J)) << m;
        double scale = 0;
        camera->angularScales(&m, 1, &scale);
        const double sine = std::hypot(m[0], m[1]);
        const Vec3d around = sine > 0 ? Vec3d(-m[1], m[0], 0) / sine : Vec3d(1, 0, 0);
        EXPECT_NEAR(1, scale / (cv::norm(J.t() * around) * focal), exact ? 0.005 : 0.1) << m;
    }
}

TEST_P(Gmlpnp_Camera, orientation_is_kept)
{
    for (const Vec3d& m : grid) {
        Point2d pixel;
        Vec3d ray;
        Matx32d J;
        ASSERT_TRUE(camera->projectPoint(m, pixel));
        ASSERT_TRUE(camera->unprojectPoint(pixel, ray, &J));
        const Vec3d x(J(0, 0), J(1, 0), J(2, 0)), y(J(0, 1), J(1, 1), J(2, 1));
        ASSERT_GT(x.cross(y).dot(ray), 0) << m;  // x right, y down, z forward: never folded over
    }
}

TEST_P(Gmlpnp_Camera, nothing_is_seen_of_what_is_not_finite)
{
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    for (const double bad : {nan, inf, -inf}) {
        Vec3d ray(7, 7, 7);
        Point2d pixel(7, 7);
        Matx32d J;
        EXPECT_FALSE(camera->unprojectPoint({bad, 200}, ray, &J));
        EXPECT_FALSE(camera->unprojectPoint({300, bad}, ray, &J));
        EXPECT_FALSE(camera->projectPoint({bad, 0, 1}, pixel));
        EXPECT_FALSE(camera->projectPoint({0.1, bad, 1}, pixel));
        EXPECT_FALSE(camera->projectPoint({0.1, 0, bad}, pixel));
        EXPECT_EQ(ray, Vec3d(7, 7, 7));
        EXPECT_EQ(pixel, Point2d(7, 7));
    }
    Point2d pixel(7, 7);
    EXPECT_FALSE(camera->projectPoint({0, 0, 0}, pixel));
    EXPECT_EQ(pixel, Point2d(7, 7));
}

// Far outside of any picture: either no ray, or a finite unit ray.
TEST_P(Gmlpnp_Camera, extreme_pixels_give_a_unit_ray_or_none)
{
    for (const double far : {1e3, 1e5, 1e8, 1e20, 1e100, 1e200, 1e308})
        for (const Point2d& pixel : {Point2d(far, 3), Point2d(-3, -far), Point2d(far, -far)}) {
            Vec3d ray;
            Matx32d J;
            if (!camera->unprojectPoint(pixel, ray, &J))
                continue;
            EXPECT_NEAR(ray.dot(ray), 1, 1e-12) << pixel;
            EXPECT_TRUE(std::isfinite(cv::norm(J))) << pixel;
        }
}

TEST_P(Gmlpnp_Camera, arrays_equal_single_points)
{
    std::vector<Point2d> pixels;
    for (int v = -2000; v < 3000; v += 211)
        for (int u = -2000; u < 3000; u += 197)
            pixels.emplace_back(u, v);
    Mat rays, valid, jacobian;
    camera->unproject(pixels, rays, valid, jacobian);
    const int n = static_cast<int>(pixels.size());
    ASSERT_EQ(rays.size(), Size(3, n));
    ASSERT_EQ(rays.type(), CV_64F);
    ASSERT_EQ(valid.size(), Size(1, n));
    ASSERT_EQ(valid.type(), CV_8U);
    ASSERT_EQ(jacobian.size(), Size(6, n));
    ASSERT_EQ(jacobian.type(), CV_64F);
    for (int i = 0; i < n; ++i) {
        Vec3d ray(0, 0, 0);
        Matx32d J = Matx32d::zeros();
        const bool seen = camera->unprojectPoint(pixels[i], ray, &J);
        ASSERT_EQ(valid.at<uchar>(i), seen ? 255 : 0);
        ASSERT_EQ(Vec3d(rays.ptr<double>(i)), ray);
        ASSERT_EQ(Matx32d(jacobian.ptr<double>(i)), J);
        ASSERT_TRUE(checkRange(rays.row(i)));
    }
}

// A batch with behind, zero and NaN: masked, and zero in the output.
TEST_P(Gmlpnp_Camera, masks_of_projection)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<Point3d> points = {{0.1, 0.2, 1}, {0, 0, 0}, {nan, 0, 1}, {-0.1, 0.1, 2}};
    Mat pixels, valid;
    camera->project(points, pixels, valid);
    ASSERT_EQ(pixels.size(), Size(2, 4));
    EXPECT_EQ(Vec4b(valid.ptr()), Vec4b(255, 0, 0, 255));
    EXPECT_EQ(cv::norm(pixels.rowRange(1, 3)), 0);
    Point2d first;
    ASSERT_TRUE(camera->projectPoint(Vec3d(points[0].x, points[0].y, points[0].z), first));
    EXPECT_EQ(pixels.at<double>(0, 0), first.x);
    EXPECT_EQ(pixels.at<double>(0, 1), first.y);
}

TEST_P(Gmlpnp_Camera, written_and_read_it_is_the_same_to_the_last_bit)
{
    for (const char* extension : {".yml", ".xml", ".json"}) {
        FileStorage out(extension, FileStorage::WRITE | FileStorage::MEMORY);
        out << "camera"
            << "{";
        camera->write(out);
        out << "}";
        const String text = out.releaseAndGetString();
        const FileStorage in(text, FileStorage::READ | FileStorage::MEMORY);
        const Ptr<CameraModel> again = CameraModel::read(in["camera"]);
        for (const Vec3d& m : grid) {
            Point2d a, b;
            ASSERT_TRUE(camera->projectPoint(m, a));
            ASSERT_TRUE(again->projectPoint(m, b));
            ASSERT_EQ(a, b) << extension << m;
        }
    }
}

String lensName(const testing::TestParamInfo<Lens>& info)
{
    return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(/**/, Gmlpnp_Camera, testing::ValuesIn(kLenses), lensName);

}  // namespace
}  // namespace opencv_test
