// The two occlusion buffers on one processor: pictures of all occluders of a scene, and a question about each object of another.
//
//   occlusion_buffers_benchmark FOLDER OCCLUDERS OBJECTS    1920 × 1080, the path tour:16 of the objects
//
// The table and its plot are written to FOLDER. Exit status 1 where a check does not hold.
#include "tests/benchmark/experiments.h"
#include "tests/benchmark/run_experiment.h"

int main(int argc, char** argv) {
    using namespace cullscope::benchmark;
    return benchmarkMain(
        argc, argv, "occlusion_buffers_benchmark FOLDER OCCLUDERS OBJECTS", [](const std::vector<std::string>& arguments) {
            if (arguments.size() != 3) return std::optional<BenchmarkRun>();
            return std::optional(BenchmarkRun{occlusionBuffers(arguments[1], arguments[2], 16, {1920, 1080}), arguments.front()});
        });
}
