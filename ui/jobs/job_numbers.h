#pragma once

#include <atomic>
#include <cstdint>

namespace cullscope::ui {

/// Numbers for background jobs: only the newest counts, whatever an older one brings is stale and dropped.
/// May be asked from any thread.
class JobNumbers {
public:
    /// A new job begins; all earlier ones are stale from now on.
    uint64_t begin() { return ++m_current; }
    /// No job counts any more.
    void invalidate() { ++m_current; }
    [[nodiscard]] bool isCurrent(uint64_t job) const { return m_current.load() == job; }

private:
    std::atomic<uint64_t> m_current{0};
};

}  // namespace cullscope::ui
