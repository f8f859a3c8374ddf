#include "core/frame/decided_ahead.h"

#include <algorithm>
#include <map>
#include <set>

namespace cullscope {
namespace {

bool isQuestion(const Command& command) { return std::holds_alternative<AskedBoxes>(command); }

/// What decisions name as drawn.
class NamedAsDrawn {
public:
    explicit NamedAsDrawn(const FrameLog& log) : m_log(log) {}

    void add(const Decision& decision) {
        using Outcome = Decision::Outcome;
        const bool whole = decision.outcome == Outcome::Drawn || decision.outcome == Outcome::DrawnAfterAll;
        if (!whole && decision.outcome != Outcome::PartlyDrawn) return;
        for (const uint32_t instance : m_log.objectsOf(decision)) m_objects.insert(instance);
        if (decision.subject.kind == Subject::Kind::Object) m_objects.insert(decision.subject.number);
        if (decision.subject.kind == Subject::Kind::Cell && whole) m_cells[decision.subject.object].push_back(decision.places);
    }

    void sort() {
        for (auto& [instance, runs] : m_cells)
            std::ranges::sort(runs, [](const PlaceRun& a, const PlaceRun& b) { return a.first < b.first; });
    }

    /// The part of a range that is named.
    void addPart(const DrawRange& range, std::vector<DrawRange>& ranges) const {
        if (m_objects.contains(range.instance)) return ranges.push_back(range);
        const auto found = m_cells.find(range.instance);
        if (found == m_cells.end()) return;
        uint32_t from = range.firstIndex / 3;
        const uint32_t end = from + range.indexCount / 3;
        for (const PlaceRun& run : found->second) {
            const uint32_t first = std::max(from, run.first), last = std::min(end, run.first + run.count);
            if (first >= last) continue;
            ranges.push_back({range.instance, 3 * first, 3 * (last - first)});
            from = last;
        }
    }

private:
    const FrameLog& m_log;
    std::set<uint32_t> m_objects;
    std::map<uint32_t, std::vector<PlaceRun>> m_cells;  ///< by instance
};

}  // namespace

DrawList decidedAhead(const FrameLog& log, size_t entries) {
    const size_t all = std::min(entries, log.entries()), done = log.commandsWithin(all), decided = all - done;
    const auto begin = log.commands.begin();
    const auto next = std::find_if_not(begin + std::ptrdiff_t(done), log.commands.end(), isQuestion);
    if (next == log.commands.end() || !std::holds_alternative<DrawList>(*next)) return {log.facing, {}};
    size_t since = done;  // the first command after the last one that drew
    while (since > 0 && isQuestion(log.commands[since - 1])) --since;
    NamedAsDrawn named(log);
    for (size_t i = decided; i-- > 0 && log.decisions[i].commands >= since;) named.add(log.decisions[i]);
    named.sort();
    const auto& list = std::get<DrawList>(*next);
    DrawList ahead{list.facing, {}, list.order, list.depth};
    for (const DrawRange& range : list.ranges) named.addPart(range, ahead.ranges);
    return ahead;
}

}  // namespace cullscope
