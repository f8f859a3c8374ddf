// Loads a binary PLY (10 million faces by default) by loadMeshFile and by OpenMesh's bare reader, in turns, each time in a child
// process of its own, and compares the median times and the highest peak of memory with the targets. Exit status 1 where a target
// is missed.
//
//   ply_load_benchmark [faces] [rounds]
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "core/mesh/load.h"
#include "tests/benchmark/ply_load.h"

namespace {

using namespace cullscope;

constexpr double kLeastRelativeSpeed = 0.70;
constexpr double kMostMemoryRatio = 2.5;

struct Run {
    double seconds = 0.0;
    double arrayBytes = 0.0;
    double peakBytes = 0.0;
};

double peakResidentBytes() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmHWM:")) return 1024.0 * std::stod(line.substr(6));
    return 0.0;
}

/// Runs `load`, which returns the size of its arrays in bytes, in a child process.
template <typename Load>
Run measured(Load&& load) {
    int ends[2];
    if (pipe(ends) != 0) std::exit(2);
    const pid_t child = fork();
    if (child == 0) {
        Run run;
        try {
            const auto start = std::chrono::steady_clock::now();
            run.arrayBytes = load();
            run.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
            run.peakBytes = peakResidentBytes();
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
    if (!whole || status != 0) std::exit(2);
    return run;
}

double medianSeconds(std::vector<Run> runs) {
    std::ranges::sort(runs, {}, &Run::seconds);
    return runs[runs.size() / 2].seconds;
}

double highestPeak(const std::vector<Run>& runs) { return std::ranges::max(runs, {}, &Run::peakBytes).peakBytes; }

Run loadByCullscope(const std::filesystem::path& path) {
    return measured([&] { return static_cast<double>(loadMeshFile(path).objects.front().mesh->bytes()); });
}

Run loadByYardstick(const std::filesystem::path& path) {
    return measured([&] {
        const benchmark::BareMesh mesh = benchmark::loadByOpenMesh(path);
        return 4.0 * static_cast<double>(mesh.positions.size() + mesh.indices.size());
    });
}

}  // namespace

int main(int count, char** arguments) {
    const uint64_t faces = count > 1 ? std::strtoull(arguments[1], nullptr, 10) : 10'000'000;
    const int rounds = count > 2 ? std::atoi(arguments[2]) : 5;
    const std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("cullscope-ply-" + std::to_string(getpid()) + ".ply");
    benchmark::writeSheet(path, faces);
    std::vector<Run> own;
    std::vector<Run> yardstick;
    for (int round = 0; round < rounds; ++round) {
        own.push_back(loadByCullscope(path));
        yardstick.push_back(loadByYardstick(path));
        std::printf("round %d: cullscope %.3f s, OpenMesh's bare reader %.3f s\n", round + 1, own.back().seconds,
                    yardstick.back().seconds);
    }
    std::filesystem::remove(path);

    const double speed = medianSeconds(yardstick) / medianSeconds(own);
    const double memory = highestPeak(own) / own.front().arrayBytes;
    std::printf("speed: %.2f of OpenMesh's bare reader (at least %.2f)\n", speed, kLeastRelativeSpeed);
    std::printf("peak memory: %.0f MB, %.2f of the arrays' %.0f MB (at most %.2f); OpenMesh's bare reader %.0f MB\n",
                highestPeak(own) / 1e6, memory, own.front().arrayBytes / 1e6, kMostMemoryRatio, highestPeak(yardstick) / 1e6);
    return speed >= kLeastRelativeSpeed && memory <= kMostMemoryRatio ? 0 : 1;
}
