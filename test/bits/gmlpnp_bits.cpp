// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

// Prints hashes of everything that thousands of whole calls return. Two builds of the module compute the same exactly
// when they print the same; a line a group of calls tells where they differ. It uses the public API alone, so that it
// compiles against any revision of it (scripts/bits.sh).

#include <opencv2/gmlpnp.hpp>

#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

namespace {

using namespace cv;
namespace pnp = cv::gmlpnp;

/** FNV-1a over the bit patterns of numbers. */
class Hash
{
public:
    void add(double value)
    {
        unsigned char bytes[sizeof value];
        std::memcpy(bytes, &value, sizeof value);
        for (const unsigned char byte : bytes)
            state_ = (state_ ^ byte) * 0x100000001B3u;
    }
    void add(const Vec3d& v)
    {
        for (int k = 0; k < 3; ++k)
            add(v[k]);
    }
    void add(const Mat& m)
    {
        add(static_cast<double>(m.total()));
        for (int i = 0; i < m.rows; ++i)
            for (int j = 0; j < m.cols; ++j)
                add(m.depth() == CV_32S ? m.at<int>(i, j) : m.at<double>(i, j));
    }
    void add(const pnp::Result& r)
    {
        for (const double number :
             {double(r.status), double(r.rounds), r.cost, double(r.objectNoiseRank), double(r.noiseModel),
              r.noiseEvidence, r.poseEvidence, r.tailShare, r.tailDof, double(r.usedPoints)})
            add(number);
        for (const Vec3d& v : {r.rvec, r.tvec, r.cameraCenter})
            add(v);
        for (const Mat& m : {r.poseCovariance, r.poseCovarianceRt, r.cameraCenterCovariance, r.objectNoise,
                             r.bearingNoise, r.objectNoiseStdErr, r.bearingNoiseStdErr, r.weights})
            add(m);
    }
    uint64_t value() const { return state_; }

private:
    uint64_t state_ = 0xCBF29CE484222325u;
};

/** SplitMix64: the same numbers with every compiler. */
class Random
{
public:
    explicit Random(uint64_t seed) : state_(seed) {}

