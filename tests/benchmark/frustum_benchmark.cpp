// Boxes and spheres a second by the frustum tests; docs/methods/frustum.md, "What it costs".
//
//   frustum_benchmark FOLDER [LARGEST]    up to 1e7 objects, or LARGEST; table and plots are written to FOLDER
//
// Ratios count: all variants run in turns. Exit status 1 where what is promised of them does not hold.
#include <cstdlib>

#include "tests/benchmark/experiments.h"
#include "tests/benchmark/run_experiment.h"

int main(int argc, char** argv) {
    using namespace cullscope::benchmark;
    return benchmarkMain(argc, argv, "frustum_benchmark FOLDER [LARGEST]; LARGEST: 1e5 or more",
                         [](const std::vector<std::string>& arguments) -> std::optional<BenchmarkRun> {
                             if (arguments.empty() || arguments.size() > 2) return std::nullopt;
                             const double largest = arguments.size() == 2 ? std::atof(arguments[1].c_str()) : 1e7;
                             if (!(largest >= 1e5 && largest <= 1e7)) return std::nullopt;
                             return BenchmarkRun{frustumTests(size_t(largest)), arguments[0]};
                         });
}
