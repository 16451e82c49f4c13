// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "experiments.hpp"

// Whether the noise that comes out is the noise that went in: entry by entry, Sigma and Gamma one by one where the
// depths tell them apart, their sum where they do not; and how the errors fall with the number of points.

namespace experiments {

namespace {

using cv::gmlpnp::Result;

constexpr double HALF_FIELD = 45;  // degrees, to either side and up and down

// Depths log-uniform; the deviations of the two noises [m, at mean depth].
struct View
{
    std::string name;
    double nearest, farthest, object, bearing;

    double depth() const { return std::sqrt(nearest * farthest); }
    // Both with three different deviations; Gamma not along the axes of the camera.
    Matrix3d Sigma() const { return object * object * Vector3d(1, 0.25, 0.0625).asDiagonal().toDenseMatrix(); }
    Matrix3d Gamma() const
    {
        Matrix3d shape;
        shape << 1, 0.3, 0, 0.3, 0.5, 0, 0, 0, 0.5;
        return bearing * bearing / (depth() * depth()) * shape;
    }
};

void addTo(cv::Mat_<double>& rows, int i, const Vector3d& v)
{
    Eigen::Map<Vector3d>(rows.ptr<double>(i)) += v;
}

Scene drawn(cv::RNG& rng, const View& view, int n)
{
    const double slope = std::tan(HALF_FIELD * CV_PI / 180);
    std::vector<Vector3d> points(n);
    for (Vector3d& X : points) {
        const double depth = std::exp(rng.uniform(std::log(view.nearest), std::log(view.farthest)));
        const double x = rng.uniform(-slope, slope), y = rng.uniform(-slope, slope);
        X = depth * Vector3d(x, y, 1);
    }
    Scene scene = synthetic::exactScene(rng, points);
    const Matrix3d Sigma = view.Sigma(), Gamma = view.Gamma();
    const Matrix3d ofObject = cv::gmlpnp::detail::Eigen3d(Sigma).operatorSqrt();
    const Matrix3d ofBearing = cv::gmlpnp::detail::Eigen3d(Gamma).operatorSqrt();
    for (int i = 0; i < n; ++i) {
        addTo(scene.objectPoints, i, ofObject * synthetic::gaussian3(rng));
        addTo(scene.rays, i, ofBearing * synthetic::gaussian3(rng));  // solveRays() normalises
    }
    return scene;
}

// Of one problem; not a number: no pose.
struct Recovered
{
    std::array<Matrix3d, 2> error, standardError;  // Sigma and Gamma, of the largest true variance
    double sum;  // of both across the viewing direction at mean depth, over the true one
    bool both;   // whether the result says that there are both
};

double across(const Matrix3d& C)
{
    return C(0, 0) + C(1, 1);
}

Recovered recovered(const Scene& scene, const View& view)
{
    Result result;
    cv::gmlpnp::Params params;
    params.robust = false;
    if (!cv::gmlpnp::solveRays(scene.objectPoints, scene.rays, result, params))
        throw std::runtime_error("recovery: a problem without a pose");
    const Matrix3d Sigma = matrixOf(result.objectNoise), Gamma = matrixOf(result.bearingNoise);
    const double unit[2] = {view.object * view.object, std::pow(view.bearing / view.depth(), 2)};
    const double depth2 = view.depth() * view.depth();
    const Matrix3d &R = scene.truth.R, estimated = poseOf(result).R;
    Recovered out;
    out.error[0] = (Sigma - view.Sigma()) / unit[0];
    out.error[1] = (Gamma - view.Gamma()) / unit[1];
    out.standardError[0] = matrixOf(result.objectNoiseStdErr) / unit[0];
    out.standardError[1] = matrixOf(result.bearingNoiseStdErr) / unit[1];
    out.sum = across(estimated * Sigma * estimated.transpose() + depth2 * Gamma) /
              across(R * view.Sigma() * R.transpose() + depth2 * view.Gamma());
    out.both = result.noiseModel == cv::gmlpnp::NOISE_BOTH;
    return out;
}

std::vector<Recovered> recoveredAll(const View& view, int n, int cell, int trials, const Settings& settings,
                                    Progress& progress)
{
    std::vector<Recovered> all(trials);
    forTrials(trials, settings.threads, progress, [&](int k) {
        cv::RNG rng = trialRng("recovery", cell, k);
        all[k] = recovered(drawn(rng, view, n), view);
    });
    return all;
}

const char* const NOISES[] = {"object", "bearing"};
const char* const ENTRIES[] = {"xx", "xy", "xz", "yy", "yz", "zz"};

void writeEntries(Csv& csv, const View& view, int n, const std::vector<Recovered>& all)
{
    const int trials = static_cast<int>(all.size());
    const Bootstrap bootstrap(trials);
    for (const bool chosen : {false, true})  // of all problems; of those where both noises were found
        for (int noise = 0; noise < 2; ++noise)
            for (int a = 0, entry = 0; a < 3; ++a)
                for (int b = a; b < 3; ++b, ++entry) {
                    constexpr double NONE = std::numeric_limits<double>::quiet_NaN();
                    std::vector<double> errors, deviations, squares;
                    for (const Recovered& one : all) {
                        const bool counts = !chosen || one.both;
                        const double error = one.error[noise](a, b), deviation = one.standardError[noise](a, b);
                        errors.push_back(counts ? error : NONE);
                        deviations.push_back(counts ? deviation : NONE);
                        squares.push_back(counts ? error * error / (deviation * deviation) : NONE);
                    }
                    csv << view.name << n << (chosen ? "both found" : "all") << NOISES[noise] << ENTRIES[entry]
                        << countNumbers(errors) << bootstrap.mean(errors) << median(deviations)
                        << bootstrap.mean(squares);
                    csv.endRow();
                }
}

void writeSum(Csv& csv, const View& view, int n, const std::vector<Recovered>& all)
{
    std::vector<double> sums, frobenius[2];
    for (const Recovered& one : all) {
        sums.push_back(one.sum);
        frobenius[0].push_back(one.error[0].norm() / (view.Sigma() / (view.object * view.object)).norm());
        frobenius[1].push_back(one.error[1].norm() / (view.Gamma() / view.Gamma()(0, 0)).norm());
    }
    const Bootstrap bootstrap(static_cast<int>(all.size()));
    csv << view.name << n << static_cast<int>(all.size()) << bootstrap.mean(sums) << bootstrap.mean(frobenius[0])
        << bootstrap.mean(frobenius[1]);
    csv.endRow();
}

}  // namespace

void runRecovery(const Settings& settings)
{
    const View views[] = {{"depths 4-16 m", 4, 16, 0.1, 0.1},
                          {"depths 3-60 m", 3, 60, 0.1, 0.1},
                          {"depths 5.9-6.1 m", 5.9, 6.1, 0.1, 0.1}};
    const int sizes[] = {50, 200, 1000, 10000};
    const auto trialsOf = [&](int n) { return std::max(2, std::min(settings.trials, settings.trials * 500 / n)); };
    long total = 0;
    for (const int n : sizes)
        total += static_cast<long>(std::size(views)) * trialsOf(n);
    Progress progress("recovery", total);
    Csv entries(settings.folder, "recovery",
                std::vector<std::string>{"view", "x", "problems", "noise", "entry", "trials"} +
                    intervalColumns("error") + std::vector<std::string>{"standard_error_median"} +
                    intervalColumns("squared_score"));
    Csv sums(settings.folder, "recovery_sums",
             std::vector<std::string>{"view", "x", "trials"} + intervalColumns("sum") + intervalColumns("object") +
                 intervalColumns("bearing"));
    int cell = 0;
    for (const View& view : views)
        for (const int n : sizes) {
            const std::vector<Recovered> all = recoveredAll(view, n, cell++, trialsOf(n), settings, progress);
            if (n <= 200)
                writeEntries(entries, view, n, all);
            writeSum(sums, view, n, all);
        }
    entries.save();
    sums.save();
}

}  // namespace experiments
