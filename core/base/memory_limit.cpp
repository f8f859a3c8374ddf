#include "core/base/memory_limit.h"

#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace cullscope {

uint64_t memoryToPlanWith() {
    const auto pages = static_cast<uint64_t>(std::max(0L, sysconf(_SC_PHYS_PAGES)));
    uint64_t bytes = pages * static_cast<uint64_t>(std::max(0L, sysconf(_SC_PAGE_SIZE)));
    rlimit addressSpace{};
    if (getrlimit(RLIMIT_AS, &addressSpace) == 0 && addressSpace.rlim_cur != RLIM_INFINITY)
        bytes = std::min(bytes, static_cast<uint64_t>(addressSpace.rlim_cur));
    return bytes / 4 * 3;
}

bool memoryIsShort() {
    constexpr size_t kBytes = size_t{512} << 20;
    void* const got = mmap(nullptr, kBytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (got == MAP_FAILED) return true;
    munmap(got, kBytes);
    return false;
}

bool threadsAreShort() {
    // A process counts as a thread does. Without the C library, which would run functions of others before a fork, and without a
    // signal at its end, of which they would be told.
    const long child = syscall(SYS_clone, 0, nullptr, nullptr, nullptr, 0);
    if (child == 0) _exit(0);
    if (child < 0) return true;
    while (waitpid(static_cast<pid_t>(child), nullptr, __WALL) < 0 && errno == EINTR) {
    }
    return false;
}

bool tooFewThreadsForOpenGl() {
    constexpr unsigned kMore = 6;
    // Each one waits until all were started.
    std::mutex held;
    std::vector<std::jthread> threads;
    const std::lock_guard lock(held);
    try {
        for (unsigned i = 0; i < std::thread::hardware_concurrency() + kMore; ++i)
            threads.emplace_back([&] { const std::lock_guard waited(held); });
    } catch (const std::system_error&) {
        return true;
    }
    return false;
}

}  // namespace cullscope
