#pragma once

#include <cstdint>

namespace cullscope {

/// The bytes that one piece of work may plan to take: three quarters of the machine's memory, or of the process's address space
/// where that is limited to less (`ulimit -v`). What is known to need more is refused before anything is allocated.
[[nodiscard]] uint64_t memoryToPlanWith();

}  // namespace cullscope
