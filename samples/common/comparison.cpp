// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

#include "common/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "common/output_file.hpp"
#include "common/statistics.hpp"
#include "common/table.hpp"

namespace samples {

namespace {

constexpr size_t kQuantitiesPerTable = 3;

const Outcome* solvedOutcome(const Trial& trial, size_t method)
{
    if (method >= trial.outcomes.size() || !trial.outcomes[method].estimate.solved)
        return nullptr;
    return &trial.outcomes[method];
}

size_t solvedPairs(const Comparison& comparison, size_t method)
{
    size_t count = 0;
    for (const Trial& trial : comparison.trials)
        count += solvedOutcome(trial, method) != nullptr ? 1 : 0;
    return count;
}

std::string titleOf(const Quantity& quantity)
{
    return quantity.name + " [" + quantity.unit + "]";
}

std::string withInterval(double value, const Interval& interval, int decimals, const char* format)
{
    if (std::isnan(value))
        return "-";
    if (std::isnan(interval.low))
        return cv::format(format, decimals, value);
    return cv::format(format, decimals, value) + " [" + cv::format(format, decimals, interval.low) + ", " +
           cv::format(format, decimals, interval.high) + "]";
}

double medianMicroseconds(const Comparison& comparison, size_t method)
{
    std::vector<double> times;
    for (const Trial& trial : comparison.trials)
        if (const Outcome* outcome = solvedOutcome(trial, method))
            times.push_back(outcome->estimate.microseconds);
    return median(times);
}

void printErrorTable(std::ostream& out, const Comparison& comparison, size_t first, size_t last, uint64_t seed)
{
    std::vector<std::string> title = {"method", "solved", "failed"};
    for (size_t q = first; q < last; ++q) {
        title.push_back(titleOf(comparison.quantities[q]) + " mean [95 %]");
        title.emplace_back("median");
    }
    title.emplace_back("time [us]");
    Table table(title);
    for (size_t m = 0; m < comparison.methods.size(); ++m) {
        const size_t solved = solvedPairs(comparison, m);
        std::vector<std::string> row = {comparison.methods[m].name, std::to_string(solved),
                                        std::to_string(comparison.trials.size() - solved)};
        for (size_t q = first; q < last && solved > 0; ++q) {
            const std::vector<double> errors = absoluteErrors(comparison, m, q);
            const int decimals = comparison.quantities[q].decimals;
            row.push_back(withInterval(mean(errors), bootstrapMean(errors, seed), decimals, "%.*f"));
            row.push_back(fixed(median(errors), decimals));
        }
        if (solved > 0)
            row.push_back(fixed(medianMicroseconds(comparison, m), 0));
        table.add(row);
    }
    table.printMarkdown(out);
}

//! Absolute errors of two methods in the pairs that both solved.
struct PairedErrors
{
    std::vector<double> differences, others;
};

PairedErrors pairedErrors(const Comparison& comparison, size_t own, size_t other, size_t quantity)
{
    PairedErrors paired;
    for (const Trial& trial : comparison.trials) {
        const Outcome *a = solvedOutcome(trial, own), *b = solvedOutcome(trial, other);
        if (a == nullptr || b == nullptr)
            continue;
        paired.others.push_back(std::abs(b->errors[quantity]));
        paired.differences.push_back(std::abs(a->errors[quantity]) - paired.others.back());
    }
    return paired;
}

void printDifferenceTable(std::ostream& out, const Comparison& comparison, size_t own, size_t first, size_t last,
                          uint64_t seed)
{
    std::vector<std::string> title = {comparison.methods[own].name + " minus", "pairs"};
    for (size_t q = first; q < last; ++q) {
        title.push_back(titleOf(comparison.quantities[q]) + " [95 %]");
        title.emplace_back("%");
    }
    Table table(title);
    for (size_t m = 0; m < comparison.methods.size(); ++m) {
        if (m == own)
            continue;
        const size_t pairs = pairedErrors(comparison, own, m, first).differences.size();
        std::vector<std::string> row = {comparison.methods[m].name, std::to_string(pairs)};
        for (size_t q = first; q < last && pairs > 0; ++q) {
            const PairedErrors paired = pairedErrors(comparison, own, m, q);
            const double difference = mean(paired.differences);
            row.push_back(withInterval(difference, bootstrapMean(paired.differences, seed),
                                       comparison.quantities[q].decimals + 1, "%+.*f"));
            row.push_back(cv::format("%+.1f", 100.0 * difference / mean(paired.others)));
        }
        table.add(row);
    }
    table.printMarkdown(out);
}

//! Calls `print(first, last)` for the quantities of each table.
template <typename Print>
void forEachTable(const Comparison& comparison, Print print)
{
    const size_t count = comparison.quantities.size();
    size_t first = 0;
    do
        print(first, std::min(count, first + kQuantitiesPerTable));
    while ((first += kQuantitiesPerTable) < count);
}

}  // namespace

std::vector<double> absoluteErrors(const Comparison& comparison, size_t method, size_t quantity)
{
    std::vector<double> errors;
    for (const Trial& trial : comparison.trials)
        if (const Outcome* outcome = solvedOutcome(trial, method))
            errors.push_back(std::abs(outcome->errors[quantity]));
    return errors;
}

void printErrors(std::ostream& out, const Comparison& comparison, uint64_t seed)
{
    forEachTable(comparison, [&](size_t first, size_t last) {
        printErrorTable(out, comparison, first, last, seed);
        out << "\n";
    });
}

void printDifferences(std::ostream& out, const Comparison& comparison, uint64_t seed)
{
    for (size_t own = 0; own < comparison.methods.size(); ++own) {
        if (!isOwn(comparison.methods[own]))
            continue;
        forEachTable(comparison, [&](size_t first, size_t last) {
            printDifferenceTable(out, comparison, own, first, last, seed);
            out << "\n";
        });
    }
}

void writeComparison(const std::string& path, const Comparison& comparison, const std::string& title)
{
    files::writeFile(path, [&](std::ostream& out) {
        if (!comparison.quantities.empty())
            out << "# kind errors\n# title " << title << "\n";
        out << "pair,method,points,solved,rx_rad,ry_rad,rz_rad,tx,ty,tz";
        for (const Quantity& quantity : comparison.quantities)
            out << "," << quantity.name << "_" << quantity.unit;
        out << ",time_us\n";
        const std::string nothing(7 + comparison.quantities.size(), ',');
        for (const Trial& trial : comparison.trials)
            for (size_t m = 0; m < comparison.methods.size(); ++m) {
                const Outcome* outcome = solvedOutcome(trial, m);
                out << trial.name << "," << comparison.methods[m].name << "," << trial.points << ","
                    << (outcome ? 1 : 0);
                if (outcome == nullptr) {
                    out << nothing << "\n";
                    continue;
                }
                const cv::Vec3d &r = outcome->estimate.rvec, &t = outcome->estimate.tvec;
                out << cv::format(",%.12g,%.12g,%.12g,%.12g,%.12g,%.12g", r[0], r[1], r[2], t[0], t[1], t[2]);
                for (const double error : outcome->errors)
                    out << cv::format(",%.9g", error);
                out << cv::format(",%.1f\n", outcome->estimate.microseconds);
            }
    });
}

}  // namespace samples
