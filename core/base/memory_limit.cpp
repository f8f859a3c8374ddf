#include "core/base/memory_limit.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>

namespace cullscope {

uint64_t memoryToPlanWith() {
    const auto pages = static_cast<uint64_t>(std::max(0L, sysconf(_SC_PHYS_PAGES)));
    uint64_t bytes = pages * static_cast<uint64_t>(std::max(0L, sysconf(_SC_PAGE_SIZE)));
    rlimit addressSpace{};
    if (getrlimit(RLIMIT_AS, &addressSpace) == 0 && addressSpace.rlim_cur != RLIM_INFINITY)
        bytes = std::min(bytes, static_cast<uint64_t>(addressSpace.rlim_cur));
    return bytes / 4 * 3;
}

}  // namespace cullscope
