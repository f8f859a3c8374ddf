#include "core/frame/entry_kinds.h"

#include <array>

#include "core/base/message.h"

namespace cullscope {
namespace {

using Trait = EntryKind::Trait;

/// Calls `use` with each kind of an entry.
template <typename Use>
void eachKind(const FrameEntry& entry, const Use& use) {
    if (entry.command != nullptr) return use(EntryKind{Trait::Commands, uint8_t(entry.command->index())});
    const Decision& decision = *entry.decision;
    use(EntryKind{Trait::Outcome, uint8_t(decision.outcome)});
    const bool leavesOut = decision.outcome == Decision::Outcome::Culled || decision.outcome == Decision::Outcome::PartlyDrawn;
    if (leavesOut) use(EntryKind{Trait::Cause, uint8_t(decision.cause)});
    use(EntryKind{Trait::Subject, uint8_t(decision.subject.kind)});
    if (decision.line > 0) use(EntryKind{Trait::Line, decision.line});
}

constexpr std::array kOutcomes{CULLSCOPE_TR("A test"), CULLSCOPE_TR("Drawn completely"), CULLSCOPE_TR("Drawn in part"),
                               CULLSCOPE_TR("Left out completely"), CULLSCOPE_TR("Drawn after all")};
constexpr std::array kSubjects{CULLSCOPE_TR("About an object"),
                               CULLSCOPE_TR("About a node"),
                               CULLSCOPE_TR("About a cell"),
                               CULLSCOPE_TR("About a ray"),
                               CULLSCOPE_TR("About a band"),
                               CULLSCOPE_TR("About a part of a triangle"),
                               CULLSCOPE_TR("About rows of the picture"),
                               CULLSCOPE_TR("About a piece of a row"),
                               CULLSCOPE_TR("About several cells"),
                               CULLSCOPE_TR("About triangles")};
constexpr std::array kCommands{CULLSCOPE_TR("Triangles of the scene are drawn"),
                               CULLSCOPE_TR("Triangles of the strategy's own are drawn"),
                               CULLSCOPE_TR("A finished picture is shown"), CULLSCOPE_TR("OpenGL is asked about boxes")};
static_assert(kCommands.size() == std::variant_size_v<Command>);

}  // namespace

std::set<EntryKind> kindsOf(const FrameEntry& entry) {
    std::set<EntryKind> kinds;
    eachKind(entry, [&](const EntryKind& kind) { kinds.insert(kind); });
    return kinds;
}

bool isOfKind(const FrameEntry& entry, const std::set<EntryKind>& kinds) {
    bool found = false;
    eachKind(entry, [&](const EntryKind& kind) { found = found || kinds.contains(kind); });
    return found;
}

std::map<EntryKind, uint64_t> countKinds(const FrameLog& log) {
    std::map<EntryKind, uint64_t> counts;
    const auto count = [&](const EntryKind& kind) { ++counts[kind]; };
    for (const Decision& decision : log.decisions) eachKind({nullptr, &decision, 0}, count);
    for (const Command& command : log.commands) eachKind({&command, nullptr, 0}, count);
    return counts;
}

Words kindWords(const EntryKind& kind, const std::vector<ListingLine>& lines) {
    switch (kind.trait) {
        case Trait::Outcome:
            return {kOutcomes[kind.value], {}};
        case Trait::Cause:
            return {CULLSCOPE_TR("Left out: %1"), {Term::marked(causeName(Cause(kind.value)))}};
        case Trait::Subject:
            return {kSubjects[kind.value], {}};
        case Trait::Line:
            if (kind.value > lines.size()) return {CULLSCOPE_TR("Line %1"), {Term::plain(kind.value)}};
            return {CULLSCOPE_TR("Line %1: %2"), {Term::plain(kind.value), Term::marked(lines[kind.value - 1].text)}};
        case Trait::Commands:
            break;
    }
    return {kCommands[kind.value], {}};
}

}  // namespace cullscope
