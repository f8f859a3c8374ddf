#pragma once

#include <vector>

#include "core/frame/frame_log.h"
#include "core/visibility/octree_walk.h"
#include "core/visibility/overlay.h"
#include "core/visibility/show.h"

namespace cullscope::small_feature {

inline constexpr const char* kOutlineShow = "outline";

/// The show of the lines below.
[[nodiscard]] Show outlineShow();

/// What a recorded frame drew and what it left out for its size, told apart by the octrees: the boxes of the outline's components
/// in the contrasting colour, with wide lines, those of the others in the colours of their verdicts. What is outside the frustum
/// has no box. More than 150 boxes of either kind would hide what they are about: of so many components of the outline the
/// largest 150 have theirs, with narrow lines; of the details those that were left out have boxes of the largest nodes, from the
/// third level on, in which nothing was drawn. `small`: octree S, behind which there is no other.
[[nodiscard]] std::vector<OverlayLines> outlineOverlay(const OverlayContext& context, const FrameLog& log,
                                                       const GroupTree& small);

}  // namespace cullscope::small_feature
