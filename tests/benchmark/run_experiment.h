#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/experiments/experiment.h"

namespace cullscope::benchmark {

/// The experiment that a program's arguments ask for, and the folder of its files; an empty one: nothing is written.
struct BenchmarkRun {
    Experiment experiment;
    std::filesystem::path folder{};
};

/// Runs an experiment with an OpenGL context of its own, if it needs one; prints its table and checks; writes FOLDER/<id>.csv and
/// FOLDER/<id>.svg, each whole or not at all. Returns the program's exit status: 1 where a check does not hold or a strategy
/// broke its promise. Throws std::logic_error for an experiment that does not declare what it varies and shows
/// (experimentFaults).
int runAndReport(const BenchmarkRun& run);

/// The arguments without the program's name; none where they are not understood.
using RunOfArguments = std::function<std::optional<BenchmarkRun>(const std::vector<std::string>& arguments)>;

/// A benchmark's main: exit status 2, with a sentence, where the arguments are not understood or the experiment fails.
int benchmarkMain(int argc, char** argv, const char* usage, const RunOfArguments& runOf);

}  // namespace cullscope::benchmark
