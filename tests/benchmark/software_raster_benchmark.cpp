// What a picture costs that is made on the processor, beside the same picture by OpenGL.
//
//   software_raster_benchmark FOLDER [SCENE [PATH]]
//
// Without a scene a sphere of 144,000 triangles is drawn over the path case-2. The table is written to FOLDER. Exit status 1
// where a check does not hold.
#include "tests/benchmark/experiments.h"
#include "tests/benchmark/run_experiment.h"

namespace {

using namespace cullscope::benchmark;

std::optional<BenchmarkRun> runOf(const std::vector<std::string>& arguments) {
    if (arguments.empty() || arguments.size() > 3) return std::nullopt;
    const std::string scene = arguments.size() > 1 ? arguments[1] : "sphere:triangles=144000";
    return BenchmarkRun{softwareRaster(scene, arguments.size() > 2 ? arguments[2] : "case-2"), arguments[0]};
}

}  // namespace

int main(int argc, char** argv) { return benchmarkMain(argc, argv, "software_raster_benchmark FOLDER [SCENE [PATH]]", runOf); }
