// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "kernel_data.hpp"

// Passes of each instruction set against the scalar ones, for numbers of points that fill the lanes and that do not.

namespace opencv_test {
namespace {

using namespace kernels;

struct Noises
{
    const char* name;
    bool bearing, tails, known;
};

const Noises NOISES[] = {{"object", false, false, false}, {"object, tails", false, true, false},
                         {"both", true, false, false},    {"both, tails", true, true, false},
                         {"known", false, false, true},   {"known, tails", true, true, true}};

void expectSame(const RaySums& a, const RaySums& b, int n)
{
    EXPECT_TRUE(near(a.H, b.H));
    EXPECT_TRUE(near(a.g, b.g));
    EXPECT_TRUE(near(a.Zo, b.Zo));
    EXPECT_TRUE(near(a.Go, b.Go));
    EXPECT_TRUE(near(a.Zb, b.Zb));
    EXPECT_TRUE(near(a.Gb, b.Gb));
    EXPECT_TRUE(near(a.QQ, b.QQ));
    EXPECT_TRUE(near(a.c, b.c, a.c));
    EXPECT_TRUE(near(a.c2, b.c2, a.c2));
    EXPECT_TRUE(near(a.misfit, b.misfit, a.misfit));
    EXPECT_TRUE(near(a.L, b.L, std::abs(a.L) + 10 * n));
    EXPECT_EQ(a.inFront, b.inFront);
}

TEST(Gmlpnp_RayKernels, scalarOnesAreThereAndTheBestComesFirst)
{
    const std::vector<const RayKernels*>& all = availableKernels();
    ASSERT_FALSE(all.empty());
    EXPECT_STREQ("scalar", all.back()->name);
    EXPECT_EQ(all.front(), &rayKernels(all.front()->lanes));
    EXPECT_EQ(all.back(), &rayKernels(1));
    std::cout << "instruction sets:";
    for (const RayKernels* kernels : all)
        std::cout << " " << kernels->name;
    std::cout << std::endl;
}

TEST(Gmlpnp_RayKernels, passesAgreeWithTheScalarOne)
{
    cv::RNG rng = testRng();
    for (const RayKernels* kernels : availableKernels())
        for (const Noises& noises : NOISES)
            for (int n : sizesFor(*kernels)) {
                SCOPED_TRACE(testing::Message() << kernels->name << ", " << noises.name << ", " << n << " points");
                const Correspondences data = randomData(rng, n, noises.known);
                const Pose pose = somePose(rng);
                Noise noise;
                noise.Sigma = randomNoise(rng, 0.2);
                noise.Gamma = noises.bearing ? randomNoise(rng, 0.05) : Matrix3d(Matrix3d::Zero());
                noise.tails.share = noises.tails ? 0.2 : 0;
                std::vector<double> c(n), cScalar(n);
                const RaySums found =
                    rayPass(data, pose, noise, {LeverArm::CORRECTED, OF_BEARING, c.data(), n > 7}, *kernels);
                expectSame(rayPass(data, pose, noise, {LeverArm::CORRECTED, OF_BEARING, cScalar.data(), n > 7},
                                   *availableKernels().back()),
                           found, n);
                for (int i = 0; i < n; ++i)
                    EXPECT_TRUE(near(cScalar[i], c[i], 100 * (1 + cScalar[i])));
            }
}

// The sums of products against the terms of the points that are asked for them, in proportion.
TEST(Gmlpnp_RayKernels, productsAreThoseOfQ)
{
    cv::RNG rng = testRng();
    const Correspondences data = randomData(rng, 23, false);
    const Pose pose = somePose(rng);
    const Noise noise{randomNoise(rng, 0.2), randomNoise(rng, 0.05), {0}};
    for (bool sampled : {false, true}) {
        Matrix6d object = Matrix6d::Zero(), bearing = object, mixed = object;
        for (int i = 0; i < data.size(); ++i) {
            if (sampled && i % 16 >= 4)
                continue;
            const double weight = sampled ? data.size() / 8. : 1;
            const PointTerms at = pointTerms(data, i, pose, noise);
            Vector6d q;
            q << at.Q(0, 0), at.Q(0, 1), at.Q(0, 2), at.Q(1, 1), at.Q(1, 2), at.Q(2, 2);
            object += weight * q * q.transpose();
            bearing += weight * std::pow(at.s, 4) * q * q.transpose();
            mixed += weight * at.s * at.s * q * q.transpose();
        }
        const auto sumsOf = [&](Products products) {
            return rayPass(data, pose, noise, {LeverArm::CORRECTED, products, nullptr, sampled}).QQ;
        };
        EXPECT_TRUE(matrixNear(sumsOf(OF_OBJECT), object, 1e-9 * object.norm()));
        EXPECT_TRUE(matrixNear(sumsOf(OF_BEARING), bearing, 1e-9 * bearing.norm()));
        for (const RayKernels* kernels : availableKernels()) {
            const RayProducts products = rayProducts(data, pose, noise, *kernels);
            EXPECT_TRUE(sampled || matrixNear(products.object, object, 1e-9 * object.norm()));
            EXPECT_TRUE(sampled || matrixNear(products.bearing, bearing, 1e-9 * bearing.norm()));
            EXPECT_TRUE(sampled || matrixNear(products.both, mixed, 1e-9 * mixed.norm()));
        }
    }
}

}  // namespace
}  // namespace opencv_test
