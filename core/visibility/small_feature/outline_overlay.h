#pragma once

#include <functional>
#include <vector>

#include "core/frame/frame_log.h"
#include "core/visibility/overlay.h"
#include "core/visibility/show.h"

namespace cullscope::small_feature {

inline constexpr const char* kOutlineShow = "outline";

/// The show of the lines below.
[[nodiscard]] Show outlineShow();

/// A leaf of one of the octrees, as the overlay shows it.
struct OutlineLeaf {
    bool ofOutline = false;
    Box3 box;
};

/// What a recorded frame drew and what it left out for its size, told apart by the octrees: the boxes of the outline's components
/// in the contrasting colour, with wide lines, those of the others in the colours of their verdicts. What is outside the frustum
/// has no box. Above 4000 components a box stands for a leaf. `leafOf`: a leaf by its number in decisions.
[[nodiscard]] std::vector<OverlayLines> outlineOverlay(const OverlayContext& context, const FrameLog& log,
                                                       const std::function<OutlineLeaf(uint32_t)>& leafOf);

}  // namespace cullscope::small_feature
