// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include <gtest/gtest.h>

#include <functional>

#include "baselines/baselines.hpp"
#include "baselines/polynomial_system.hpp"
#include "test/synthetic.hpp"

// The baselines on exact data, against independent solvers, and against what their papers promise.

namespace {

using namespace baselines;
using cv::gmlpnp::detail::expSO3;
using synthetic::Scene;

Data dataOf(const Scene& scene)
{
    const int n = scene.objectPoints.rows;
    Data data{Matrix3Xd(3, n), Matrix3Xd(3, n), Matrix2Xd(2, n)};
    for (int i = 0; i < n; ++i) {
        data.points.col(i) = Eigen::Map<const Vector3d>(scene.objectPoints.ptr<double>(i));
        data.rays.col(i) = Eigen::Map<const Vector3d>(scene.rays.ptr<double>(i));
        data.image.col(i) = data.rays.col(i).hnormalized();
    }
    return data;
}

Uncertainty uncertaintyOf(const Scene& scene)
{
    const int n = scene.objectPoints.rows;
    return {std::vector<Matrix3d>(n, scene.Sigma), std::vector<Matrix2d>(n, scene.pixelCovariance / (800. * 800.))};
}

// Of the rays, camera frame: pixel noise, and object noise seen from the camera.
std::vector<Matrix3d> rayCovariancesOf(const Scene& scene, const Data& data)
{
    const Uncertainty uncertainty = uncertaintyOf(scene);
    std::vector<Matrix3d> covariances;
    for (int i = 0; i < data.size(); ++i) {
        const Vector3d m = data.rays.col(i);
        Eigen::Matrix<double, 3, 2> J;  // of the unit ray by the point of the image plane
        J = m.z() * (Matrix3d::Identity() - m * m.transpose()).leftCols<2>();
        const double depth = (scene.truth * data.points.col(i)).norm();
        covariances.emplace_back(J * uncertainty.image[i] * J.transpose() +
                                 scene.truth.R * scene.Sigma * scene.truth.R.transpose() / (depth * depth));
    }
    return covariances;
}

double distance(const std::optional<Pose>& pose, const Scene& scene)
{
    return pose ? (pose->t - scene.truth.t).norm() / scene.truth.t.norm() : 1.;
}

double angle(const std::optional<Pose>& pose, const Scene& scene)
{
    return pose ? synthetic::rotationAngle(pose->R, scene.truth.R) : CV_PI;
}

// Mean errors of solvers on the same problems.
struct Errors
{
    double rotation = 0, translation = 0;
};

using Solver = std::function<std::optional<Pose>(const Scene&, const Data&)>;

std::vector<Errors> meanErrors(const std::vector<Solver>& solvers, int problems,
                               const std::function<Scene(cv::RNG&)>& draw)
{
    std::vector<Errors> errors(solvers.size());
    for (int k = 0; k < problems; ++k) {
        cv::RNG rng(1000 + k);
        const Scene scene = draw(rng);
        const Data data = dataOf(scene);
        for (size_t s = 0; s < solvers.size(); ++s) {
            const std::optional<Pose> pose = solvers[s](scene, data);
            errors[s].rotation += angle(pose, scene) / problems;
            errors[s].translation += distance(pose, scene) / problems;
        }
    }
    return errors;
}

std::function<Scene(cv::RNG&)> paperProtocol(int n, double sigma, double px)
{
    return [=](cv::RNG& rng) { return synthetic::paperScene(rng, n, sigma, px); };
}

// Every solver in its plain form, for the tests that all must pass.
struct Named
{
    const char* name;
    Solver solve;
    bool planar;
    double exact;  // error on exact data
};

void PrintTo(const Named& solver, std::ostream* out)
{
    *out << solver.name;
}

Uncertainty alike(int n)
{
    return {std::vector<Matrix3d>(n, 1e-4 * Matrix3d::Identity()),
            std::vector<Matrix2d>(n, 1e-6 * Matrix2d::Identity())};
}

std::vector<Named> allSolvers()
{
    std::vector<Named> solvers = {
        {"ppnp", [](const Scene&, const Data& d) { return ppnp(d); }, true, 1e-5},
        {"mlpnp", [](const Scene&, const Data& d) { return mlpnp(d); }, true, 1e-9},
        {"cpnp", [](const Scene&, const Data& d) { return cpnp(d); }, false, 1e-9},
        {"reppnp", [](const Scene&, const Data& d) { return reppnp(d, 0.01); }, true, 1e-6},
        {"epnp", [](const Scene&, const Data& d) { return epnp(d); }, true, 1e-6},
        {"epnpu", [](const Scene&, const Data& d) { return epnpu(d, alike(d.size())); }, true, 1e-9},
        {"dls", [](const Scene&, const Data& d) { return dls(d); }, true, 1e-9},
        {"dlsu", [](const Scene&, const Data& d) { return dlsu(d, alike(d.size())); }, true, 1e-9}};
    if (haveUpnp())
        solvers.push_back({"upnp", [](const Scene&, const Data& d) { return upnp(d); }, true, 1e-6});
    return solvers;
}

class Baselines : public testing::TestWithParam<Named>
{};

TEST_P(Baselines, areExactOnExactData)
{
    for (const bool flat : {false, true}) {
        if (flat && !GetParam().planar)
            continue;
        for (int k = 0; k < 50; ++k) {
            SCOPED_TRACE(testing::Message() << "scene " << k << (flat ? " flat" : ""));
            cv::RNG rng(k + 1);
            const Scene scene = synthetic::exactScene(rng, synthetic::boxPoints(rng, 12 + k, flat));
            const std::optional<Pose> pose = GetParam().solve(scene, dataOf(scene));
            ASSERT_TRUE(pose);
            EXPECT_LT(angle(pose, scene), GetParam().exact);
            EXPECT_LT(distance(pose, scene), GetParam().exact);
        }
    }
}

// Little noise, small errors: 1 px and 1 cm at 6 m are about 2 mrad, over the root of 60 points, times the geometry.
TEST_P(Baselines, areCloseOnSlightlyNoisyData)
{
    for (int k = 0; k < 50; ++k) {
        SCOPED_TRACE(testing::Message() << "scene " << k);
        cv::RNG rng(k + 1);
        const Scene scene = synthetic::paperScene(rng, 60, 0.01, 1);
        const std::optional<Pose> pose = GetParam().solve(scene, dataOf(scene));
        ASSERT_TRUE(pose);
        EXPECT_LT(angle(pose, scene), 8e-3);
        EXPECT_LT(distance(pose, scene), 8e-3);
    }
}

INSTANTIATE_TEST_SUITE_P(All, Baselines, testing::ValuesIn(allSolvers()),
                         [](const auto& named) { return std::string(named.param.name); });

// PPnP's cost is the sum of squared distances from the rays, which GMLPnP* minimises for isotropic object noise.
TEST(Ppnp, convergesToTheMinimumOfItsCost)
{
    cv::gmlpnp::Params params;
    params.method = cv::gmlpnp::SOLVEPNP_GMLPNP;
    params.maxRounds = 50;
    params.objectNoise = cv::Mat::eye(3, 3, CV_64F);
    for (int k = 0; k < 50; ++k) {
        cv::RNG rng(k + 1);
        const Scene scene = synthetic::paperScene(rng, 20 + 3 * k, 0.1, 1);
        cv::gmlpnp::Result result;
        ASSERT_TRUE(cv::gmlpnp::solveRays(scene.objectPoints, scene.rays, result, params));
        const std::optional<Pose> pose = ppnp(dataOf(scene));
        ASSERT_TRUE(pose);
        const Vector3d rvec(result.rvec[0], result.rvec[1], result.rvec[2]);
        EXPECT_LT(synthetic::rotationAngle(pose->R, expSO3(rvec)), 3e-6);
        EXPECT_LT((pose->t - Vector3d(result.tvec[0], result.tvec[1], result.tvec[2])).norm(), 3e-5);
    }
}

// Weights in the wrong frame would do harm: they are strongly anisotropic here.
TEST(Mlpnp, covariancesInTheCameraFrameHelp)
{
    const std::vector<Errors> errors = meanErrors(
        {[](const Scene& s, const Data& d) { return mlpnp(d, rayCovariancesOf(s, d)); },
         [](const Scene&, const Data& d) { return mlpnp(d); }, [](const Scene&, const Data& d) { return epnp(d); },
         [](const Scene& s, const Data& d) {
             Scene turned = s;  // the same covariance taken for one of the camera frame
             turned.Sigma = s.truth.R.transpose() * s.Sigma * s.truth.R;
             return mlpnp(d, rayCovariancesOf(turned, d));
         }},
        300, paperProtocol(50, 0.1, 1));
    EXPECT_LT(errors[0].rotation, 0.95 * errors[1].rotation);
    EXPECT_LT(errors[0].translation, 0.95 * errors[1].translation);
    EXPECT_LT(errors[0].rotation, 0.9 * errors[2].rotation);
    EXPECT_LT(errors[0].translation, 0.9 * errors[2].translation);
    EXPECT_LT(errors[0].rotation, 0.9 * errors[3].rotation);
}

// A plane that noise has thickened has no exact planar solution, and leaves the general one undetermined.
TEST(Mlpnp, solvesNoisyPlanes)
{
    for (int k = 0; k < 50; ++k) {
        SCOPED_TRACE(k);
        cv::RNG rng(k + 1);
        Scene scene = synthetic::exactScene(rng, synthetic::boxPoints(rng, 60, true));
        synthetic::disturb(rng, scene, 0.01, 1, *cv::gmlpnp::CameraModel::pinhole(synthetic::paperCamera()));
        const std::optional<Pose> pose = mlpnp(dataOf(scene));
        EXPECT_LT(angle(pose, scene), 0.02);
        EXPECT_LT(distance(pose, scene), 0.01);
    }
}

// CPnP assumes isotropic noise of the pixels.
std::function<Scene(cv::RNG&)> isotropicPixels(int n, double px)
{
    return [=](cv::RNG& rng) {
        Scene scene = synthetic::exactScene(rng, synthetic::boxPoints(rng, n));
        for (int i = 0; i < n; ++i) {
            Vector3d X(scene.rays(i, 0) / scene.rays(i, 2), scene.rays(i, 1) / scene.rays(i, 2), 1);
            X += Vector3d(rng.gaussian(px / 800), rng.gaussian(px / 800), 0);
            for (int k = 0; k < 3; ++k)
                scene.rays(i, k) = X.normalized()(k);
        }
        return scene;
    };
}

// The closed form alone: sixteen times the points give a quarter of the error; without the elimination of the bias the
// translation ends at its bias.
TEST(Cpnp, isConsistentByItsEliminationOfBias)
{
    const Solver eliminated = [](const Scene&, const Data& d) { return cpnp(d, {true, 0}); };
    const Solver plain = [](const Scene&, const Data& d) { return cpnp(d, {false, 0}); };
    const std::vector<Errors> few = meanErrors({eliminated, plain}, 200, isotropicPixels(250, 20));
    const std::vector<Errors> many = meanErrors({eliminated, plain}, 200, isotropicPixels(4000, 20));
    EXPECT_NEAR(many[0].rotation / few[0].rotation, 0.25, 0.05);
    EXPECT_NEAR(many[0].translation / few[0].translation, 0.25, 0.05);
    EXPECT_GT(many[1].translation / few[1].translation, 0.4);
    EXPECT_LT(many[0].translation, 0.6 * many[1].translation);
}

TEST(Cpnp, oneStepOfGaussNewtonReachesTheMinimum)
{
    const std::vector<Errors> errors = meanErrors({[](const Scene&, const Data& d) {
                                                       return cpnp(d, {true, 0});
                                                   },
                                                   [](const Scene&, const Data& d) {
                                                       return cpnp(d, {true, 1});
                                                   },
                                                   [](const Scene&, const Data& d) {
                                                       return cpnp(d, {true, 20});
                                                   }},
                                                  100, paperProtocol(1000, 0, 2));
    EXPECT_LT(errors[1].rotation, 0.9 * errors[0].rotation);
    EXPECT_NEAR(errors[1].rotation / errors[2].rotation, 1, 0.02);
    EXPECT_NEAR(errors[1].translation / errors[2].translation, 1, 0.02);
}

TEST(Cpnp, hasNoPoseForPlanes)
{
    cv::RNG rng(1);
    EXPECT_FALSE(cpnp(dataOf(synthetic::exactScene(rng, synthetic::boxPoints(rng, 30, true)))));
}

// Of 100 points some get pixels anywhere in the picture.
TEST(Reppnp, survivesOutliers)
{
    for (const int outliers : {0, 10, 30}) {
        const auto draw = [outliers](cv::RNG& rng) {
            Scene scene = synthetic::paperScene(rng, 100, 0.01, 1);
            for (int i = 0; i < outliers; ++i) {
                const Vector3d X(rng.uniform(0., 640.) - 320, rng.uniform(0., 480.) - 240, 800);
                for (int k = 0; k < 3; ++k)
                    scene.rays(i, k) = X.normalized()(k);
            }
            return scene;
        };
        const double bound = 0.007;  // three standard deviations
        const std::vector<Errors> errors = meanErrors({[=](const Scene&, const Data& d) { return reppnp(d, bound); },
                                                       [](const Scene&, const Data& d) { return epnp(d); }},
                                                      100, draw);
        EXPECT_LT(errors[0].rotation, 3e-3) << outliers;
        EXPECT_LT(errors[0].translation, 3e-3) << outliers;
        if (outliers > 0) {
            EXPECT_LT(errors[0].rotation, 0.1 * errors[1].rotation);
        }
    }
}

// Points of different quality, known: half of them ten times worse.
Scene unequalScene(cv::RNG& rng, int n)
{
    Scene scene = synthetic::exactScene(rng, synthetic::boxPoints(rng, n));
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < 3; ++k)
            scene.objectPoints(i, k) += rng.gaussian(i % 2 ? 0.2 : 0.02);
    return scene;
}

