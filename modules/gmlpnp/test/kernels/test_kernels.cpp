// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "../../src/rays/ray_pass.hpp"
#include "../scenes.hpp"

// Each instruction set against the scalar loops, for numbers of points that fill the lanes and that do not.

namespace opencv_test {
namespace {

using namespace cv::gmlpnp::detail;

struct Noises
{
    const char* name;
    bool bearing, tails, known;
};

const Noises NOISES[] = {{"object", false, false, false}, {"object, tails", false, true, false},
                         {"both", true, false, false},    {"both, tails", true, true, false},
                         {"known", false, false, true},   {"known, tails", true, true, true}};

// Every number of lanes that the last block may lack, and a large number of points.
std::vector<int> sizesFor(const RayKernels& kernels)
{
    std::vector<int> out = {203};
    for (int n = std::max(2, kernels.lanes); n <= 40; ++n)
        out.push_back(n);
    return out;
}

Correspondences randomData(cv::RNG& rng, int n, bool known)
{
    const Scene scene = exactScene(rng, surroundingPoints(rng, n));
    cv::Mat_<double> points = scene.objectPoints.clone(), object, rays;
    for (double& x : points)
        x += rng.gaussian(0.05);
    if (known) {
        object.create(n, 9);
        rays.create(n, 9);
        for (int i = 0; i < n; ++i) {
            Eigen::Map<Matrix3d>{object[i]} = randomNoise(rng, 0.1);
            Eigen::Map<Matrix3d>{rays[i]} = randomNoise(rng, 0.01);
        }
    }
    return Correspondences(points, scene.rays, object, rays);
}

Pose somePose(cv::RNG& rng)
{
    return {randomRotation(rng), 2 * gaussian3(rng)};
}

testing::AssertionResult near(double a, double b, double size)
{
    constexpr double ROUNDING = 1e-12;  // of sums of 200 terms in another order, and with fused multiplications
    if (std::abs(a - b) <= ROUNDING * (std::abs(size) + 1e-300))
        return testing::AssertionSuccess();
    return testing::AssertionFailure() << a << " and " << b << " differ by " << a - b;
}

template <class Matrix>
testing::AssertionResult near(const Matrix& a, const Matrix& b)
{
    return matrixNear(a, b, 1e-11 * a.norm());
}

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

TEST(Gmlpnp_RayKernels, preparedColumnsAreCentredAndUnit)
{
    cv::RNG rng = testRng();
    for (const RayKernels* kernels : availableKernels())
        for (int n : sizesFor(*kernels)) {
            SCOPED_TRACE(testing::Message() << kernels->name << ", " << n << " points");
            Eigen::MatrixXd points(n, 3), rays(n, 3);
            for (int i = 0; i < n; ++i) {
                points.row(i) = gaussian3(rng).transpose();
                rays.row(i) = 3 * gaussian3(rng).transpose();
            }
            const Vector3d centre = gaussian3(rng);
            auto centred = points, unit = rays;
            double* point[3] = {&centred(0, 0), &centred(0, 1), &centred(0, 2)};
            double* ray[3] = {&unit(0, 0), &unit(0, 1), &unit(0, 2)};
            ColumnSums sums;
            kernels->prepare(point, ray, n, centre.data(), sums);

            EXPECT_TRUE(near(centred, Eigen::MatrixXd(points.rowwise() - centre.transpose())));
            EXPECT_TRUE(near(unit, Eigen::MatrixXd(rays.rowwise().normalized())));
            EXPECT_TRUE(near(symmetric(sums.scatter), Matrix3d(centred.transpose() * centred)));
            EXPECT_NEAR(sums.ray2, rays.squaredNorm(), 1e-11 * n);
            EXPECT_NEAR(sums.inverse2, rays.rowwise().squaredNorm().cwiseInverse().sum(), 1e-11 * sums.inverse2);
            EXPECT_NEAR(sums.apart2, (unit.rowwise() - unit.row(0)).squaredNorm(), 1e-11 * n);
        }
}

TEST(Gmlpnp_RayKernels, smallLoopsAgreeWithTheirDefinition)
{
    cv::RNG rng = testRng();
    for (const RayKernels* kernels : availableKernels())
        for (int n : sizesFor(*kernels)) {
            SCOPED_TRACE(testing::Message() << kernels->name << ", " << n << " points");
            const Correspondences data = randomData(rng, n, false);
            const Pose pose = somePose(rng);
            double at[12];
            Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>{at} = pose.R;
            Eigen::Map<Vector3d>{at + 9} = pose.t;

            std::vector<double> x(n), y(n);
            kernels->residuals(data.arrays(), at, x.data(), y.data());
            MomentSums moments;
            kernels->moments(data.arrays(), moments);
            LineSums line;
            kernels->line(x.data(), y.data(), n, 0.3, 0.7, line);
            const Tails tails[TRIED_TAILS] = {{0.3, 4, 1}, {0.1}, {1, 1, 5}, {0.01, 100, 4}};
            const double factors[TRIED_TAILS] = {2.5, 1, 0.1, 40};
            TailSums tailSums[TRIED_TAILS];
            kernels->tails(x.data(), n, tails, factors, tailSums);

            int behind = 0;
            double logTails[TRIED_TAILS] = {}, wc[TRIED_TAILS] = {}, logVariance = 0, wxy = 0, misfit = 0;
            Matrix3d Q = Matrix3d::Zero(), yzQ = Matrix3d::Zero();
            for (int i = 0; i < n; ++i) {
                const Vector3d m = data.rayAt(i), p = data.pointAt(i), X = pose * p;
                const double s2 = m.dot(X) * m.dot(X), v2 = 0.5 * m.cross(X).squaredNorm(), variance = 0.3 + 0.7 * s2;
                EXPECT_TRUE(near(s2, x[i], 100 * X.squaredNorm()));
                EXPECT_TRUE(near(v2, y[i], 100 * X.squaredNorm()));
                behind += m.dot(X) < 0;
                for (int k = 0; k < TRIED_TAILS; ++k) {
                    const TailTerms tailed = tailTerms(tails[k], s2 / factors[k]);
                    logTails[k] += std::log(tailed.g);
                    wc[k] += tailed.w * s2 / factors[k];
                }
                logVariance += std::log(variance);
                wxy += s2 * v2 / (variance * variance);
                misfit += v2 / variance;
                Q += Matrix3d::Identity() - m * m.transpose();
                yzQ += p(1) * p(2) * (Matrix3d::Identity() - m * m.transpose());
            }
            EXPECT_EQ(behind, kernels->behind(data.arrays(), at));
            for (int k = 0; k < TRIED_TAILS; ++k) {
                EXPECT_TRUE(near(logTails[k], logarithm(tailSums[k].g), 1 - logTails[k]));
                EXPECT_TRUE(near(wc[k], tailSums[k].wc, wc[k]));
            }
            EXPECT_TRUE(near(logVariance, logarithm(line.variance), 1 + n));
            EXPECT_TRUE(near(wxy, line.wxy, wxy));
            EXPECT_TRUE(near(misfit, line.misfit, misfit));
            EXPECT_TRUE(matrixNear(symmetric(moments.Q), Q, 1e-12 * n));
            EXPECT_TRUE(matrixNear(symmetric(moments.ppQ[4]), yzQ, 1e-11 * n));
        }
}

// Far more factors than the range of a double allows.
TEST(Gmlpnp_RayKernels, productsDoNotLeaveTheRange)
{
    const int n = 4001;
    const std::vector<double> small(n, 0.), c(n, 1e100);
    for (const RayKernels* kernels : availableKernels()) {
        LineSums line;
        kernels->line(small.data(), small.data(), n, 1e-40, 0, line);
        EXPECT_NEAR(logarithm(line.variance), n * std::log(1e-40), 1e-9 * n) << kernels->name;
        const Tails student{1, 1, 2}, tails[TRIED_TAILS] = {student, student, student, student};
        const double factors[TRIED_TAILS] = {1, 1, 1, 1};
        TailSums sums[TRIED_TAILS];
        kernels->tails(c.data(), n, tails, factors, sums);  // g = (1 + c / 2)^-2
        EXPECT_NEAR(logarithm(sums[0].g), -2 * n * std::log(0.5e100), 1e-9 * n) << kernels->name;
    }
}

}  // namespace
}  // namespace opencv_test
