#pragma once

#include <string>
#include <vector>

namespace cullscope::test {

/// The exit status of a program that was run, and its output.
struct ProcessResult {
    int exitStatus = -1;  ///< -1: ended by a signal
    std::string out, err;
};

/// Runs a program with arguments and extra environment ("NAME=value"), without standard input. With `interruptAfterSeconds` above
/// 0 it is sent SIGINT that many seconds after it began to handle interrupts.
[[nodiscard]] ProcessResult runProcess(const std::vector<std::string>& command, const std::vector<std::string>& environment = {},
                                       double interruptAfterSeconds = 0.0);

}  // namespace cullscope::test
