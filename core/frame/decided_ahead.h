#pragma once

#include "core/frame/frame_log.h"

namespace cullscope {

/// What the first `entries` entries of a log have decided to draw, and no command among them has drawn yet: the part of the next
/// draw list that decisions since the last drawing command name as drawn, wholly or in part. A strategy that decides about
/// everything before it draws can so be followed. Empty where the next drawing command is no draw list.
[[nodiscard]] DrawList decidedAhead(const FrameLog& log, size_t entries);

/// The first `entries` entries (FrameLog::upTo) as they are shown: where decisions name parts of the strategy's own triangles
/// (Subject::Kind::Fragment) or of its finished picture (Tile, Span) before the command that shows them all, those parts are a
/// last command of their own. The own triangles end with the last part that was named; of a picture there are the pixels named.
/// Where decisions name triangles as drawn before a picture (cells with Outcome::Drawn), the last command draws these, with a
/// depth test: so a depth buffer is followed triangle by triangle.
[[nodiscard]] FrameLog replayUpTo(const FrameLog& log, size_t entries);

}  // namespace cullscope
