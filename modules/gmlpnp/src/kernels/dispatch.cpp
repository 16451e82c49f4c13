// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../precomp.hpp"

#include <opencv2/core/utility.hpp>

#include "dispatch.hpp"

namespace cv {
namespace gmlpnp {
namespace detail {

namespace {

bool available(const RayKernels& kernels)
{
    const auto machineHas = [](std::initializer_list<int> features) {
        return std::all_of(features.begin(), features.end(), checkHardwareSupport);
    };
    if (!kernels.pass)
        return false;
    if (&kernels == &RAY_KERNELS_AVX512)
        return machineHas({CV_CPU_AVX_512F, CV_CPU_AVX_512DQ, CV_CPU_AVX_512VL, CV_CPU_AVX512_SKX, CV_CPU_FMA3});
    return &kernels != &RAY_KERNELS_AVX2 || machineHas({CV_CPU_AVX2, CV_CPU_FMA3});
}

}  // namespace

const std::vector<const RayKernels*>& availableKernels()
{
    // The list is never destroyed, because threads may still solve while the program ends.
    static const auto* const AVAILABLE = [] {
        auto* const out = new std::vector<const RayKernels*>;
        for (const RayKernels* kernels :
             {&RAY_KERNELS_AVX512, &RAY_KERNELS_AVX2, &RAY_KERNELS_VECTOR, &RAY_KERNELS_SCALAR})
            if (available(*kernels))
                out->push_back(kernels);
        return out;
    }();
    return *AVAILABLE;
}

const RayKernels& rayKernels(int points)
{
    for (const RayKernels* kernels : availableKernels())
        if (kernels->lanes <= points)
            return *kernels;
    return RAY_KERNELS_SCALAR;
}

double logarithm(const ScaledProduct& product)
{
    return std::log(product.mantissa) + CV_LOG2 * static_cast<double>(product.exponent);
}

}  // namespace detail
}  // namespace gmlpnp
}  // namespace cv