Uncertainty unequalUncertainty(int n)
{
    Uncertainty uncertainty;
    for (int i = 0; i < n; ++i) {
        uncertainty.object.emplace_back((i % 2 ? 0.04 : 0.0004) * Matrix3d::Identity());
        uncertainty.image.emplace_back(Matrix2d::Zero());
    }
    return uncertainty;
}

TEST(Epnpu, uncertaintiesImproveOnEpnp)
{
    const std::vector<Errors> unequal =
        meanErrors({[](const Scene&, const Data& d) { return epnpu(d, unequalUncertainty(d.size())); },
                    [](const Scene&, const Data& d) { return epnp(d); }},
                   100, [](cv::RNG& rng) { return unequalScene(rng, 50); });
    EXPECT_LT(unequal[0].rotation, 0.5 * unequal[1].rotation);
    EXPECT_LT(unequal[0].translation, 0.5 * unequal[1].translation);
    const std::vector<Errors> paper =
        meanErrors({[](const Scene& s, const Data& d) { return epnpu(d, uncertaintyOf(s)); },
                    [](const Scene&, const Data& d) { return epnp(d); }},
                   300, paperProtocol(50, 0.1, 1));
    EXPECT_LT(paper[0].rotation, 0.9 * paper[1].rotation);
    EXPECT_LT(paper[0].translation, 0.9 * paper[1].translation);
}

