// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "faults.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <new>
#include <thread>

#include <opencv2/core/utility.hpp>

#include "hooks.hpp"

namespace allocation {

namespace {

using cv::gmlpnp::Result;

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

// Numbers and addresses, one after the other.
class Contents
{
public:
    std::vector<double> all;

    template <class Number>
    void add(const std::vector<Number>& numbers)
    {
        all.push_back(static_cast<double>(numbers.size()));
        all.insert(all.end(), numbers.begin(), numbers.end());
    }

    template <class T, int N>
    void add(const cv::Vec<T, N>& v)
    {
        all.insert(all.end(), v.val, v.val + N);
    }

    void add(const cv::Mat& m)
    {
        all.insert(all.end(), {static_cast<double>(m.rows), static_cast<double>(m.cols), static_cast<double>(m.type()),
                               static_cast<double>(reinterpret_cast<size_t>(m.data))});
        if (!m.empty())
            all.push_back(cv::norm(m, cv::NORM_L1));
    }

    void add(const Result& r)
    {
        for (const cv::Mat* m : {&r.poseCovariance, &r.poseCovarianceRt, &r.cameraCenterCovariance, &r.objectNoise,
                                 &r.bearingNoise, &r.objectNoiseStdErr, &r.bearingNoiseStdErr, &r.weights})
            add(*m);
        for (const cv::Vec3d& v : {r.rvec, r.tvec, r.cameraCenter})
            add(v);
        for (const int number : {r.status, r.rounds, r.objectNoiseRank, r.noiseModel, r.usedPoints})
            all.push_back(number);
        all.insert(all.end(), {r.cost, r.noiseEvidence, r.poseEvidence, r.tailShare, r.tailDof});
    }

    template <class Element>
    void addEach(const std::vector<Element>& elements)
    {
        all.push_back(static_cast<double>(elements.size()));
        for (const Element& element : elements)
            add(element);
    }
};

std::vector<double> contents(const Outputs& out)
{
    Contents contents;
    for (const cv::Mat* m : {&out.rvec, &out.tvec, &out.tvecWrong, &out.rvecRow, &out.tvecRow, &out.inliers, &out.rays,
                             &out.valid, &out.jacobian, &out.image})
        contents.add(*m);
    for (const cv::Vec3d& v : {out.rvecFixed, out.tvecFixed, out.rvecNear, out.tvecNear})
        contents.add(v);
    contents.add(out.rvecVector);
    contents.add(out.errors);
    contents.add(out.validVector);
    contents.addEach(out.rvecs);
    contents.addEach(out.tvecs);
    contents.addEach(out.raysVector);
    contents.add(out.result);
    contents.addEach(out.results);
    return contents.all;
}

// What became of one call with one fault.
struct Outcome
{
    bool failed;  // false: the call came to its end before that allocation
    bool threw, threwOther;
    long liveBefore;

    long lost() const { return live() - liveBefore; }  // blocks
};

template <class Run>
Outcome withFault(const Run& run, long number, bool onwards)
{
    Outcome outcome{};
    outcome.liveBefore = live();
    failAfter(number, onwards);
    try {
        run();
    } catch (const std::exception&) {
        outcome.threw = true;
    } catch (...) {
        outcome.threwOther = true;
    }
    outcome.failed = failed();
    failAfter(0);
    return outcome;
}

// OpenCV loses blocks of its own: cv::Mat::create() the pixels where their header cannot be allocated after them, and
// the matrices of cv::projectPoints() their headers before the pixels. The sizes of the allocations whose failure loses
// one, found by the same means.
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
                const Failure first = failures().front();
                EXPECT_EQ(outcome.lost(), first.keptBlock);
                if (first.keptBlock)
                    sizes.insert(first.size);
            }
    }
    return sizes;
}

// What a thread sets up for its first exceptions stays with it: every thread of the pool throws its own beforehand.
void throwOnEachThread()
{
    const int all = cv::getNumberOfCPUs();
    cv::setNumThreads(all);
    std::atomic<int> came{0};
    const auto throwOnce = [&](const cv::Range&) {
        ++came;
        for (int wait = 0; wait < 1000 && came < all; ++wait)  // or one thread would do the work of several
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        EXPECT_THROW(CV_Error(cv::Error::StsNoMem, "of none"), cv::Exception);
        EXPECT_THROW(throw std::bad_alloc(), std::bad_alloc);
    };
    cv::parallel_for_(cv::Range(0, all), throwOnce, all);
}

// Other threads may still hold what belongs to a call for a moment after it.
void awaitLosses(const Outcome& outcome, long expected)
{
    for (int wait = 0; wait < 1000 && outcome.lost() > expected; ++wait)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

}  // namespace

void Faults::SetUp()
{
    if (!counted())
        GTEST_SKIP() << "allocations cannot fail under a sanitizer or without glibc";
    throwOnEachThread();
    cv::setNumThreads(1);
    scene = flatScene();
    theirSizes = lossesOfOpenCV(scene);
}

// Of a loss by OpenCV the lost block is the one before the failure, since it belongs to the same array. One of ours
// would be taken for it only where ours was allocated last before an array whose first allocation has such a size.
long Faults::lossesOfTheirs() const
{
    const std::vector<Failure> all = failures();
    return std::count_if(all.begin(), all.end(), [this](const Failure& failure) {
        return failure.keptBlock && theirSizes.count(failure.size) > 0;
    });
}

bool Faults::failsCleanly(const Call& call, long number, bool onwards) const
{
    Outputs outputs;
    const std::vector<double> before = contents(outputs);
    const Outcome outcome = withFault([&] { call(scene, outputs); }, number, onwards);
    if (!outcome.failed)
        return false;
    EXPECT_TRUE(outcome.threw) << (outcome.threwOther ? "not a std::exception" : "it went on without");
    const long theirs = lossesOfTheirs();
    awaitLosses(outcome, theirs);
    EXPECT_EQ(theirs, outcome.lost()) << "blocks lost after one of " << failures().front().size << " bytes failed";
    EXPECT_TRUE(before == contents(outputs)) << "outputs touched";
    return true;
}

void Faults::expectClean(const Call& call) const
{
    for (int k = 0; k < 2; ++k) {  // whatever a first call sets up
        Outputs outputs;
        call(scene, outputs);
    }
    for (const bool onwards : {false, true}) {
        long number = 1;
        while (failsCleanly(call, number, onwards) && !HasFailure())
            ++number;
        EXPECT_GT(number, 1) << "no allocation failed";
        EXPECT_FALSE(HasFailure()) << "allocation " << number << (onwards ? " and all that follow" : "");
    }
}

}  // namespace allocation
