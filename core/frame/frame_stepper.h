#pragma once

#include <memory>
#include <optional>

#include "core/frame/entry_kinds.h"

namespace cullscope {

/// A place in the replay of a recorded frame, which moves by steps. Knows no window and no clock: who plays says how much time
/// has passed.
class FrameStepper {
public:
    /// The log is not null. Stands at the end, where the replay shows the whole frame.
    explicit FrameStepper(std::shared_ptr<const FrameLog> log, size_t mostSteps = FrameSteps::kMostSteps);

    [[nodiscard]] const FrameLog& log() const { return *m_log; }
    [[nodiscard]] const FrameSteps& steps() const { return m_steps; }
    /// From 0 (nothing happened yet) to `count`.
    [[nodiscard]] size_t step() const { return m_step; }
    [[nodiscard]] size_t count() const { return m_steps.count(); }
    /// The entries that the replay has: FrameLog::upTo(entries()) is what it shows.
    [[nodiscard]] size_t entries() const { return m_steps.entriesAfter(m_step); }
    /// The last entry of the replay: the one in hand; none before the first step.
    [[nodiscard]] std::optional<FrameEntry> current() const;

    void jump(size_t step) { m_step = std::min(step, count()); }
    /// One step on or back. Returns false at the end or at the start.
    bool forward();
    bool back();

    /// The kinds of entries at which `run` stops. `log` has them or not.
    void setBreakpoints(std::set<EntryKind> kinds) { m_breakpoints = std::move(kinds); }
    [[nodiscard]] const std::set<EntryKind>& breakpoints() const { return m_breakpoints; }
    /// Goes on (or back) by so many steps, but no further than the first one with an entry of a breakpoint's kind. Returns
    /// whether it stands at such a step, or could not go as far because the replay ends there.
    bool run(size_t steps);
    bool runBack(size_t steps);

    /// Steps a second, with which `play` goes on; above 0.
    void setSpeed(double stepsPerSecond) { m_speed = stepsPerSecond; }
    [[nodiscard]] double speed() const { return m_speed; }
    /// Goes on by as many steps as are due after so many seconds more; parts of steps are kept for the next call. Returns false
    /// where it stopped at a breakpoint or at the end.
    bool play(double seconds);

private:
    [[nodiscard]] bool breaksAt(size_t step) const;

    std::shared_ptr<const FrameLog> m_log;
    FrameEntries m_entries;
    FrameSteps m_steps;
    size_t m_step;
    std::set<EntryKind> m_breakpoints;
    double m_speed = 4.0;
    double m_due = 0.0;  ///< parts of steps
};

}  // namespace cullscope
