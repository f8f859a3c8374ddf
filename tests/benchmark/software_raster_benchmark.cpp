// What a picture costs that is made on the processor, beside the same picture by OpenGL.
//
//   software_raster_benchmark FOLDER [SCENE [PATH]]
//
// Without a scene spheres of 1,000, 12,000 and 144,000 triangles are drawn over the path case-2. The table and its plot are
// written to FOLDER. Exit status 1 where a check does not hold, for the last scene.
#include "tests/benchmark/experiments.h"
#include "tests/benchmark/run_experiment.h"

namespace {

using namespace cullscope::benchmark;

std::optional<BenchmarkRun> runOf(const std::vector<std::string>& arguments) {
    if (arguments.empty() || arguments.size() > 3) return std::nullopt;
    std::vector<std::string> scenes{"sphere:triangles=1000", "sphere:triangles=12000", "sphere:triangles=144000"};
    if (arguments.size() > 1) scenes = {arguments[1]};
    return BenchmarkRun{softwareRaster(scenes, arguments.size() > 2 ? arguments[2] : "case-2"), arguments[0]};
}

}  // namespace

int main(int argc, char** argv) { return benchmarkMain(argc, argv, "software_raster_benchmark FOLDER [SCENE [PATH]]", runOf); }
