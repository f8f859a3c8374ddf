#include "core/base/work_check.h"

#include <utility>

namespace cullscope {

std::atomic<WorkCheck::Observer> WorkCheck::observer{nullptr};

void WorkCheck::look() {
    const uint32_t steps = std::exchange(m_steps, 0);
    if (const Observer watching = observer.load(std::memory_order_relaxed)) watching(steps);
    m_progress.check();
}

}  // namespace cullscope
