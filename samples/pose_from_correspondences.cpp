// This file is part of OpenCV project.
// It is subject to the license terms in the LICENSE file found in the top-level directory
// of this distribution and at http://opencv.org/license.html

// The camera pose from files of 2D-3D correspondences, by OpenCV's solvers and this module's, with their errors and
// times; then what only this module gives: the noise of the data and the uncertainty of the pose.

#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "common/command_line.hpp"
#include "common/methods.hpp"
#include "common/noise_report.hpp"
#include "common/output_file.hpp"
#include "common/residuals.hpp"
#include "common/table.hpp"

namespace {

using namespace samples;

const char* const kKeys =
    "{help h usage ? |    | print this help}"
    "{@files         |    | correspondence files, one or more (format: samples/common/correspondences.hpp)}"
    "{method         |    | only this one: EPNP, ITERATIVE, SQPNP, GMLPNP or GMLPNP_MARGINAL}"
    "{repeat         | 21 | calls per method and file; the time is their median}"
    "{brief          |    | tables only: no noise, no uncertainty}"
    "{residuals      |    | write the residuals to this CSV file, which samples/python/draw.py draws; with several "
    "files "
    "the name gets each file's name}"
    "{csv            |    | write all poses and errors to this file}";

//! One line of a table: a method's answer to one file.
struct Run
{
    Method method;
    Estimate estimate;
    double rotationError = 0.0;  // deg
    double positionError = 0.0;  // the file's unit
};

struct FileRuns
{
    CorrespondenceSet set;
    std::vector<Run> runs;
};

std::vector<Method> chosenMethods(const std::string& name)
{
    std::vector<Method> chosen;
    for (const Method& method : allMethods())
        if (name.empty() || method.name == name)
            chosen.push_back(method);
    if (chosen.empty())
        throw std::runtime_error("--method: unknown method '" + name + "'");
    return chosen;
}

FileRuns runMethods(const std::string& path, const std::vector<Method>& methods, int repeat)
{
    FileRuns file{readCorrespondences(path), {}};
    for (const Method& method : methods) {
        Run run{method, estimatePose(file.set, method, repeat)};
        if (file.set.hasTruth && run.estimate.solved) {
            run.rotationError = rotationErrorDegrees(run.estimate.pose(), file.set.truth);
            run.positionError = positionError(run.estimate.pose(), file.set.truth);
        }
        file.runs.push_back(run);
    }
    return file;
}

void printSource(const CorrespondenceSet& set)
{
    for (const std::string& line : set.source)
        std::cout << "  " << line << "\n";
    std::cout << "\n";
}

void printRuns(const FileRuns& file)
{
    const LengthUnit unit = shownUnit(file.set.unit);
    Table table({"method", "rvec [deg]", "tvec [" + unit.name + "]", "rotation error [deg]",
                 "position error [" + unit.name + "]", "time [us]"});
    for (const Run& run : file.runs) {
        const Estimate& e = run.estimate;
        if (!e.solved) {
            table.add({run.method.name, "not solved"});
            continue;
        }
        const cv::Vec3d r = e.rvec * degrees(1.0), t = e.tvec * unit.perFileUnit;
        const bool truth = file.set.hasTruth;
        table.add({run.method.name, triple(r[0], r[1], r[2], 3, 8), triple(t[0], t[1], t[2], 3, 8),
                   truth ? fixed(run.rotationError, 4) : "-",
                   truth ? fixed(run.positionError * unit.perFileUnit, 4) : "-", fixed(e.microseconds, 0)});
    }
    table.print(std::cout);
}

//! Mean errors per method over the files with truth, all methods over the same files.
void printSummary(const std::vector<FileRuns>& files)
{
    const LengthUnit unit = shownUnit(files[0].set.unit);
    Table table(
        {"mean over the files", "files", "rotation error [deg]", "position error [" + unit.name + "]", "time [us]"});
    for (size_t m = 0; m < files[0].runs.size(); ++m) {
        int count = 0;
        double rotation = 0.0, position = 0.0, time = 0.0;
        for (const FileRuns& file : files) {
            const Run& run = file.runs[m];
            if (!file.set.hasTruth || file.set.unit != files[0].set.unit || !run.estimate.solved)
                continue;
            ++count;
            rotation += run.rotationError;
            position += run.positionError * unit.perFileUnit;
            time += run.estimate.microseconds;
        }
        if (count > 0)
            table.add({files[0].runs[m].method.name, std::to_string(count), fixed(rotation / count, 4),
                       fixed(position / count, 4), fixed(time / count, 0)});
    }
    std::cout << "\n";
    table.print(std::cout);
}

//! The method, of those asked for, that also gives noise and uncertainty: the last of this module's; null: none.
const Method* fullMethod(const std::vector<Method>& methods)
{
    return methods.back().flag >= cv::gmlpnp::SOLVEPNP_GMLPNP ? &methods.back() : nullptr;
}

//! One more solve, for everything the module knows. @throws std::runtime_error where there is no pose.
cv::gmlpnp::Result solveInFull(const CorrespondenceSet& set, const Method& method)
{
    cv::gmlpnp::Params params;
    params.method = method.flag;
    cv::gmlpnp::Result result;
    if (!cv::gmlpnp::solve(set.objectPoints, set.imagePoints, set.cameraMatrix, set.distCoeffs, result, params))
        throw std::runtime_error(set.path + ": no pose by " + method.name + ", status " +
                                 std::to_string(result.status));
    return result;
}

//! "out.csv" becomes "out_<name>.csv".
std::string withName(const std::filesystem::path& path, const std::string& name)
{
    return (path.parent_path() / path.stem()).string() + "_" + name + path.extension().string();
}

void writeCsv(const std::string& path, const std::vector<FileRuns>& files)
{
    files::writeFile(path, [&](std::ostream& out) {
        out << "file,method,points,solved,rx_rad,ry_rad,rz_rad,tx,ty,tz,rotation_error_deg,position_error,time_us\n";
        for (const FileRuns& file : files)
            for (const Run& run : file.runs) {
                const cv::Vec3d &r = run.estimate.rvec, &t = run.estimate.tvec;
                out << file.set.name() << "," << run.method.name << "," << file.set.objectPoints.size() << ","
                    << run.estimate.solved
                    << cv::format(",%.12g,%.12g,%.12g,%.12g,%.12g,%.12g", r[0], r[1], r[2], t[0], t[1], t[2])
                    << (file.set.hasTruth ? cv::format(",%.9g,%.9g", run.rotationError, run.positionError) : ",,")
                    << cv::format(",%.1f\n", run.estimate.microseconds);
            }
    });
}

void report(const FileRuns& file, const Method* method, bool brief, const std::string& residualFile)
{
    const CorrespondenceSet& set = file.set;
    std::cout << set.name() << ": " << set.objectPoints.size() << " points\n";
    if (!brief)
        printSource(set);
    printRuns(file);
    if (method == nullptr)
        return;
    const cv::gmlpnp::Result result = solveInFull(set, *method);
    const std::vector<Residual> residuals = residualsOf(set, result);
    if (!brief) {
        std::cout << "\n" << method->name << " also gives\n";
        printNoise(std::cout, result, shownUnit(set.unit), set.cameraMatrix(0, 0), meanDepth(residuals));
    }
    if (!residualFile.empty())
        writeResiduals(residualFile, set, residuals, method->name);
}

int run(const Arguments& arguments)
{
    cv::setNumThreads(1);  // the time of the calling thread is then the whole time
    const int repeat = arguments.get<int>("repeat");
    if (repeat < 1)
        throw std::runtime_error("--repeat must be positive");
    const std::vector<Method> methods = chosenMethods(arguments.get<std::string>("method"));
    const std::string residuals = arguments.get<std::string>("residuals"), csv = arguments.get<std::string>("csv");
    if (!residuals.empty() && fullMethod(methods) == nullptr)
        throw std::runtime_error("--residuals: " + methods.back().name + " estimates no noise to judge them by");
    const bool several = arguments.files.size() > 1;
    std::vector<FileRuns> files;
    for (const std::string& path : arguments.files) {
        std::cout << (files.empty() ? "" : "\n");
        files.push_back(runMethods(path, methods, repeat));
        report(files.back(), fullMethod(methods), arguments.options.has("brief"),
               several && !residuals.empty() ? withName(residuals, files.back().set.name()) : residuals);
    }
    if (several)
        printSummary(files);
    if (!csv.empty())
        writeCsv(csv, files);
    return 0;
}

}  // namespace

int main(int argc, char** argv)
{
    return runProgram(argc, argv, kKeys, "The camera pose from files of 2D-3D correspondences.\n", 1, run);
}
