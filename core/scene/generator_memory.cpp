#include "core/scene/generator_memory.h"

#include <cstdint>

#include "core/base/error.h"
#include "core/base/memory_limit.h"

namespace cullscope {

void requireGeneratorMemory(const std::string& generator, double bytes, const LoadOptions& options) {
    const uint64_t allowed = options.memoryLimitBytes > 0 ? options.memoryLimitBytes : memoryToPlanWith();
    if (bytes <= static_cast<double>(allowed)) return;
    throwUsage(CULLSCOPE_TR("%1: a scene of this size needs about %2 MB of memory, more than the %3 MB allowed. Ask for fewer "
                            "triangles or objects."),
               {generator, std::to_string(static_cast<uint64_t>(bytes / (1 << 20)) + 1), std::to_string(allowed >> 20)});
}

}  // namespace cullscope
