#include "tests/support/peak_memory.h"

#include <gtest/gtest.h>
#include <malloc.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <string>

namespace cullscope::test {
namespace {

/// A line of /proc/self/status that is in kB, in bytes.
size_t ownStatus(const std::string& name) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with(name + ":")) return size_t{1024} * std::stoul(line.substr(name.size() + 1));
    return 0;
}

}  // namespace

bool memoryIsTheWorks() {
#ifdef CULLSCOPE_SANITIZED
    return false;
#else
    return true;
#endif
}

size_t peakBytesOf(const std::function<void()>& work) {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) return 0;
    const pid_t child = fork();
    if (child == 0) {
        // Large blocks go back to the system when they are freed, as in a fresh process: else the tests before, whose large
        // blocks have raised glibc's threshold, decide how much of them stays.
        constexpr int kFreshThreshold = 128 * 1024;
        mallopt(M_MMAP_THRESHOLD, kFreshThreshold);
        mallopt(M_TRIM_THRESHOLD, kFreshThreshold);
        const size_t before = ownStatus("VmRSS"), filesBefore = ownStatus("RssFile");
        try {
            work();
        } catch (...) {
            // What it took until then counts.
        }
        // Pages of the program's own file that are read meanwhile are not the work's: how many of them the kernel had dropped
        // depends on what else runs.
        const size_t files = ownStatus("RssFile") - std::min(filesBefore, ownStatus("RssFile"));
        const size_t most = ownStatus("VmHWM") - before;
        const size_t taken = most - std::min(files, most);
        _exit(write(ends[1], &taken, sizeof taken) == sizeof taken ? 0 : 1);
    }
    close(ends[1]);
    size_t taken = 0;
    EXPECT_EQ(read(ends[0], &taken, sizeof taken), ssize_t{sizeof taken}) << "the child ended before it said its peak";
    close(ends[0]);
    waitpid(child, nullptr, 0);
    return taken;
}

}  // namespace cullscope::test
