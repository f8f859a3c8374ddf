#pragma once

#include <atomic>
#include <cstdint>

namespace cullscope::ui {

/// Numbers background jobs. Only the newest job is current; the result of an older one is stale and dropped. All functions may be
/// called on any thread.
class JobNumbers {
public:
    /// Begins a new job and returns its number. All earlier jobs become stale.
    uint64_t begin() { return ++m_current; }
    /// Makes all jobs stale.
    void invalidate() { ++m_current; }
    [[nodiscard]] bool isCurrent(uint64_t job) const { return m_current.load() == job; }

private:
    std::atomic<uint64_t> m_current{0};
};

}  // namespace cullscope::ui