    double uniform(double low, double high)
    {
        state_ += 0x9E3779B97F4A7C15u;
        uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
        z ^= z >> 31;
        return low + (high - low) * (static_cast<double>(z >> 11) * 0x1.0p-53);
    }
    double gaussian(double deviation)
    {
        const double radius = std::sqrt(-2 * std::log(1 - uniform(0, 1)));
        return deviation * radius * std::cos(uniform(0, 2 * CV_PI));
    }
    Vec3d inBox(double size)
    {
        const double x = uniform(-size, size), y = uniform(-size, size);
        return {x, y, uniform(-size, size)};
    }

private:
    uint64_t state_;
};

struct Lens
{
    const char* name;
    Ptr<pnp::CameraModel> camera;
    double field;  //!< largest angle from the axis at which points are placed, rad
};

std::vector<Lens> lenses()
{
    const Matx33d K(800, 0, 640, 0, 790, 480, 0, 0, 1), wide(300, 0, 640, 0, 300, 480, 0, 0, 1);
    return {{"pinhole", pnp::CameraModel::pinhole(K), 0.6},
            {"distorted", pnp::CameraModel::pinhole(K, Vec<double, 5>(-.2, .05, .001, -.001, -.004)), 0.5},
            {"fisheye", pnp::CameraModel::fisheye(wide, Vec4d(.02, -.005, .001, -.0002)), 1.6},
            {"omnidir", pnp::CameraModel::omnidir(wide, Vec4d(-.05, .01, .0005, .0003), 1.2), 1.5},
            {"eucm", pnp::CameraModel::eucm(wide, .6, 1.1), 1.4},
            {"double_sphere", pnp::CameraModel::doubleSphere(wide, -.2, .6), 1.4},
            {"equirectangular", pnp::CameraModel::equirectangular({2000, 1000}), 3}};
}

/** What disturbs the data of a problem. */
struct Disturbance
{
    double object = 0, pixel = 0;  //!< deviations; the object's is three times as large along z
    double wild = 0;               //!< share of pixels with ten times the deviation
    double wrong = 0;              //!< share of pixels that are anywhere
    bool flat = false;             //!< whether the object has no depth
};

struct Problem
{
    std::vector<Point3d> points;
    std::vector<Point2d> pixels;
    Matx33d R;
    Vec3d rvec, tvec;
};

Vec3d directionWithin(Random& random, double field)
{
    const double theta = field * std::sqrt(random.uniform(0, 1)), phi = random.uniform(0, 2 * CV_PI);
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

Point2d disturbed(Random& random, const Point2d& pixel, const Disturbance& by)
{
    if (random.uniform(0, 1) < by.wrong) {
        const double u = random.uniform(100, 1100);
        return {u, random.uniform(100, 860)};
    }
    const double deviation = by.pixel * (random.uniform(0, 1) < by.wild ? 10 : 1);
    const double du = random.gaussian(deviation);
    return {pixel.x + du, pixel.y + random.gaussian(deviation)};
}

// Points wherever the lens looks, at depths of 4 to 12; or a square in front of it.
Problem problemOf(Random& random, const Lens& lens, int n, const Disturbance& by)
{
    Problem problem;
    problem.rvec = random.inBox(1.5);
    problem.tvec = random.inBox(2) + Vec3d(0, 0, by.flat ? 9 : 0);
    Rodrigues(problem.rvec, problem.R);
    while (static_cast<int>(problem.points.size()) < n) {
        Vec3d p, X;
        if (by.flat) {
            p = random.inBox(2.5);
            p[2] = 0;
            X = problem.R * p + problem.tvec;
        } else {
            X = random.uniform(4, 12) * directionWithin(random, lens.field);
            p = problem.R.t() * (X - problem.tvec);
        }
        Point2d pixel;
        Vec3d ray;
        if (!lens.camera->projectPoint(X, pixel))
            continue;
        pixel = disturbed(random, pixel, by);
        if (!lens.camera->unprojectPoint(pixel, ray))
            continue;
        const double dx = random.gaussian(by.object), dy = random.gaussian(by.object);
        problem.points.emplace_back(p[0] + dx, p[1] + dy, p[2] + random.gaussian(3 * by.object));
        problem.pixels.push_back(pixel);
    }
    return problem;
}

const std::vector<Disturbance>& disturbances()
{
    static const std::vector<Disturbance> all = {{0, 0, 0, 0, false},   {0, 1, 0, 0, false},     {.05, 1, 0, 0, false},
                                                 {.1, .2, 0, 0, false}, {.02, .5, .1, 0, false}, {0, 1, 0, .1, false},
                                                 {0, 1, 0, 0, true},    {.02, 1, .1, 0, true}};
    return all;
}

const std::vector<int>& sizes()
{
    static const std::vector<int> all = {4,   5,   6,   7,   8,   10,  14,   20,   35,   60,
                                         100, 199, 200, 400, 599, 600, 1000, 2500, 10000};
    return all;
}

// More of the small problems, which have more to decide.
int repetitions(int n)
{
    return n <= 20 ? 6 : n <= 200 ? 3 : 1;
}

using Call = std::function<void(const Problem&, const Lens&, Random&, Hash&)>;

class Printer
{
public:
    void group(const std::string& name, const Lens& lens, const Call& call, int smallest = 4, int largest = 10000)
    {
        Hash hash;
        int calls = 0;
        uint64_t seed = 1;
        for (const int n : sizes())
            for (size_t kind = 0; kind < disturbances().size(); ++kind)
                for (int k = 0; n >= smallest && n <= largest && k < repetitions(n); ++k, ++calls) {
                    Random random(++seed * 1000003);
                    call(problemOf(random, lens, n, disturbances()[kind]), lens, random, hash);
                }
        print(name + " " + lens.name, calls, hash);
    }
    void print(const std::string& name, int calls, const Hash& hash)
    {
        std::printf("%016" PRIx64 " %5d %s\n", hash.value(), calls, name.c_str());
        total_.add(static_cast<double>(hash.value() >> 32));
        total_.add(static_cast<double>(hash.value() & 0xFFFFFFFFu));
        calls_ += calls;
    }
    void end() const { std::printf("%016" PRIx64 " %5d all calls\n", total_.value(), calls_); }

private:
    Hash total_;
    int calls_ = 0;
};

Call solveWith(const std::function<void(const Problem&, Random&, pnp::Params&)>& change)
{
    return [change](const Problem& problem, const Lens& lens, Random& random, Hash& hash) {
        pnp::Params params;
        change(problem, random, params);
        pnp::Result result;
        hash.add(double(pnp::solve(problem.points, problem.pixels, lens.camera, result, params)));
        hash.add(result);
    };
}

void useGuess(const Problem& problem, Random& random, pnp::Params& params)
{
    params.useExtrinsicGuess = true;
    params.rvec = problem.rvec + random.inBox(0.1);
    params.tvec = problem.tvec + random.inBox(0.3);
}

void printSolves(Printer& printer, const Lens& lens)
{
    const auto noChange = [](const Problem&, Random&, pnp::Params&) {};
    printer.group("solve", lens, solveWith(noChange));
    printer.group("solve published", lens,
                  solveWith([](const Problem&, Random&, pnp::Params& p) { p.method = pnp::SOLVEPNP_GMLPNP; }), 4, 1000);
    printer.group("solve with guess", lens, solveWith(useGuess), 4, 1000);
    printer.group("solve without tails", lens,
                  solveWith([](const Problem&, Random&, pnp::Params& p) { p.robust = false; }), 4, 1000);
    printer.group("solve, both noises known", lens, solveWith([](const Problem&, Random&, pnp::Params& p) {
                      p.objectNoise = Mat(Matx33d::diag({.0025, .0025, .02}));
                      p.bearingNoise = Mat(Matx33d(Matx33d::eye() * 1e-6));
                  }),
                  4, 1000);
    printer.group("solve, object noise known", lens, solveWith([](const Problem&, Random&, pnp::Params& p) {
                      p.objectNoise = Mat(Matx33d::diag({.0025, .0025, .02}));
                  }),
                  4, 1000);
    printer.group("solve, covariances known", lens, solveWith([](const Problem& of, Random&, pnp::Params& p) {
                      Mat covariances(static_cast<int>(of.points.size()), 9, CV_64F, Scalar(0));
                      for (int i = 0; i < covariances.rows; ++i)
                          for (int k = 0; k < 9; k += 4)
                              covariances.at<double>(i, k) = 1e-4 * (1 + i % 5);
                      p.objectCovariances = covariances;
                      p.pixelCovariances = Mat(covariances.rows, 1, CV_64F, Scalar(.5));
                  }),
                  4, 1000);
    printer.group("solve, two rounds", lens,
                  solveWith([](const Problem&, Random&, pnp::Params& p) { p.maxRounds = 2; }), 4, 400);
}

void printPoses(Printer& printer, const Lens& lens)
{
    printer.group(
        "solveAll", lens,
        [](const Problem& problem, const Lens& of, Random&, Hash& hash) {
            std::vector<pnp::Result> results;
            hash.add(pnp::solveAll(problem.points, problem.pixels, of.camera, results));
            for (const pnp::Result& result : results)
                hash.add(result);
        },
        4, 1000);
    printer.group("solveRansac", lens, [](const Problem& problem, const Lens& of, Random&, Hash& hash) {
        pnp::Result result;
        std::vector<int> inliers;
        hash.add(double(pnp::solveRansac(problem.points, problem.pixels, of.camera, result, inliers)));
        hash.add(result);
        hash.add(Mat(inliers));
    });
}

Call solvePnPWith(int flags, bool useGuess)
{
    return [=](const Problem& problem, const Lens&, Random& random, Hash& hash) {
        Vec3d rvec, tvec;
        if (useGuess) {
            rvec = problem.rvec + random.inBox(.1);
            tvec = problem.tvec + random.inBox(.3);
        }
        hash.add(double(pnp::solvePnP(problem.points, problem.pixels, Matx33d(800, 0, 640, 0, 790, 480, 0, 0, 1),
                                      noArray(), rvec, tvec, useGuess, flags)));
        hash.add(rvec);
        hash.add(tvec);
    };
}

// OpenCV's names take a pinhole camera.
void printDropIns(Printer& printer, const Lens& pinhole)
{
    const Matx33d K(800, 0, 640, 0, 790, 480, 0, 0, 1);
    printer.group("solvePnP", pinhole, solvePnPWith(pnp::SOLVEPNP_GMLPNP_MARGINAL, false));
    printer.group("solvePnP published", pinhole, solvePnPWith(pnp::SOLVEPNP_GMLPNP, false));
    printer.group("solvePnP with guess", pinhole, solvePnPWith(pnp::SOLVEPNP_GMLPNP_MARGINAL, true));
    printer.group("solvePnPRefine", pinhole, [&](const Problem& problem, const Lens&, Random& random, Hash& hash) {
        Vec3d rvec = problem.rvec + random.inBox(.1), tvec = problem.tvec + random.inBox(.3);
        pnp::solvePnPRefine(problem.points, problem.pixels, K, noArray(), rvec, tvec);
        hash.add(rvec);
        hash.add(tvec);
    });
    printer.group(
        "solvePnPGeneric", pinhole,
        [&](const Problem& problem, const Lens&, Random&, Hash& hash) {
            std::vector<Mat> rvecs, tvecs;
            Mat errors;
            hash.add(pnp::solvePnPGeneric(problem.points, problem.pixels, K, noArray(), rvecs, tvecs, false,
                                          pnp::SOLVEPNP_GMLPNP_MARGINAL, noArray(), noArray(), errors));
            for (size_t k = 0; k < rvecs.size(); ++k) {
                hash.add(rvecs[k]);
                hash.add(tvecs[k]);
            }
            hash.add(errors);
        },
        4, 1000);
    printer.group("solvePnPRansac", pinhole, [&](const Problem& problem, const Lens&, Random&, Hash& hash) {
        Vec3d rvec, tvec;
        std::vector<int> inliers;
        hash.add(double(pnp::solvePnPRansac(problem.points, problem.pixels, K, noArray(), rvec, tvec, false, 1000, 6,
                                            .99, inliers, pnp::SOLVEPNP_GMLPNP_MARGINAL)));
        hash.add(rvec);
        hash.add(tvec);
        hash.add(Mat(inliers));
    });
}

void printBatch(Printer& printer, const Lens& lens)
{
    std::vector<Mat> points, rays;
    uint64_t seed = 1;
    for (const int n : {4, 6, 10, 30, 100, 700})
        for (const Disturbance& disturbance : disturbances()) {
            Random random(++seed * 7919);
            const Problem problem = problemOf(random, lens, n, disturbance);
            Mat directions;
            lens.camera->unproject(problem.pixels, directions);
            points.push_back(Mat(problem.points, true));
            rays.push_back(directions);
        }
    std::vector<pnp::Result> results;
    Hash hash;
    hash.add(pnp::solveBatch(points, rays, results));
    for (const pnp::Result& result : results)
        hash.add(result);
    printer.print(std::string("solveBatch ") + lens.name, static_cast<int>(points.size()), hash);
}

}  // namespace

int main()
{
    Printer printer;
    const std::vector<Lens> all = lenses();
    for (const Lens& lens : all) {
        printSolves(printer, lens);
        printPoses(printer, lens);
        printBatch(printer, lens);
    }
    printDropIns(printer, all.front());
    printer.end();
}
