// The build and cull times of `spherical-lossless`, without a window. Ratios count: each is measured within one run, in turns.
//
//   spherical_lossless_benchmark build SCENE [ROUNDS]    build time beside Embree's of the same mesh, bytes
//   spherical_lossless_benchmark growth FOLDER           bytes and build time over 10,000 to 10 million faces
//   spherical_lossless_benchmark cull FOLDER             nodes and time of one cull over the same counts, at equal pictures
//   spherical_lossless_benchmark layouts FOLDER [SCENE]… both layouts of the map over given scenes, torus, knot and sphere
//
// Tables and plots are written to FOLDER. Exit status 1 where a promise does not hold.
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "tests/benchmark/lossless_benchmark.h"

namespace {

using namespace cullscope::benchmark;

constexpr int kRounds = 15;

int usage() {
    std::fprintf(stderr,
                 "spherical_lossless_benchmark build SCENE [ROUNDS] | growth FOLDER | cull FOLDER | layouts FOLDER [SCENE]...\n");
    return 2;
}

int runCommand(const std::string& command, const std::string& first, const std::vector<std::string>& rest) {
    if (command == "build" && rest.size() <= 1) {
        const int rounds = rest.empty() ? kRounds : std::atoi(rest.front().c_str());
        return rounds > 0 ? buildBesideEmbree(first, rounds) : usage();
    }
    if (command == "layouts") {
        std::filesystem::create_directories(first);
        return layouts(first, rest);
    }
    if (!rest.empty() || (command != "growth" && command != "cull")) return usage();
    std::filesystem::create_directories(first);
    return command == "growth" ? growth(first) : cullByFaces(first);
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc < 3) return usage();
    return runCommand(argv[1], argv[2], {argv + 3, argv + argc});
} catch (const std::exception& failure) {
    std::fprintf(stderr, "%s\n", failure.what());
    return 2;
}
