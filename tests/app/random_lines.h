#pragma once

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "tests/support/command_lines.h"

namespace cullbench_random_lines {

/// A command line of cullbench with what is known of its end.
struct RandomLine {
    cullscope::test::CommandLine line;
    std::set<int> statuses;            ///< those that may come of it
    std::vector<std::string> outputs;  ///< the files in the working folder that it may write
};

/// The scenes, camera paths and other files that the lines name, as ../../in relative to a working folder: `in` is their place.
void writeInputs(const std::filesystem::path& in);

/// One of a fixed sequence of command lines, made of valid pieces and, mostly, of up to three hostile ones.
[[nodiscard]] RandomLine randomLine(uint64_t seed);

}  // namespace cullbench_random_lines
