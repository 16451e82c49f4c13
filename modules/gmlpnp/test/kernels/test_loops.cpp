// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "../test_precomp.hpp"

#include "kernel_data.hpp"

// The small loops of each instruction set against their definitions.

namespace opencv_test {
namespace {

using namespace kernels;

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
                const Vector3d m = data.scaledRayAt(i), p = data.pointAt(i), X = pose * p;
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
