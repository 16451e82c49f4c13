// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "every_lens.hpp"

namespace opencv_test {
namespace camera {

void PrintTo(const Lens& lens, std::ostream* os)
{
    *os << lens.name;
}

String lensName(const testing::TestParamInfo<Lens>& info)
{
    return info.param.name;
}

namespace {

using Coefficients = std::vector<double>;

const Matx33d kTum = matrixK(517.3, 516.5, 318.6, 255.3);
const Matx33d kWide = matrixK(190.9785, 190.9733, 254.9317, 256.8974);
const Matx33d kSkewed = matrixK(407.63, 409.18, 630.66, 431.52, 0.8);

}  // namespace

std::vector<Lens> everyLens()
{
    return {
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
}

}  // namespace camera
}  // namespace opencv_test
