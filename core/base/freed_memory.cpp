#include "core/base/freed_memory.h"

#include <malloc.h>

namespace cullscope {

void keepFreedMemory() {
#ifdef __GLIBC__
    // Either setting ends glibc's own adjustment of both, so that both are set. 32 MB is the most that glibc takes for a block.
    mallopt(M_TRIM_THRESHOLD, 128 << 20);
    mallopt(M_MMAP_THRESHOLD, 32 << 20);
#endif
}

}  // namespace cullscope
