// The build and cull times of `spherical-lossless`, without a window. Ratios count: each is measured within one run, in turns.
//
//   spherical_lossless_benchmark build SCENE… [ROUNDS]   build time beside Embree's of the same mesh, bytes
//   spherical_lossless_benchmark growth FOLDER           bytes and build time over 10,000 to 10 million faces
//   spherical_lossless_benchmark cull FOLDER             nodes and time of one cull over the same counts, at equal pictures
//   spherical_lossless_benchmark layouts FOLDER [SCENE]… both layouts of the map over given scenes, torus, knot and sphere
//
// Tables and plots are written to FOLDER. Exit status 1 where a promise does not hold.
#include <cstdlib>

#include "tests/benchmark/experiments.h"
#include "tests/benchmark/run_experiment.h"

namespace {

using namespace cullscope::benchmark;

std::optional<BenchmarkRun> buildRun(const std::vector<std::string>& arguments) {
    constexpr int kRounds = 15;
    std::vector<std::string> scenes(arguments.begin() + 1, arguments.end());
    int rounds = kRounds;
    if (scenes.size() > 1 && scenes.back().find_first_not_of("0123456789") == std::string::npos) {
        rounds = std::atoi(scenes.back().c_str());
        scenes.pop_back();
    }
    if (rounds < 1) return std::nullopt;
    return BenchmarkRun{losslessBuild(scenes, rounds)};
}

BenchmarkRun layoutsRun(const std::vector<std::string>& arguments) {
    std::vector<std::string> scenes(arguments.begin() + 2, arguments.end());
    for (const char* shape : {"torus", "knot", "sphere"}) scenes.push_back(std::string(shape) + ":triangles=144046");
    return {losslessLayouts(scenes), arguments[1]};
}

std::optional<BenchmarkRun> runOf(const std::vector<std::string>& arguments) {
    if (arguments.size() < 2) return std::nullopt;
    const std::string& command = arguments.front();
    if (command == "build") return buildRun(arguments);
    if (command == "layouts") return layoutsRun(arguments);
    if (arguments.size() == 2 && command == "growth") return BenchmarkRun{losslessGrowth(), arguments[1]};
    if (arguments.size() == 2 && command == "cull") return BenchmarkRun{losslessCull(), arguments[1]};
    return std::nullopt;
}

}  // namespace

int main(int argc, char** argv) {
    return benchmarkMain(
        argc, argv,
        "spherical_lossless_benchmark build SCENE... [ROUNDS] | growth FOLDER | cull FOLDER | layouts FOLDER [SCENE]...", runOf);
}
