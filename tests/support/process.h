#pragma once

#include <string>
#include <vector>

namespace cullscope::test {

/// How a program that was run ended, and what it printed.
struct ProcessResult {
    int exitStatus = -1;  ///< -1: ended by a signal
    std::string out, err;
};

/// Runs a program with arguments and extra environment ("NAME=value"), with no standard input. With `interruptAfterSeconds` above
/// 0 it gets SIGINT that time after it began to take interrupts.
[[nodiscard]] ProcessResult runProcess(const std::vector<std::string>& command, const std::vector<std::string>& environment = {},
                                       double interruptAfterSeconds = 0.0);

}  // namespace cullscope::test
