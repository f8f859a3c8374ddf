#pragma once

#include <atomic>
#include <cstdint>

#include "core/base/progress.h"

namespace cullscope {

/// Looks for a stop request after every `kBetween` steps of a long piece of work. A step is something that takes about a
/// microsecond, such as one triangle, one polygon at a plane, or one comparison: so two looks are a few milliseconds apart.
class WorkCheck {
public:
    static constexpr uint32_t kBetween = 1024;

    /// Keeps a reference to the progress.
    explicit WorkCheck(const Progress& progress) : m_progress(progress) {}

    /// One more step was made. Throws Error(Interrupted) where a stop was requested and it is time to look.
    void step() {
        if (++m_steps == kBetween) look();
    }
    /// Compares as `less` does; each comparison is a step. For sorting: a sort that is stopped leaves its values in any order.
    template <typename Less>
    [[nodiscard]] auto counting(Less less) {
        return [this, less](const auto& a, const auto& b) {
            step();
            return less(a, b);
        };
    }

    /// Called at every look with the steps since the last one, on the thread that works, before the stop request is read. Null:
    /// nothing is called. Tests count work by it, and not by time.
    using Observer = void (*)(uint32_t steps);
    static std::atomic<Observer> observer;

private:
    void look();

    const Progress& m_progress;
    uint32_t m_steps = 0;
};

}  // namespace cullscope
