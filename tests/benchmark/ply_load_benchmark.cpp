// Loads binary PLYs (of a million and of 10 million faces by default) by loadMeshFile and by OpenMesh's bare reader, in turns,
// each time in a child process of its own, and compares the median times and the highest peak of memory of the largest with the
// targets. Exit status 1 where a target is missed.
//
//   ply_load_benchmark [faces] [rounds]
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "core/mesh/load.h"
#include "tests/benchmark/in_turns.h"
#include "tests/benchmark/ply_load.h"
#include "tests/benchmark/run_experiment.h"

namespace {

using namespace cullscope;
using namespace cullscope::benchmark;

constexpr double kLeastRelativeSpeed = 0.70;
constexpr double kMostMemoryRatio = 2.5;
const std::string kCullscope = "loadMeshFile", kOpenMesh = "OpenMesh's bare reader";

struct Run {
    double seconds = 0.0;
    double arrayBytes = 0.0;
    double peakBytes = 0.0;  ///< beyond what the process held before
};

/// A field of the process's status, such as its resident memory, in bytes.
double statusBytes(const std::string& field) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with(field + ":")) return 1024.0 * std::stod(line.substr(field.size() + 1));
    return 0.0;
}

/// Runs `load`, which returns the size of its arrays in bytes, in a child process of its own.
template <typename Load>
Run measured(Load&& load) {
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("there is no pipe");
    const pid_t child = fork();
    if (child == 0) {
        Run run;
        try {
            const double before = statusBytes("VmRSS");
            const auto start = std::chrono::steady_clock::now();
            run.arrayBytes = load();
            run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
            run.peakBytes = statusBytes("VmHWM") - before;
        } catch (const std::exception& failure) {
            std::fprintf(stderr, "%s\n", failure.what());
            _exit(1);
        }
        _exit(write(ends[1], &run, sizeof(run)) == sizeof(run) ? 0 : 1);
    }
    close(ends[1]);
    Run run;
    const bool whole = read(ends[0], &run, sizeof(run)) == sizeof(run);
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    if (!whole || status != 0) throw std::runtime_error("a reader failed");
    return run;
}

/// A file that is removed in the end.
struct TemporarySheet {
    explicit TemporarySheet(uint64_t faces)
        : path(std::filesystem::temp_directory_path() / ("cullscope-ply-" + std::to_string(getpid()) + ".ply")) {
        writeSheet(path, faces);
    }
    ~TemporarySheet() {
        std::error_code ignored;
        std::filesystem::remove(path, ignored);
    }
    TemporarySheet(const TemporarySheet&) = delete;
    TemporarySheet& operator=(const TemporarySheet&) = delete;

    const std::filesystem::path path;
};

Row cellsOf(const std::string& reader, const std::vector<double>& seconds, const std::vector<Run>& runs) {
    const double peak = std::ranges::max(runs, {}, &Run::peakBytes).peakBytes;
    return {{"reader", reader},
            {"seconds", medianOf(seconds)},
            {"peak_mb", peak / 1e6},
            {"arrays_mb", runs.front().arrayBytes / 1e6},
            {"peak_to_arrays", peak / runs.front().arrayBytes}};
}

/// Both readers in turns: median seconds, and the highest peak.
Rows readersRows(uint64_t faces, int rounds) {
    const TemporarySheet sheet(faces);
    std::vector<Run> own, other;
    const auto load = [&] {
        own.push_back(measured([&] { return double(loadMeshFile(sheet.path).objects.front().mesh->bytes()); }));
        return own.back().seconds;
    };
    const auto loadOther = [&] {
        other.push_back(measured([&] {
            const BareMesh mesh = loadByOpenMesh(sheet.path);
            return 4.0 * double(mesh.positions.size() + mesh.indices.size());
        }));
        return other.back().seconds;
    };
    const std::vector<std::vector<double>> seconds = inTurns({load, loadOther}, rounds);
    Rows rows{cellsOf(kCullscope, seconds[0], own), cellsOf(kOpenMesh, seconds[1], other)};
    rows[0]["speed_to_openmesh"] = ratioInTurns(seconds[1], seconds[0]);
    return rows;
}

Experiment plyLoad(const std::vector<double>& faces, int rounds) {
    Experiment experiment;
    experiment.id = "ply-load";
    experiment.title = "Binary PLYs read by loadMeshFile and by OpenMesh's bare reader";
    experiment.axes = {{"faces", "faces", Axis::Kind::Label, axisValues(faces)},
                       {"reader", "reader", Axis::Kind::InTurns, {kCullscope, kOpenMesh}}};
    experiment.settings = settingsOf(experiment.axes);
    experiment.columns = columnsOf(experiment.axes);
    const std::vector<std::pair<const char*, int>> columns{
        {"seconds", 3}, {"peak_mb", 0}, {"arrays_mb", 0}, {"peak_to_arrays", 2}};
    for (const auto& [key, decimals] : columns)
        experiment.columns.push_back({key, key, ResultColumn::Origin::Measured, decimals});
    experiment.columns.push_back({"speed_to_openmesh", "x OpenMesh [95 %]", ResultColumn::Origin::Measured, 2});
    RowPlot times{logPlot("Reading a binary PLY", "faces", "seconds"), "faces", {{"seconds"}}};
    times.lines = {"reader"};
    RowPlot memory{
        logPlot("Peak memory of reading a binary PLY", "faces", "MB"), "faces", {{"peak_mb", "peak"}, {"arrays_mb", "arrays"}}};
    memory.lines = {"reader"};
    experiment.plots = {times, memory};
    const RowFilter ours{{"reader", {kCullscope}}, {"faces", {faces.back()}}};
    experiment.checks = {
        everyRowCheck("speed, of OpenMesh's bare reader", ours, "speed_to_openmesh", {.least = kLeastRelativeSpeed}),
        everyRowCheck("peak memory, of the arrays", ours, "peak_to_arrays", {.most = kMostMemoryRatio})};
    experiment.measured = [rounds](const Setting& setting, const ScenePointer& /*scene*/, const Progress& /*progress*/) {
        return readersRows(uint64_t(setting.number("faces")), rounds);
    };
    return experiment;
}

}  // namespace

int main(int argc, char** argv) {
    return benchmarkMain(argc, argv, "ply_load_benchmark [faces] [rounds]",
                         [](const std::vector<std::string>& arguments) -> std::optional<BenchmarkRun> {
                             std::vector<double> faces{1e6, 1e7};
                             if (!arguments.empty()) faces = {double(std::strtoull(arguments[0].c_str(), nullptr, 10))};
                             const int rounds = arguments.size() < 2 ? 5 : std::atoi(arguments[1].c_str());
                             if (arguments.size() > 2 || faces.front() < 2 || rounds < 1) return std::nullopt;
                             return BenchmarkRun{plyLoad(faces, rounds)};
                         });
}
