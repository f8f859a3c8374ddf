#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "core/base/progress.h"

namespace cullscope {

/// What a program that reads standard input wrote, and how it ended.
struct Filtered {
    std::string output, errors;  ///< of standard output and standard error
    int status = 0;              ///< of its exit; -1 where a signal ended it
};

/// A program in lib/cullscope beside the folder of this one, where the build and the installation put what the programs open or
/// start themselves.
[[nodiscard]] std::filesystem::path ownLibraryFile(std::string_view name);

/// Runs `program` in a process of its own with `input` as its standard input, and waits for its end. What crashes there ends
/// nothing else. On a stop request it is killed and Error(Interrupted) thrown. Throws Error(Usage) where it cannot be started,
/// Error(Input) where the system refuses the memory for what goes in and out.
[[nodiscard]] Filtered runFilter(const std::filesystem::path& program, std::span<const std::string> arguments,
                                 std::string_view input, const Progress& progress);

}  // namespace cullscope