TEST(Dlsu, uncertaintiesImproveOnDls)
{
    const std::vector<Errors> unequal =
        meanErrors({[](const Scene&, const Data& d) { return dlsu(d, unequalUncertainty(d.size())); },
                    [](const Scene&, const Data& d) { return dls(d); }},
                   100, [](cv::RNG& rng) { return unequalScene(rng, 50); });
    EXPECT_LT(unequal[0].rotation, 0.5 * unequal[1].rotation);
    EXPECT_LT(unequal[0].translation, 0.5 * unequal[1].translation);
    const std::vector<Errors> paper =
        meanErrors({[](const Scene& s, const Data& d) { return dlsu(d, uncertaintyOf(s)); },
                    [](const Scene&, const Data& d) { return dls(d); }},
                   100, paperProtocol(50, 0.1, 1));
    EXPECT_LT(paper[0].rotation, 0.95 * paper[1].rotation);
    EXPECT_LT(paper[0].translation, 0.95 * paper[1].translation);
}

// OpenCV's EPnP is another implementation of the same paper. Both sort their candidates differently, so not each pose
// is the same, but the errors are.
TEST(Epnp, isAsGoodAsOpenCV)
{
    const std::vector<Errors> errors =
        meanErrors({[](const Scene&, const Data& d) { return epnp(d); },
                    [](const Scene& s, const Data&) -> std::optional<Pose> {
                        cv::Vec3d r, t;
                        cv::solvePnP(s.objectPoints, s.imagePoints, synthetic::paperCamera(), cv::noArray(), r, t,
                                     false, cv::SOLVEPNP_EPNP);
                        return Pose{expSO3({r[0], r[1], r[2]}), {t[0], t[1], t[2]}};
                    }},
                   300, paperProtocol(50, 0.1, 1));
    EXPECT_LT(errors[0].rotation, 1.05 * errors[1].rotation);
    EXPECT_LT(errors[0].translation, 1.05 * errors[1].translation);
}

// Cubics with 27 known real roots: products of three planes in each variable.
TEST(PolynomialSystem, findsAllRoots)
{
    const auto x = [](int k) { return Polynomial::variable(k); };
    const auto c = [](double value) { return Polynomial::constant(value); };
    std::array<Polynomial, 3> cubics;
    const double roots[3] = {-1.1, 0.3, 1.7};
    for (int k = 0; k < 3; ++k)
        cubics[k] = (x(k) - c(roots[0])) * (x(k) - c(roots[1])) * (x(k) - c(roots[2]));
    const std::vector<Vector3d> found = realRoots(cubics);
    ASSERT_EQ(27u, found.size());
    for (const double a : roots)
        for (const double b : roots)
            for (const double d : roots) {
                double nearest = 1;
                for (const Vector3d& s : found)
                    nearest = std::min(nearest, (s - Vector3d(a, b, d)).norm());
                EXPECT_LT(nearest, 1e-7);
            }
}

}  // namespace
