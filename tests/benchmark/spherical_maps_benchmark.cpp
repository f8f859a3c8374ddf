// Bytes and build times of the three spherical maps; docs/methods/spherical.md, "Coordinates and maps".
//
//   spherical_maps_benchmark FOLDER [MESH]     MESH: resampled to the same counts up to a million, beside spheres
//
// Table and plots are written to FOLDER. Exit status 1 where bytes or build time do not grow linearly.
#include "tests/benchmark/experiments.h"
#include "tests/benchmark/run_experiment.h"

int main(int argc, char** argv) {
    using namespace cullscope::benchmark;
    return benchmarkMain(
        argc, argv, "spherical_maps_benchmark FOLDER [MESH]",
        [](const std::vector<std::string>& arguments) -> std::optional<BenchmarkRun> {
            if (arguments.empty() || arguments.size() > 2) return std::nullopt;
            return BenchmarkRun{sphericalMapsGrowth(arguments.size() == 2 ? arguments[1] : std::string()), arguments[0]};
        });
}
