// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

// Memory runs out: each allocation of a call fails in turn, alone or with all that follow. The call throws, its outputs
// hold what they held before, and nothing is lost.

#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <vector>

#include "hooks.hpp"
#include "opencv2/gmlpnp.hpp"

namespace {

using cv::gmlpnp::Params;
using cv::gmlpnp::Result;

// What a call reads.
struct Scene
{
    std::vector<cv::Point3d> points;
    std::vector<cv::Point2f> pixels;
    std::vector<cv::Vec3d> rays;
    cv::Matx33d K{800, 0, 320, 0, 800, 240, 0, 0, 1};
    cv::Mat_<double> D = (cv::Mat_<double>(1, 5) << 0.1, -0.05, 0.001, -0.001, 0.01);
    cv::Ptr<cv::gmlpnp::CameraModel> camera = cv::gmlpnp::CameraModel::pinhole(K, D);
};

// Square points: a flat object has more than one pose, so that lists have more than one element.
Scene flatScene()
{
    cv::RNG rng(11);
    Scene scene;
    for (int i = 0; i < 40; ++i) {
        const cv::Vec3d X(rng.uniform(-1., 1.), rng.uniform(-1., 1.), 20);
        cv::Point2d pixel;
        EXPECT_TRUE(scene.camera->projectPoint(X, pixel));
        scene.rays.push_back(X);
        scene.pixels.push_back(pixel + cv::Point2d(rng.gaussian(1), rng.gaussian(1)));
        scene.points.emplace_back(X[0], X[1], 0);
    }
    return scene;
}

// What a call writes, in as many forms as outputs have.
struct Outputs
{
    cv::Mat rvec, tvec;  // empty
    cv::Vec3d rvecFixed{1, 2, 3}, tvecFixed{4, 5, 6};
    std::vector<double> rvecVector{7, 8};  // of another length
    cv::Mat tvecWrong{1, 5, CV_64F, cv::Scalar(1)};
    std::vector<cv::Mat> rvecs{cv::Mat(2, 2, CV_64F, cv::Scalar(1))};
    std::vector<cv::Vec3d> tvecs{{1, 1, 1}};
    std::vector<double> errors;
    cv::Mat inliers, rays, valid, jacobian;
    std::vector<cv::Vec3f> raysVector{{1, 2, 3}};
    std::vector<uchar> validVector;
    Result result;
    std::vector<Result> results{Result()};
};

// Everything they hold, as bytes and addresses.
std::vector<double> contents(const Outputs& out)
{
    std::vector<double> all;
    const auto add = [&](const cv::Mat& m) {
        all.insert(all.end(), {static_cast<double>(m.rows), static_cast<double>(m.cols), static_cast<double>(m.type()),
                               static_cast<double>(reinterpret_cast<size_t>(m.data))});
        if (!m.empty())
            all.push_back(cv::norm(m, cv::NORM_L1));
    };
    for (const cv::Mat* m : {&out.rvec, &out.tvec, &out.inliers, &out.rays, &out.valid, &out.jacobian})
        add(*m);
    add(out.tvecWrong);
    for (const cv::Mat& m : out.rvecs)
        add(m);
    const Result& r = out.result;
    for (const cv::Vec3d& v : {out.rvecFixed, out.tvecFixed, r.rvec, r.tvec, r.cameraCenter})
        all.insert(all.end(), v.val, v.val + 3);
    all.insert(all.end(), out.rvecVector.begin(), out.rvecVector.end());
    all.insert(all.end(), out.errors.begin(), out.errors.end());
    for (const cv::Vec3d& v : out.tvecs)
        all.insert(all.end(), v.val, v.val + 3);
    for (const cv::Vec3f& v : out.raysVector)
        all.insert(all.end(), v.val, v.val + 3);
    all.insert(all.end(), {static_cast<double>(r.status), r.cost, static_cast<double>(out.validVector.size()),
                           static_cast<double>(out.results.size()), static_cast<double>(out.rvecs.size())});
    for (const cv::Mat* m : {&r.poseCovariance, &r.objectNoise, &r.weights})
        add(*m);
    return all;
}

using Call = std::function<void(const Scene&, Outputs&)>;

// What became of one call with one fault.
struct Outcome
{
    bool failed;  // false: the call came to its end before that allocation
    bool threw, threwOther;
    long lost;  // blocks
};

template <class Run>
Outcome withFault(const Run& run, long number, bool onwards)
{
    Outcome outcome{};
    const long live = allocation::live();
    allocation::failAfter(number, onwards);
    try {
        run();
    } catch (const std::exception&) {
        outcome.threw = true;
    } catch (...) {
        outcome.threwOther = true;
    }
    outcome.failed = allocation::failed();
    allocation::failAfter(0);
    outcome.lost = allocation::live() - live;
    return outcome;
}

// OpenCV loses blocks of its own: cv::Mat::create() the pixels where their header cannot be allocated after them, and
// cv::projectPoints(). The sizes of the allocations whose failure loses one, found by the same means.
std::set<size_t> lossesOfOpenCV(const Scene& scene)
{
    const std::function<void()> calls[] = {[] { cv::Mat(3, 3, CV_64F); },
                                           [&] {
                                               cv::Mat projected;
                                               cv::projectPoints(cv::Mat(scene.points).reshape(1), cv::Vec3d(0.1, 0, 0),
                                                                 cv::Vec3d(0, 0, 20), cv::Mat(scene.K), scene.D,
                                                                 projected);
                                           }};
    std::set<size_t> sizes;
    for (const std::function<void()>& call : calls) {
        call();
        for (const bool onwards : {false, true})
            for (long number = 1;; ++number) {
                const Outcome outcome = withFault(call, number, onwards);
                if (!outcome.failed)
                    break;
                if (outcome.lost > 0)
                    sizes.insert(allocation::failedSize());
            }
    }
    return sizes;
}

class Faults : public testing::Test
{
protected:
    void SetUp() override
    {
        if (!allocation::counted())
            GTEST_SKIP() << "allocations cannot fail under a sanitizer or without glibc";
        cv::setNumThreads(1);
        scene = flatScene();
        theirLosses = lossesOfOpenCV(scene);
    }

