#pragma once

#include <compare>
#include <map>
#include <set>

#include "core/frame/frame_steps.h"
#include "core/frame/listing.h"
#include "core/frame/words.h"

namespace cullscope {

/// One of the kinds that an entry of a log belongs to: what a replay can stop at.
struct EntryKind {
    enum class Trait : uint8_t {
        Outcome,  ///< `value`: of Decision::Outcome
        Cause,    ///< `value`: of Cause, of what a decision leaves out
        Subject,  ///< `value`: of Subject::Kind
        Line,     ///< `value`: the listing's line, from 1
        Commands  ///< `value`: the place of its type in Command
    };
    Trait trait = Trait::Outcome;
    uint8_t value = 0;

    auto operator<=>(const EntryKind&) const = default;
};

/// All kinds that an entry belongs to.
[[nodiscard]] std::set<EntryKind> kindsOf(const FrameEntry& entry);
/// Whether an entry belongs to one of the kinds.
[[nodiscard]] bool isOfKind(const FrameEntry& entry, const std::set<EntryKind>& kinds);
/// The kinds that a log contains, with the number of their entries.
[[nodiscard]] std::map<EntryKind, uint64_t> countKinds(const FrameLog& log);
/// English, marked for translation. `lines`: of the strategy's listing; a line that it has not is named by its number alone.
[[nodiscard]] Words kindWords(const EntryKind& kind, const std::vector<ListingLine>& lines);

}  // namespace cullscope
