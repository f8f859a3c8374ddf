#pragma once

#include <cstdint>

namespace cullscope {

/// The bytes that one piece of work may plan to take: three quarters of the machine's memory, or of the process's address space
/// where that is limited to less (`ulimit -v`). What is known to need more is refused before anything is allocated.
[[nodiscard]] uint64_t memoryToPlanWith();

/// Whether the system refuses half a gigabyte more at this moment. Libraries, drivers among them, then fail in ways that name
/// another reason, or crash, because they do not look whether they got what they asked for. May be called in a signal handler.
[[nodiscard]] bool memoryIsShort();

/// Whether the system refuses one more thread at this moment. May be called in a signal handler.
[[nodiscard]] bool threadsAreShort();

/// Whether the system refuses as many threads at once as OpenGL in software starts here: one a processor and a few more. A
/// driver that is refused one of them may wait for it forever.
[[nodiscard]] bool tooFewThreadsForOpenGl();

}  // namespace cullscope
