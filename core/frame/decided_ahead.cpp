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
        if (decision.subject.holdsTriangles() && whole) m_cells[decision.subject.object].push_back(decision.places);
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

namespace {

/// The decisions that name parts of the next command: those after the command before it.
std::span<const Decision> aboutNext(const FrameLog& log, size_t commands, size_t decided) {
    const std::span<const Decision> said = std::span(log.decisions).first(decided);
    const auto first = std::ranges::find_if(said, [&](const Decision& decision) { return decision.commands >= commands; });
    return {first, said.end()};
}

OwnTrianglesPointer firstOf(const OwnTriangles& all, uint32_t count) {
    auto part = std::make_shared<OwnTriangles>();
    part->facing = all.facing;
    part->depth = all.depth;
    part->positions.assign(all.positions.begin(), all.positions.begin() + std::ptrdiff_t(3 * size_t(count)));
    part->normals.assign(all.normals.begin(), all.normals.begin() + std::ptrdiff_t(3 * size_t(count)));
    part->triangles.assign(all.triangles.begin(), all.triangles.begin() + std::ptrdiff_t(count));
    for (const OwnTriangles::Run& run : all.runs)
        if (run.first < count) part->runs.push_back({run.instance, run.first, std::min(run.count, count - run.first)});
    return part;
}

OwnTrianglesPointer namedPart(const OwnTriangles& all, std::span<const Decision> said) {
    uint32_t end = 0;
    for (const Decision& decision : said)
        if (decision.subject.kind == Subject::Kind::Fragment && decision.places.count > 0)
            end = std::max(end, decision.places.first + decision.places.count);
    return end == 0 ? nullptr : firstOf(all, std::min(end, uint32_t(all.triangles.size())));
}

/// The triangles that decisions name as drawn into a picture, by a depth test.
DrawList drawnInto(Facing facing, std::span<const Decision> said) {
    DrawList list{facing, {}};
    for (const Decision& decision : said)
        if (decision.subject.kind == Subject::Kind::Triangles && decision.outcome == Decision::Outcome::Drawn)
            list.ranges.push_back({decision.subject.object, 3 * decision.places.first, 3 * decision.places.count});
    return list;
}

FinishedPicturePointer namedPart(const FinishedPicture& all, std::span<const Decision> said) {
    auto part = std::make_shared<FinishedPicture>();
    part->size = all.size;
    part->triangle.assign(all.triangle.size(), 0);
    part->depth.assign(all.depth.size(), 0.0f);
    const auto width = uint32_t(all.size.width);
    bool any = false;
    for (const Decision& decision : said) {
        const bool pixels = decision.subject.kind == Subject::Kind::Rows || decision.subject.kind == Subject::Kind::Span;
        if (!pixels || decision.places.count == 0) continue;
        const uint32_t first = decision.places.first, last = first + decision.places.count - 1;
        if (last >= all.triangle.size()) continue;
        any = true;
        for (uint32_t row = first / width; row <= last / width; ++row) {
            const auto from = std::ptrdiff_t(row * width + first % width), to = std::ptrdiff_t(row * width + last % width + 1);
            std::copy(all.triangle.begin() + from, all.triangle.begin() + to, part->triangle.begin() + from);
            std::copy(all.depth.begin() + from, all.depth.begin() + to, part->depth.begin() + from);
        }
    }
    return any ? part : nullptr;
}

}  // namespace

FrameLog replayUpTo(const FrameLog& log, size_t entries) {
    FrameLog part = log.upTo(entries);
    const size_t done = part.commands.size();
    const auto next = std::find_if_not(log.commands.begin() + std::ptrdiff_t(done), log.commands.end(), isQuestion);
    if (next == log.commands.end()) return part;
    const std::span<const Decision> said = aboutNext(log, done, part.decisions.size());
    if (const auto* own = std::get_if<OwnTrianglesPointer>(&*next)) {
        if (OwnTrianglesPointer named = namedPart(**own, said)) part.commands.emplace_back(std::move(named));
    } else if (const auto* picture = std::get_if<FinishedPicturePointer>(&*next)) {
        DrawList drawn = drawnInto(log.facing, said);
        if (!drawn.ranges.empty())
            part.commands.emplace_back(std::move(drawn));
        else if (FinishedPicturePointer named = namedPart(**picture, said))
            part.commands.emplace_back(std::move(named));
    }
    return part;
}

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
    DrawList ahead{list.facing, {}, list.order, list.depth, list.grain};
    for (const DrawRange& range : list.ranges) named.addPart(range, ahead.ranges);
    return ahead;
}

}  // namespace cullscope