    // False: the call came to its end before that allocation.
    bool failsCleanly(const Call& call, long number, bool onwards) const
    {
        Outputs outputs;
        const std::vector<double> before = contents(outputs);
        const Outcome outcome = withFault([&] { call(scene, outputs); }, number, onwards);
        if (!outcome.failed)
            return false;
        EXPECT_TRUE(outcome.threw) << (outcome.threwOther ? "not a std::exception" : "it went on without");
        EXPECT_TRUE(outcome.lost == 0 || (outcome.lost == 1 && theirLosses.count(allocation::failedSize()) > 0))
            << outcome.lost << " blocks lost after one of " << allocation::failedSize() << " bytes failed";
        EXPECT_TRUE(before == contents(outputs)) << "outputs touched";
        return true;
    }

    void expectClean(const Call& call) const
    {
        for (int k = 0; k < 2; ++k) {  // whatever a first call sets up
            Outputs outputs;
            call(scene, outputs);
        }
        for (const bool onwards : {false, true}) {
            long number = 1;
            while (failsCleanly(call, number, onwards) && !HasFailure())
                ++number;
            EXPECT_GT(number, 3) << "hardly an allocation failed";
            EXPECT_FALSE(HasFailure()) << "allocation " << number << (onwards ? " and all that follow" : "");
        }
    }

    Scene scene;
    std::set<size_t> theirLosses;
};

TEST_F(Faults, theHookFires)
{
    allocation::failAfter(1);
    void* volatile block = std::malloc(100);
    EXPECT_TRUE(allocation::failed());
    allocation::failAfter(0);
    EXPECT_EQ(nullptr, block);
    allocation::failAfter(1);
    EXPECT_THROW(cv::fastMalloc(1000), cv::Exception);
    allocation::failAfter(0);
    const long live = allocation::live();
    block = std::malloc(100);  // NOLINT(clang-analyzer-unix.Malloc): it is volatile, and freed below
    EXPECT_EQ(live + 1, allocation::live());
    std::free(block);
    EXPECT_EQ(live, allocation::live());
}

TEST_F(Faults, solve)
{
    expectClean([](const Scene& s, Outputs& out) { cv::gmlpnp::solve(s.points, s.pixels, s.K, s.D, out.result); });
    expectClean([](const Scene& s, Outputs& out) {
        Params params;
        params.method = cv::gmlpnp::SOLVEPNP_GMLPNP;
        params.pixelCovariances = cv::Mat(static_cast<int>(s.points.size()), 1, CV_64F, cv::Scalar(1));
        cv::gmlpnp::solve(s.points, s.pixels, s.camera, out.result, params);
    });
}

TEST_F(Faults, solveRays)
{
    expectClean([](const Scene& s, Outputs& out) { cv::gmlpnp::solveRays(s.points, s.rays, out.result); });
}

TEST_F(Faults, solveAll)
{
    expectClean([](const Scene& s, Outputs& out) { cv::gmlpnp::solveAll(s.points, s.pixels, s.camera, out.results); });
}

TEST_F(Faults, solvePnP)
{
    expectClean(
        [](const Scene& s, Outputs& out) { cv::gmlpnp::solvePnP(s.points, s.pixels, s.K, s.D, out.rvec, out.tvec); });
    expectClean([](const Scene& s, Outputs& out) {
        cv::gmlpnp::solvePnP(s.points, s.pixels, s.K, s.D, out.rvecFixed, out.tvecFixed);
    });
    expectClean([](const Scene& s, Outputs& out) {
        cv::gmlpnp::solvePnP(s.points, s.pixels, s.K, s.D, out.rvecVector, out.tvecWrong);
    });
}

TEST_F(Faults, solvePnPGeneric)
{
    expectClean([](const Scene& s, Outputs& out) {
        cv::gmlpnp::solvePnPGeneric(s.points, s.pixels, s.K, s.D, out.rvecs, out.tvecs, false,
                                    cv::gmlpnp::SOLVEPNP_GMLPNP_MARGINAL, cv::noArray(), cv::noArray(), out.errors);
    });
}

TEST_F(Faults, solvePnPRansac)
{
    expectClean([](const Scene& s, Outputs& out) {
        cv::gmlpnp::solvePnPRansac(s.points, s.pixels, s.K, s.D, out.rvecFixed, out.tvec, false, 50, 8, 0.99,
                                   out.inliers);
    });
}

TEST_F(Faults, solveRansac)
{
    expectClean([](const Scene& s, Outputs& out) {
        cv::gmlpnp::solveRansac(s.points, s.pixels, s.camera, out.result, out.inliers);
    });
}

TEST_F(Faults, unproject)
{
    expectClean([](const Scene& s, Outputs& out) { s.camera->unproject(s.pixels, out.rays, out.valid, out.jacobian); });
    expectClean([](const Scene& s, Outputs& out) { s.camera->unproject(s.pixels, out.raysVector, out.validVector); });
}

}  // namespace
