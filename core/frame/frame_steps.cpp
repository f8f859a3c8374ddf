#include "core/frame/frame_steps.h"

#include <algorithm>
#include <cmath>

namespace cullscope {
namespace {

/// Whether an entry continues the step of the decision before it.
bool continues(const Decision& before, const Decision& next, StepGrain grain) {
    if (next.subject == before.subject) return true;
    return grain == StepGrain::Object && next.subject.object != Subject::kNoObject &&
           next.subject.object == before.subject.object;
}

}  // namespace

FrameEntries::FrameEntries(const FrameLog& log) : m_log(&log) {
    m_commands.reserve(log.commands.size());
    size_t before = 0;  // decisions
    for (size_t command = 0; command < log.commands.size(); ++command) {
        while (before < log.decisions.size() && log.decisions[before].commands <= command) ++before;
        m_commands.push_back(command + before);
    }
}

FrameEntry FrameEntries::at(size_t entry) const {
    const auto next = std::ranges::lower_bound(m_commands, entry);
    const auto commands = size_t(next - m_commands.begin());
    if (next != m_commands.end() && *next == entry) return {&m_log->commands[commands], nullptr, commands};
    return {nullptr, &m_log->decisions[entry - commands], entry - commands};
}

FrameSteps::FrameSteps(const FrameLog& log, size_t most) : m_entries(log.entries()) {
    if (m_entries <= most) return;
    const FrameEntries entries(log);
    for (const StepGrain grain : {StepGrain::Subject, StepGrain::Object})
        if (fill(log, entries, grain, most)) return;
    // The tests of batches, which go from object to object, all come before one command: then it is no step.
    if (fill(log, entries, StepGrain::Commands, most) && m_ends.size() > 1) return;
    m_grain = StepGrain::Share;
    m_ends.clear();
    for (size_t step = 1; step <= most; ++step) m_ends.push_back(entriesAtShare(step, most, m_entries));
}

bool FrameSteps::fill(const FrameLog& log, const FrameEntries& entries, StepGrain grain, size_t most) {
    m_grain = grain;
    m_ends.clear();
    if (grain == StepGrain::Commands && log.commands.empty()) return false;
    const Decision* before = nullptr;  // of the present step; null: that one is complete
    for (size_t i = 0; i < entries.size(); ++i) {
        const FrameEntry entry = entries.at(i);
        const bool joins = before != nullptr && (grain == StepGrain::Commands ||
                                                 (entry.decision != nullptr && continues(*before, *entry.decision, grain)));
        if (!joins) m_ends.push_back(i);
        m_ends.back() = i + 1;
        before = entry.decision;
        if (m_ends.size() > most) return false;
    }
    return true;
}

size_t FrameSteps::entriesAfter(size_t steps) const {
    const size_t step = std::min(steps, count());
    return step == 0 || m_grain == StepGrain::Entry ? step : m_ends[step - 1];
}

size_t FrameSteps::stepWith(size_t entries) const {
    if (m_grain == StepGrain::Entry) return std::min(entries, m_entries);
    if (entries == 0) return 0;
    const auto found = std::ranges::lower_bound(m_ends, entries);
    return std::min(size_t(found - m_ends.begin()) + 1, m_ends.size());
}

size_t entriesAtShare(size_t entries, size_t whole, size_t ofLog) {
    if (whole == ofLog || whole == 0) return std::min(entries, ofLog);
    const double share = double(entries) / double(whole);
    return std::min(size_t(std::llround(share * double(ofLog))), ofLog);
}

}  // namespace cullscope
