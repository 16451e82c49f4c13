// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "experiments.hpp"

// Whether the pose covariance keeps its promise: the share of problems whose truth is in the 95 % ellipsoid.

namespace experiments {

namespace {

using cv::gmlpnp::Params;
using cv::gmlpnp::Result;
using cv::gmlpnp::detail::difference;
using cv::gmlpnp::detail::Matrix6d;
using cv::gmlpnp::detail::Vector6d;

using synthetic::CHI2_6_95;

struct Noises
{
    std::string name;
    double sigma, px;
};

// Squared Mahalanobis distance of the truth, six degrees of freedom; not a number without a covariance.
double squaredDistance(const Problem& problem, const Params& params)
{
    const std::optional<Result> result = solved(problem, params);
    if (!result || result->poseCovariance.empty())
        return std::numeric_limits<double>::quiet_NaN();
    const Vector6d xi = difference(problem.scene.truth, poseOf(*result));
    const Matrix6d C = Eigen::Map<const Matrix6d>(result->poseCovariance.ptr<double>());
    return xi.dot(C.ldlt().solve(xi));
}

struct Label
{
    std::string noise;
    double field;
    int n;
    std::string solver;
};

// P(chi^2 < x) of six degrees of freedom.
double chi2Of6(double x)
{
    const double h = x / 2;
    return 1 - std::exp(-h) * (1 + h + h * h / 2);
}

// Squared distances (NEES) in classes of one, the last without an end.
void writeHistogram(Csv& csv, const Label& label, const std::vector<double>& distances)
{
    constexpr int CLASSES = 24;
    std::vector<int> counts(CLASSES, 0);
    for (const double d : distances)
        if (!std::isnan(d))
            ++counts[static_cast<size_t>(std::min(d, CLASSES - 1.))];
    const double total = std::max(1, countNumbers(distances));
    for (int k = 0; k < CLASSES; ++k) {
        const double end = k + 1 < CLASSES ? chi2Of6(k + 1) : 1;
        csv << label.noise << label.field << label.n << label.solver << k << k + 1 << counts[k] / total
            << end - chi2Of6(k);
        csv.endRow();
    }
}

}  // namespace

void runCoverage(const Settings& settings)
{
    const Noises noises[] = {{"object", 0.1, 0}, {"pixels", 0, 1}, {"both", 0.05, 1}};
    const double fields[] = {15, 60};
    const int sizes[] = {8, 15, 20, 50, 100, 200};
    const char* const names[] = {"GMLPnP", "GMLPnP marginal", "GMLPnP*"};
    const int trials = settings.trials;
    Progress progress("coverage", static_cast<long>(std::size(noises) * std::size(fields) * std::size(sizes)) * trials);
    Csv csv(settings.folder, "coverage",
            std::vector<std::string>{"noise", "half_field_deg", "x", "solver", "trials"} + intervalColumns("coverage") +
                std::vector<std::string>{"squared_distance_median"});
    Csv histogram(settings.folder, "coverage_nees",
                  {"noise", "half_field_deg", "x", "solver", "from", "to", "share", "expected"});
    int cell = 0;
    for (const Noises& noise : noises)
        for (const double field : fields)
            for (const int n : sizes) {
                std::vector<std::vector<double>> distances(std::size(names), std::vector<double>(trials));
                forTrials(trials, settings.threads, progress, [&](int k) {
                    cv::RNG rng = trialRng("coverage", cell, k);
                    const Problem problem = coneProblem(n, field, noise.sigma, noise.px)(rng);
                    Params published;
                    published.method = cv::gmlpnp::SOLVEPNP_GMLPNP;
                    distances[0][k] = squaredDistance(problem, published);
                    distances[1][k] = squaredDistance(problem, Params());
                    distances[2][k] = squaredDistance(problem, trueNoise(problem));
                });
                for (size_t s = 0; s < std::size(names); ++s) {
                    const int counted = countNumbers(distances[s]);
                    const auto hits = std::count_if(distances[s].begin(), distances[s].end(),
                                                    [](double d) { return d <= CHI2_6_95; });
                    csv << noise.name << field << n << names[s] << counted
                        << share(static_cast<int>(hits), std::max(counted, 1)) << median(distances[s]);
                    csv.endRow();
                    writeHistogram(histogram, {noise.name, field, n, names[s]}, distances[s]);
                }
                ++cell;
            }
    csv.save();
    histogram.save();
}

}  // namespace experiments
