// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#ifndef OPENCV_TEST_GMLPNP_EVERY_LENS_HPP
#define OPENCV_TEST_GMLPNP_EVERY_LENS_HPP

#include "camera_util.hpp"

// What holds for every lens is asked of each of these.

namespace opencv_test {
namespace camera {

struct Lens
{
    const char* name;
    double maxAngle;  // degrees: every direction up to here is seen
    std::function<Ptr<CameraModel>()> make;
};

std::vector<Lens> everyLens();

void PrintTo(const Lens& lens, std::ostream* os);

String lensName(const testing::TestParamInfo<Lens>& info);

class Gmlpnp_Camera : public testing::TestWithParam<Lens>
{
protected:
    Ptr<CameraModel> camera = GetParam().make();
    std::vector<Vec3d> grid = polarGrid(GetParam().maxAngle * kDegree);
};

}  // namespace camera
}  // namespace opencv_test

#endif  // OPENCV_TEST_GMLPNP_EVERY_LENS_HPP
