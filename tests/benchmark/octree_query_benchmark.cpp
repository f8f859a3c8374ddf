// `octree-query` beside the baselines, without a window. Ratios count: all strategies take turns.
//
//   octree_query_benchmark FOLDER [SCENE]…    32 layers of 10,000 triangles from the front, and walks through the scenes
//
// The table is written to FOLDER. Exit status 1 where the layers are not drawn at three times the speed of backface, or a pixel
// is lost.
#include "tests/benchmark/experiments.h"
#include "tests/benchmark/run_experiment.h"

int main(int argc, char** argv) {
    using namespace cullscope::benchmark;
    return benchmarkMain(argc, argv, "octree_query_benchmark FOLDER [SCENE]...", [](const std::vector<std::string>& arguments) {
        if (arguments.empty()) return std::optional<BenchmarkRun>();
        return std::optional(
            BenchmarkRun{octreeQueryBesideBackface("layers:count=32,triangles=10000", {arguments.begin() + 1, arguments.end()}),
                         arguments.front()});
    });
}
