#include "core/frame/frame_stepper.h"

#include <algorithm>
#include <cmath>

namespace cullscope {

FrameStepper::FrameStepper(std::shared_ptr<const FrameLog> log, size_t mostSteps)
    : m_log(std::move(log)), m_entries(*m_log), m_steps(*m_log, mostSteps), m_step(m_steps.count()) {}

std::optional<FrameEntry> FrameStepper::current() const {
    return m_step == 0 ? std::nullopt : std::optional(m_entries.at(entries() - 1));
}

bool FrameStepper::forward() {
    if (m_step == count()) return false;
    ++m_step;
    return true;
}

bool FrameStepper::back() {
    if (m_step == 0) return false;
    --m_step;
    return true;
}

bool FrameStepper::breaksAt(size_t step) const {
    if (m_breakpoints.empty() || step == 0) return false;
    for (size_t entry = m_steps.entriesAfter(step - 1); entry < m_steps.entriesAfter(step); ++entry)
        if (isOfKind(m_entries.at(entry), m_breakpoints)) return true;
    return false;
}

bool FrameStepper::run(size_t steps) {
    for (size_t i = 0; i < steps; ++i) {
        if (!forward()) return true;
        if (breaksAt(m_step)) return true;
    }
    return false;
}

bool FrameStepper::runBack(size_t steps) {
    for (size_t i = 0; i < steps; ++i) {
        if (!back()) return true;
        if (breaksAt(m_step)) return true;
    }
    return false;
}

bool FrameStepper::play(double seconds) {
    m_due += seconds * m_speed;
    const double whole = std::floor(m_due);
    m_due -= whole;
    const bool stopped = run(size_t(whole)) || m_step == count();
    if (stopped) m_due = 0.0;
    return !stopped;
}

}  // namespace cullscope
