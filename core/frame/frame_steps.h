#pragma once

#include <cstdint>
#include <vector>

#include "core/frame/frame_log.h"

namespace cullscope {

/// One entry of a log: a command or a decision, the other one is null. Valid as long as the log.
struct FrameEntry {
    const Command* command = nullptr;
    const Decision* decision = nullptr;
    size_t number = 0;  ///< of the command among the commands, or of the decision among the decisions
};

/// The entries of a log in the order in which they happened, numbered from 0. Refers to the log.
class FrameEntries {
public:
    explicit FrameEntries(const FrameLog& log);

    [[nodiscard]] size_t size() const { return m_log->entries(); }
    [[nodiscard]] FrameEntry at(size_t entry) const;

private:
    const FrameLog* m_log;
    std::vector<size_t> m_commands;  ///< by command: its number among all entries
};

/// What one step of a replay adds.
enum class StepGrain {
    Entry,     ///< one command or decision
    Subject,   ///< all consecutive decisions about one subject
    Object,    ///< all consecutive decisions about one object and its parts, or about one node
    Commands,  ///< a command with all decisions before it
    Share      ///< equal numbers of entries
};

/// The steps in which a log is replayed: the finest grain that needs no more than a number of steps. The first step replays
/// nothing (0 entries), the last one (`count`) all entries.
class FrameSteps {
public:
    static constexpr size_t kMostSteps = 200'000;

    explicit FrameSteps(const FrameLog& log, size_t most = kMostSteps);

    [[nodiscard]] StepGrain grain() const { return m_grain; }
    [[nodiscard]] size_t count() const { return m_grain == StepGrain::Entry ? m_entries : m_ends.size(); }
    /// The number of entries that are replayed after so many steps, at most `count`.
    [[nodiscard]] size_t entriesAfter(size_t steps) const;
    /// The first step that replays at least so many entries.
    [[nodiscard]] size_t stepWith(size_t entries) const;

private:
    [[nodiscard]] bool fill(const FrameLog& log, const FrameEntries& entries, StepGrain grain, size_t most);

    size_t m_entries;
    StepGrain m_grain = StepGrain::Entry;
    std::vector<size_t> m_ends;  ///< entries after each step; empty with StepGrain::Entry
};

/// How many entries of a log stand for the first `entries` of a log with `whole` entries: the same number where the logs have
/// equally many, else the same share, rounded.
[[nodiscard]] size_t entriesAtShare(size_t entries, size_t whole, size_t ofLog);

}  // namespace cullscope
